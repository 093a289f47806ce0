#include "Scene.h"
#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <sstream>

static Vector take(const std::vector<double>& n, size_t at) { return {n.at(at), n.at(at + 1), n.at(at + 2)}; }

Scene::Scene(const std::string& path) {
  std::ifstream in(path);
  std::string line;
  while (std::getline(in, line)) {
    std::stringstream words(line);
    std::string key;
    if (!(words >> key) || key[0] == '#' || key == "model") continue;
    std::vector<double> n;
    for (double x; words >> x;) n.push_back(x);
    if (key == "camera") {
      eye = take(n, 0);
      look = take(n, 3);
      up = take(n, 6);
      d = n.at(9);
    } else if (key == "bounds") {
      left = n.at(0), right = n.at(1), bottom = n.at(2), top = n.at(3);
    } else if (key == "res") {
      width = n.at(0), height = n.at(1);
    } else if (key == "recursionlevel") {
      level = n.at(0);
    } else if (key == "ambient") {
      ambient = take(n, 0);
    } else if (key == "light") {
      lights_.push_back({take(n, 0), take(n, 4)});
      lights_.back().position.normalized();  // must not be the origin
    } else if (key == "sphere") {
      if (n.size() != 19) {
        std::cerr << "sphere: 19 numbers expected" << std::endl;
        std::exit(1);
      }
      spheres_.push_back({take(n, 0), n[3], take(n, 4), take(n, 7), take(n, 10), take(n, 13), take(n, 16)});
    }
  }
  if (lights_.empty()) {
    std::cerr << "No lights, nothing to see." << std::endl;
    std::exit(1);
  }
}

bool Scene::closest(const Vector& start, const Vector& dir, double& t, int& index) const {
  index = -1;
  for (int k = 0; k < (int)spheres_.size(); k++) {
    Vector toCenter = spheres_[k].center - start;
    double v = toCenter.dot(dir);
    double r = spheres_[k].radius;
    double dsq = r * r - (toCenter.dot(toCenter) - v * v);
    if (dsq < 0) continue;
    double d = std::sqrt(dsq);
    double s = v - d >= 0 ? v - d : v + d;
    if (s < 0) continue;
    if (index == -1 || s < t) {
      t = s;
      index = k;
    }
  }
  return index != -1;
}

Vector Scene::shade(const Vector& start, const Vector& dir, int depth) const {
  double t;
  int index;
  if (!closest(start, dir, t, index)) return Vector();
  const Sphere& s = spheres_[index];
  Vector q = start + t * dir;
  Vector n = (q - s.center).normalized();
  Vector outside = q + 1e-6 * n;
  Vector sum = ambient.mult(s.ka);
  for (const Light& light : lights_) {
    Vector l = (light.position - q).normalized();
    double nl = n.dot(l), st;
    int other;
    if (nl < 0) continue;
    if (closest(outside, l, st, other) && st < (light.position - q).length()) continue;
    sum = sum + nl * s.kd.mult(light.color);
    double vr = std::max(0.0, dir.dot(l - 2 * nl * n));
    sum = sum + std::pow(vr, 16) * s.ks.mult(light.color);
  }
  if (depth > 0 && s.kr.length() > 0) {
    Vector r = dir - 2 * dir.dot(n) * n;
    sum = sum + s.kr.mult(shade(outside, r.normalized(), depth - 1));
  }
  return sum;
}
