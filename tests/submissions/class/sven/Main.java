import java.awt.image.BufferedImage;
import java.io.*;
import java.nio.file.*;
import java.util.*;

public class Main {
  static List<Ball> balls = new ArrayList<>();
  static List<Vec[]> lights = new ArrayList<>();
  static Map<String, double[]> settings = new HashMap<>();

  static Vec v(double[] n, int k) { return new Vec(n[k], n[k + 1], n[k + 2]); }

  static Ball best;
  static double bestT;

  static void closest(Vec o, Vec d) {
    best = null;
    for (Ball b : balls) {
      double t = b.hit(o, d);
      if (t >= 0 && (best == null || t < bestT)) {
        bestT = t;
        best = b;
      }
    }
  }

  static Vec trace(Vec o, Vec d, int depth) {
    closest(o, d);
    if (best == null) return new Vec(0, 0, 0);
    Ball b = best;
    Vec p = o.add(d.mul(bestT)), n = p.sub(b.center()).norm();
    Vec c = v(settings.get("ambient"), 0).mul(b.ka());
    for (Vec[] light : lights) {
      Vec l = light[0].sub(p).norm();
      double nl = n.dot(l);
      if (nl <= 0) continue;
      closest(p, l);
      if (best != null) continue;
      Vec r = n.mul(2 * nl).sub(l);
      c = c.add(b.kd().mul(light[1]).mul(nl));
      c = c.add(b.ks().mul(light[1]).mul(Math.pow(Math.max(0, -r.dot(d)), 16)));
    }
    if (depth > 0) c = c.add(b.kr().mul(trace(p, d.sub(n.mul(2 * n.dot(d))), depth - 1)));
    return c;
  }

  static int bits(double c) { return (int) Math.round(255 * Math.max(0, Math.min(1, c))); }

  public static void main(String[] args) throws IOException {
    for (String line : Files.readAllLines(Path.of(args[0]))) {
      String[] words = line.strip().split(" +");
      if (words[0].isEmpty() || words[0].equals("model")) continue;
      double[] n = Arrays.stream(words).skip(1).mapToDouble(Double::parseDouble).toArray();
      if (words[0].equals("sphere")) {
        if (n.length != 20) throw new IOException("not a sphere: " + line);
        balls.add(new Ball(v(n, 0), n[3], v(n, 4), v(n, 7), v(n, 10), v(n, 13)));
      } else if (words[0].equals("light")) {
        lights.add(new Vec[] {v(n, 0), v(n, 4)});
      } else {
        settings.put(words[0], n);
      }
    }
    double[] cam = settings.get("camera"), b = settings.get("bounds"), res = settings.get("res");
    Vec eye = v(cam, 0), w = eye.sub(v(cam, 3)).norm(), u = v(cam, 6).cross(w).norm(), up = w.cross(u);
    int width = (int) res[0], height = (int) res[1], depth = (int) settings.get("recursionlevel")[0];
    BufferedImage image = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
    for (int x = 0; x < width; x++) {
      for (int y = 0; y < height; y++) {
        double px = b[0] + (b[1] - b[0]) * x / (width - 1.0);
        double py = b[2] + (b[3] - b[2]) * (height - 1 - y) / (height - 1.0);
        Vec g = w.mul(cam[9]).add(u.mul(px)).add(up.mul(py));
        Vec c = trace(eye.add(g), g.norm(), depth);
        image.setRGB(x, y, bits(c.x()) << 16 | bits(c.y()) << 8 | bits(c.z()));
      }
    }
    try (PrintStream out = new PrintStream(args[1])) {
      out.printf("P3%n%d %d%n255%n", width, height);
      for (int y = 0; y < height; y++) {
        for (int x = 0; x < width; x++) {
          int rgb = image.getRGB(x, y);
          out.printf("%d %d %d ", rgb >> 16 & 255, rgb >> 8 & 255, rgb & 255);
        }
        out.println();
      }
    }
  }
}
