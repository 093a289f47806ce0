package edu.rt;

import linalg.Vec;

public class Sphere {
  final Vec center;
  final double radius;
  final Vec ka, kd, ks, kr;

  /** Makes a sphere of the words of its line: sphere x y z r Ka Kd Ks Kr Ko eta. */
  Sphere(String[] w) {
    if (w.length != 21) {
      throw new IllegalArgumentException("a sphere needs 20 numbers, not " + (w.length - 1));
    }
    center = vec(w, 1);
    radius = Double.parseDouble(w[4]);
    ka = vec(w, 5);
    kd = vec(w, 8);
    ks = vec(w, 11);
    kr = vec(w, 14);
  }

  static Vec vec(String[] w, int at) {
    return new Vec(Double.parseDouble(w[at]), Double.parseDouble(w[at + 1]), Double.parseDouble(w[at + 2]));
  }

  /** Distance to the first intersection in front of the start of the ray; NaN when there is none. */
  double intersect(Vec start, Vec dir) {
    Vec t = center.minus(start);
    double v = t.dot(dir);
    double dSquared = radius * radius - (t.dot(t) - v * v);
    if (dSquared < 0) {
      return Double.NaN;
    }
    double d = Math.sqrt(dSquared);
    if (v >= d) {
      return v - d;
    }
    return v + d >= 0 ? v + d : Double.NaN;
  }
}
