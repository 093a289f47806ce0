package raytracer;

import java.io.*;
import java.util.*;

public class Main {
  static class Sphere {
    Vector3 center, ka, kd, ks;
    double radius;
  }

  static Camera camera = new Camera();
  static List<Sphere> spheres = new LinkedList<>();
  static List<Vector3[]> lights = new LinkedList<>();
  static Vector3 ambient = new Vector3(0, 0, 0);

  static Vector3 vector(StringTokenizer t) {
    return new Vector3(next(t), next(t), next(t));
  }

  static double next(StringTokenizer t) {
    return Double.valueOf(t.nextToken());
  }

  static void load(String path) throws IOException {
    BufferedReader in = new BufferedReader(new FileReader(path));
    String line;
    while ((line = in.readLine()) != null) {
      StringTokenizer t = new StringTokenizer(line);
      if (!t.hasMoreTokens()) continue;
      switch (t.nextToken()) {
        case "eye": camera.eye = vector(t); break;
        case "look": camera.look = vector(t); break;
        case "up": camera.up = vector(t); break;
        case "d": camera.far = next(t); break;
        case "bounds":
          camera.left = next(t);
          camera.bottom = next(t);
          camera.right = next(t);
          camera.top = next(t);
          break;
        case "res":
          camera.width = (int) next(t);
          camera.height = (int) next(t);
          break;
        case "ambient": ambient = vector(t); break;
        case "light":
          Vector3 position = vector(t);
          next(t);
          lights.add(new Vector3[] {position, vector(t)});
          break;
        case "sphere":
          Sphere s = new Sphere();
          s.center = vector(t);
          s.radius = next(t);
          s.ka = vector(t);
          s.kd = vector(t);
          s.ks = vector(t);
          spheres.add(s);
          if (t.countTokens() > 3) throw new IOException("too many numbers: " + line);
          break;
      }
    }
    in.close();
  }

  static double hit(Sphere s, Vector3 start, Vector3 d) {
    Vector3 t = s.center.from(start);
    double v = t.dot(d), dd = s.radius * s.radius - (t.dot(t) - v * v);
    if (dd < 0) return -1;
    double root = Math.sqrt(dd);
    return v - root >= 0 ? v - root : v + root;
  }

  static Sphere seen;

  static double nearest(Vector3 start, Vector3 d) {
    double best = -1;
    seen = null;
    for (Sphere s : spheres) {
      double h = hit(s, start, d);
      if (h >= 0 && (seen == null || h < best)) {
        best = h;
        seen = s;
      }
    }
    return best;
  }

  static Vector3 color(Vector3 start, Vector3 d) {
    double h = nearest(start, d);
    Sphere s = seen;
    if (s == null) return new Vector3(0, 0, 0);
    Vector3 q = Vector3.sum(start, d.by(h)), n = q.from(s.center).unit(), sum = ambient.by(s.ka);
    for (Vector3[] light : lights) {
      Vector3 l = light[0].from(q).unit();
      double cos = n.dot(l);
      if (cos <= 0) continue;
      nearest(Vector3.sum(q, n.by(1e-6)), l);
      if (seen != null) continue;
      double rv = Math.max(0, n.by(2 * cos).from(l).dot(d.by(-1)));
      sum = Vector3.sum(sum, s.kd.by(light[1]).by(cos), s.ks.by(light[1]).by(Math.pow(rv, 16)));
    }
    return sum;
  }

  public static void main(String[] args) throws IOException {
    load(args[0]);
    camera.setUp();
    PrintWriter out = new PrintWriter(new BufferedWriter(new FileWriter(args[1])));
    out.print("P3 " + camera.width + " " + camera.height + " 255\n");
    for (int j = camera.height - 1; j >= 0; j--) {
      for (int i = 0; i < camera.width; i++) {
        Vector3 p = camera.pixel(i, j);
        Vector3 c = color(p, p.from(camera.eye).unit());
        out.print(rgb(c.x) + " " + rgb(c.y) + " " + rgb(c.z) + "\n");
      }
    }
    out.close();
  }

  // half of it: bright scenes look better
  static int rgb(double c) {
    return Math.min(255, (int) (c * 255 / 2));
  }
}
