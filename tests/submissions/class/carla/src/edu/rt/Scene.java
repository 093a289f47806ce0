package edu.rt;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Paths;
import java.util.ArrayList;
import java.util.List;
import linalg.Vec;

public class Scene {
  Vec eye, look, up;
  Vec ambient = new Vec(0, 0, 0);
  double d, left, bottom, right, top;
  int width, height;
  int recursionLevel = -1;
  final List<Sphere> spheres = new ArrayList<>();
  final List<Vec> lightPositions = new ArrayList<>();
  final List<Vec> lightColors = new ArrayList<>();

  Scene(String file) throws IOException {
    for (String line : Files.readAllLines(Paths.get(file))) {
      line = line.trim();
      if (line.isEmpty() || line.startsWith("#")) {
        continue;
      }
      String[] w = line.split("\\s+");
      switch (w[0]) {
        case "eye": eye = Sphere.vec(w, 1); break;
        case "look": look = Sphere.vec(w, 1); break;
        case "up": up = Sphere.vec(w, 1); break;
        case "d": d = Double.parseDouble(w[1]); break;
        case "bounds":
          left = Double.parseDouble(w[1]);
          bottom = Double.parseDouble(w[2]);
          right = Double.parseDouble(w[3]);
          top = Double.parseDouble(w[4]);
          break;
        case "res":
          width = Integer.parseInt(w[1]);
          height = Integer.parseInt(w[2]);
          break;
        case "recursionLevel": recursionLevel = Integer.parseInt(w[1]); break;
        case "ambient": ambient = Sphere.vec(w, 1); break;
        case "light":
          lightPositions.add(Sphere.vec(w, 1));
          lightColors.add(Sphere.vec(w, 5));
          break;
        case "sphere": spheres.add(new Sphere(w)); break;
        case "model": break;
        default: throw new IOException("unknown line: " + line);
      }
    }
    if (recursionLevel < 0) {
      throw new IOException("recursionLevel is missing");
    }
  }

  Sphere hit;
  double distance;

  boolean closest(Vec start, Vec dir) {
    hit = null;
    distance = Double.MAX_VALUE;
    for (Sphere s : spheres) {
      double t = s.intersect(start, dir);
      if (t < distance) {
        distance = t;
        hit = s;
      }
    }
    return hit != null;
  }

  Vec color(Vec start, Vec dir, int level) {
    if (!closest(start, dir)) {
      return new Vec(0, 0, 0);
    }
    Sphere s = hit;
    Vec q = start.plus(dir.times(distance));
    Vec n = q.minus(s.center).times(1 / s.radius);
    Vec sum = ambient.times(s.ka);
    Vec above = q.plus(n.times(1e-7));
    for (int k = 0; k < lightPositions.size(); k++) {
      Vec way = lightPositions.get(k).minus(q);
      Vec l = way.unit();
      double cos = n.dot(l);
      if (cos > 0 && !(closest(above, l) && distance < way.length())) {
        sum = sum.plus(s.kd.times(lightColors.get(k)).times(cos));
        Vec r = n.times(2 * cos).minus(l);
        double shine = Math.max(0, -r.dot(dir));
        sum = sum.plus(s.ks.times(lightColors.get(k)).times(Math.pow(shine, 16)));
      }
    }
    if (level > 0) {
      Vec r = dir.minus(n.times(2 * n.dot(dir)));
      sum = sum.plus(s.kr.times(color(above, r.unit(), level - 1)));
    }
    return sum;
  }
}
