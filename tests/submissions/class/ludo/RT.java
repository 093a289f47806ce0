import java.awt.Color;
import java.io.*;
import java.util.*;

public class RT {
  static class Vec {
    double x, y, z;
    Vec(double x, double y, double z) { this.x = x; this.y = y; this.z = z; }
    Vec(Iterator<Double> n) { this(n.next(), n.next(), n.next()); }
    static Vec sub(Vec a, Vec b) { return new Vec(a.x - b.x, a.y - b.y, a.z - b.z); }
    static Vec add(Vec a, Vec b) { return new Vec(a.x + b.x, a.y + b.y, a.z + b.z); }
    static Vec mul(Vec a, Vec b) { return new Vec(a.x * b.x, a.y * b.y, a.z * b.z); }
    static Vec mul(double k, Vec a) { return new Vec(k * a.x, k * a.y, k * a.z); }
    static double dot(Vec a, Vec b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
    static Vec cross(Vec a, Vec b) {
      return new Vec(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
    }
    static Vec unit(Vec a) { return mul(1 / Math.sqrt(dot(a, a)), a); }
  }

  static class Sphere {
    Vec c, ka, kd, ks;
    double r;
    Sphere(Iterator<Double> n) {
      c = new Vec(n);
      r = n.next();
      ka = new Vec(n);
      kd = new Vec(n);
      ks = new Vec(n);
    }
  }

  Vec eye, look, up, ambient;
  double d, left, right, bottom, top;
  int width, height;
  Vector<Sphere> spheres = new Vector<>();
  Vector<Vec> lightAt = new Vector<>(), lightColor = new Vector<>();

  RT(File file) throws FileNotFoundException {
    Scanner in = new Scanner(file);
    while (in.hasNextLine()) {
      Scanner words = new Scanner(in.nextLine()).useLocale(Locale.ENGLISH);
      if (!words.hasNext()) continue;
      String key = words.next();
      List<Double> list = new ArrayList<>();
      while (words.hasNext()) list.add(Double.valueOf(words.next()));
      Iterator<Double> n = list.iterator();
      if (key.equals("eye")) eye = new Vec(n);
      if (key.equals("look")) look = new Vec(n);
      if (key.equals("up")) up = new Vec(n);
      if (key.equals("ambient")) ambient = new Vec(n);
      if (key.equals("d")) d = n.next();
      if (key.equals("bounds")) {
        left = n.next();
        right = n.next();
        bottom = n.next();
        top = n.next();
      }
      if (key.equals("res")) {
        width = n.next().intValue();
        height = n.next().intValue();
      }
      if (key.equals("sphere")) spheres.add(new Sphere(n));
      if (key.equals("light")) {
        lightAt.add(new Vec(n));
        n.next();
        lightColor.add(new Vec(n));
      }
    }
  }

  Vec shade(Vec start, Vec dir) {
    Sphere hit = null;
    double best = Double.MAX_VALUE;
    for (Sphere s : spheres) {
      Vec t = Vec.sub(s.c, start);
      double v = Vec.dot(t, dir);
      double dsq = s.r * s.r - (Vec.dot(t, t) - v * v);
      if (dsq < 0) continue;
      double where = v - Math.sqrt(dsq);
      if (where < best) {
        best = where;
        hit = s;
      }
    }
    if (hit == null) return new Vec(0, 0, 0);
    Vec q = Vec.add(start, Vec.mul(best, dir)), n = Vec.unit(Vec.sub(q, hit.c));
    Vec sum = Vec.mul(ambient, hit.ka);
    for (int k = 0; k < lightAt.size(); k++) {
      Vec l = Vec.unit(Vec.sub(lightAt.get(k), q));
      double cos = Vec.dot(n, l);
      if (cos <= 0) continue;
      double shine = -Vec.dot(Vec.sub(Vec.mul(2 * cos, n), l), dir);
      sum = Vec.add(sum, Vec.mul(cos, Vec.mul(hit.kd, lightColor.get(k))));
      if (shine > 0) sum = Vec.add(sum, Vec.mul(Math.pow(shine, 16), Vec.mul(hit.ks, lightColor.get(k))));
    }
    return sum;
  }

  Color[][] render() {
    Vec w = Vec.unit(Vec.sub(eye, look)), u = Vec.unit(Vec.cross(up, w)), v = Vec.cross(w, u);
    Color[][] image = new Color[height][width];
    for (int i = 0; i < width; i++) {
      double alpha = left + (right - left) * i / (width - 1);
      for (int j = 0; j < height; j++) {
        double beta = bottom + (top - bottom) * j / (height - 1);
        Vec p = Vec.add(Vec.add(eye, Vec.mul(d, w)), Vec.add(Vec.mul(alpha, u), Vec.mul(beta, v)));
        Vec c = shade(p, Vec.unit(Vec.sub(p, eye)));
        image[j][i] = new Color((float) Math.min(1, c.x), (float) Math.min(1, c.y), (float) Math.min(1, c.z));
      }
    }
    return image;
  }

  public static void main(String[] args) throws IOException {
    Color[][] image = new RT(new File(args[0])).render();
    PrintWriter out = new PrintWriter(args[1]);
    out.println("P3");
    out.println(image[0].length + " " + image.length);
    out.println("255");
    for (Color[] row : image) {
      for (Color c : row) out.print(c.getRed() + " " + c.getGreen() + " " + c.getBlue() + " ");
      out.println();
    }
    out.close();
  }
}
