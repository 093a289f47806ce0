package edu.rt;

import java.io.PrintWriter;
import linalg.Vec;

public class Raytracer {
  public static void main(String[] args) throws Exception {
    Scene scene = new Scene(args[0]);
    Vec w = scene.eye.minus(scene.look).unit();
    Vec u = scene.up.cross(w).unit();
    Vec v = w.cross(u);
    try (PrintWriter out = new PrintWriter(args[1])) {
      out.println("P3");
      out.println("# made by Raytracer");
      out.println(scene.width + " " + scene.height);
      out.println(255);
      for (int row = scene.height - 1; row >= 0; row--) {
        StringBuilder line = new StringBuilder();
        for (int col = 0; col < scene.width; col++) {
          double x = scene.left + (scene.right - scene.left) * col / (scene.width - 1);
          double y = scene.bottom + (scene.top - scene.bottom) * row / (scene.height - 1);
          Vec toPixel = u.times(x).plus(v.times(y)).minus(w.times(scene.d));
          Vec c = scene.color(scene.eye.plus(toPixel), toPixel.unit(), scene.recursionLevel);
          line.append(level(c.x)).append(' ').append(level(c.y)).append(' ').append(level(c.z)).append("  ");
        }
        out.println(line);
      }
    }
  }

  static int level(double c) {
    return (int) (255 * Math.min(c, 1));
  }
}
