import java.io.BufferedOutputStream;
import java.io.File;
import java.io.FileOutputStream;
import java.io.IOException;
import java.util.ArrayList;
import java.util.Locale;
import java.util.Scanner;

public class RayTracer {
  static double[] eye = new double[3], look = new double[3], up = new double[3], ambient = new double[3];
  static double d, left, right, bottom, top;
  static int width, height, level;
  static ArrayList<double[]> spheres = new ArrayList<>();

  static double[] numbers(Scanner in, int count) {
    double[] n = new double[count];
    for (int k = 0; k < count; k++) n[k] = Double.parseDouble(in.next());
    return n;
  }

  static void read(String name) throws IOException {
    Scanner in = new Scanner(new File(name));
    while (in.hasNext()) {
      String key = in.next();
      if (key.equals("eye")) eye = numbers(in, 3);
      else if (key.equals("look")) look = numbers(in, 3);
      else if (key.equals("up")) up = numbers(in, 3);
      else if (key.equals("d")) d = in.nextDouble();
      else if (key.equals("bounds")) {
        double[] b = numbers(in, 4);
        left = -b[0];
        bottom = b[1];
        right = -b[2];
        top = b[3];
      } else if (key.equals("res")) {
        width = in.nextInt();
        height = in.nextInt();
      } else if (key.equals("recursionLevel")) level = in.nextInt();
      else if (key.equals("ambient")) ambient = numbers(in, 3);
      else if (key.equals("light")) numbers(in, 7);
      else if (key.equals("sphere")) spheres.add(numbers(in, 16));
      else {
        System.out.println("What is " + key + "?");
        System.exit(0);
      }
    }
    in.close();
  }

  static double dot(double[] a, double[] b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  }

  static double[] minus(double[] a, double[] b) {
    return new double[] {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
  }

  static double[] along(double[] a, double t, double[] b) {
    return new double[] {a[0] + t * b[0], a[1] + t * b[1], a[2] + t * b[2]};
  }

  static double[] cross(double[] a, double[] b) {
    return new double[] {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  }

  static double[] normal(double[] a) {
    double n = Math.sqrt(dot(a, a));
    return new double[] {a[0] / n, a[1] / n, a[2] / n};
  }

  static double[] firstSphere(double[] p, double[] dir) {
    double[] found = null;
    double best = Double.POSITIVE_INFINITY;
    for (double[] s : spheres) {
      double[] t = minus(s, p);
      double v = dot(t, dir);
      double disc = s[3] * s[3] - (dot(t, t) - v * v);
      if (disc < 0) continue;
      double root = Math.sqrt(disc);
      double hit = v - root < 0 ? v + root : v - root;
      if (hit >= 0 && hit < best) {
        best = hit;
        found = s;
      }
    }
    return found;
  }

  static double[] shade(double[] p, double[] dir) {
    double[] color = new double[3];
    double[] s = firstSphere(p, dir);
    for (int c = 0; s != null && c < 3; c++) color[c] = ambient[c] * s[4 + c];
    return color;
  }

  public static void main(String[] args) throws IOException {
    Locale.setDefault(Locale.US);
    read(args[0]);
    double[] w = normal(minus(eye, look)), u = normal(cross(up, w)), v = cross(w, u);
    byte[] bytes = new byte[3 * width * height];
    for (int i = 0; i < width; i++) {
      for (int j = 0; j < height; j++) {
        double x = left + (right - left) * i / (width - 1);
        double y = top - (top - bottom) * j / (height - 1);
        double[] p = along(along(along(eye, -d, w), x, u), y, v);
        double[] c = shade(p, normal(minus(p, eye)));
        for (int k = 0; k < 3; k++)
          bytes[3 * (j * width + i) + k] = (byte) Math.min(255, (int) (c[k] * 255));
      }
    }
    BufferedOutputStream out = new BufferedOutputStream(new FileOutputStream(args[1]));
    out.write(("P6 " + width + " " + height + " 255\n").getBytes());
    out.write(bytes);
    out.close();
  }
}
