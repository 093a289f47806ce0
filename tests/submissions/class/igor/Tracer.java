import java.io.*;
import java.nio.charset.StandardCharsets;
import java.nio.file.*;
import java.util.*;
import java.util.stream.*;

public class Tracer {
  static final class V {
    final double[] a;
    V(double... a) { this.a = a; }
    V plus(V o, double k) { return new V(a[0] + k * o.a[0], a[1] + k * o.a[1], a[2] + k * o.a[2]); }
    V had(V o) { return new V(a[0] * o.a[0], a[1] * o.a[1], a[2] * o.a[2]); }
    V times(double k) { return new V(k * a[0], k * a[1], k * a[2]); }
    double dot(V o) { return a[0] * o.a[0] + a[1] * o.a[1] + a[2] * o.a[2]; }
    V unit() { return times(1 / Math.sqrt(dot(this))); }
    V cross(V o) {
      return new V(a[1] * o.a[2] - a[2] * o.a[1], a[2] * o.a[0] - a[0] * o.a[2], a[0] * o.a[1] - a[1] * o.a[0]);
    }
  }

  static final class Sphere {
    final V c, ka, kd, ks, kr;
    final double r;
    Sphere(double[] n) {
      if (n.length != 16 && n.length != 17) throw new IllegalArgumentException("sphere " + n.length);
      c = part(n, 0);
      r = n[3];
      ka = part(n, 4);
      kd = part(n, 7);
      ks = part(n, 10);
      kr = part(n, 13);
    }
    OptionalDouble hit(V o, V d) {
      V t = c.plus(o, -1);
      double v = t.dot(d), q = r * r - t.plus(d, -v).dot(t.plus(d, -v));
      if (q < 0) return OptionalDouble.empty();
      return DoubleStream.of(v - Math.sqrt(q), v + Math.sqrt(q)).filter(s -> s >= 0).findFirst();
    }
  }

  static V part(double[] n, int k) { return new V(n[k], n[k + 1], n[k + 2]); }

  final List<Sphere> spheres = new ArrayList<>();
  final List<V[]> lights = new ArrayList<>();
  V eye, look, up, ambient = new V(0, 0, 0);
  double d;
  double[] bounds;
  int width, height, level = 0;

  Tracer(String file) throws IOException {
    try (Stream<String> lines = Files.lines(Paths.get(file))) {
      lines.map(String::trim).filter(s -> !s.isEmpty()).forEach(this::line);
    }
  }

  void line(String text) {
    String[] w = text.split("\\s+");
    double[] n = Stream.of(w).skip(1).mapToDouble(Double::parseDouble).toArray();
    switch (w[0]) {
      case "camera" -> {
        eye = part(n, 0);
        look = part(n, 3);
        up = part(n, 6);
        d = n[9];
      }
      case "bounds" -> bounds = n;
      case "res" -> {
        width = (int) n[0];
        height = (int) n[1];
      }
      case "recursionlevel" -> level = (int) n[0];
      case "ambient" -> ambient = part(n, 0);
      case "light" -> lights.add(new V[] {part(n, 0), part(n, 4)});
      case "sphere" -> spheres.add(new Sphere(n));
      default -> throw new IllegalArgumentException(text);
    }
  }

  Sphere seen;
  double at;

  boolean look(V o, V d) {
    seen = null;
    at = Double.POSITIVE_INFINITY;
    for (Sphere s : spheres) {
      double t = s.hit(o, d).orElse(Double.POSITIVE_INFINITY);
      if (t < at) {
        at = t;
        seen = s;
      }
    }
    return seen != null;
  }

  V trace(V o, V d, int depth) {
    if (!look(o, d)) return new V(0, 0, 0);
    Sphere s = seen;
    V q = o.plus(d, at), n = q.plus(s.c, -1).unit(), start = q.plus(n, 1e-6), sum = ambient.had(s.ka);
    for (V[] light : lights) {
      V l = light[0].plus(q, -1).unit();
      double cos = n.dot(l);
      if (cos <= 0 || look(start, l)) continue;
      double rv = Math.max(0, -n.times(2 * cos).plus(l, -1).dot(d));
      sum = sum.plus(s.kd.had(light[1]), cos).plus(s.ks.had(light[1]), Math.pow(rv, 16));
    }
    return depth > 0 ? sum.plus(s.kr.had(trace(start, d.plus(n, -2 * n.dot(d)).unit(), depth - 1)), 1) : sum;
  }

  void write(String file) throws IOException {
    V w = eye.plus(look, -1).unit(), u = up.cross(w).unit(), v = w.cross(u);
    byte[] pixels = new byte[3 * width * height];
    IntStream rows = IntStream.range(0, height);
    rows.forEach(row -> {
      double y = bounds[3] + (bounds[2] - bounds[3]) * row / (height - 1);
      for (int column = 0; column < width; column++) {
        double x = bounds[0] + (bounds[1] - bounds[0]) * column / (width - 1);
        V direction = w.times(d).plus(u, x).plus(v, y).unit();
        V c = trace(eye, direction, level);
        for (int k = 0; k < 3; k++)
          pixels[3 * (row * width + column) + k] = (byte) Math.round(255 * Math.min(1, c.a[k]));
      }
    });
    try (OutputStream out = Files.newOutputStream(Paths.get(file))) {
      out.write(String.format("P6%n%d %d%n255%n", width, height).getBytes(StandardCharsets.US_ASCII));
      out.write(pixels);
    }
  }

  public static void main(String[] args) throws IOException {
    new Tracer(args[0]).write(args[1]);
  }
}
