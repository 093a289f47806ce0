#include <Eigen/Dense>
#include <cmath>
#include <fstream>
#include <iostream>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

using Eigen::Vector3d;

constexpr double EPSILON = 0.1;  // no acne, please

struct Hit {
  double t;
  Vector3d point, normal;
};

struct Surface {
  Vector3d ka, kd, ks, kr;
  virtual ~Surface() = default;
  virtual std::optional<Hit> hit(const Vector3d& o, const Vector3d& d) const = 0;
};

struct Sphere : Surface {
  Vector3d c;
  double r;
  std::optional<Hit> hit(const Vector3d& o, const Vector3d& d) const override {
    const Vector3d oc = c - o;
    const double v = oc.dot(d);
    const double sq = r * r - (oc.squaredNorm() - v * v);
    if (sq < 0) return std::nullopt;
    double t = v - std::sqrt(sq);
    if (t < 0) t = v + std::sqrt(sq);
    if (t < EPSILON) return std::nullopt;
    const Vector3d p = o + t * d;
    return Hit{t, p, (p - c) / r};
  }
};

struct Light {
  Vector3d p, rgb;
};

std::vector<std::unique_ptr<Surface>> objects;
std::vector<Light> lights;
Vector3d ambient = Vector3d::Zero();

Vector3d shoot(const Vector3d& o, const Vector3d& d, int depth) {
  std::optional<Hit> best;
  const Surface* on = nullptr;
  for (const auto& object : objects)
    if (auto h = object->hit(o, d); h && (!best || h->t < best->t)) best = h, on = object.get();
  if (!best) return Vector3d::Zero();
  Vector3d color = ambient.cwiseProduct(on->ka);
  for (const auto& light : lights) {
    const Vector3d l = (light.p - best->point).normalized();
    const double cosine = best->normal.dot(l);
    bool shadow = false;
    for (const auto& object : objects) shadow = shadow || object->hit(best->point, l);
    if (cosine <= 0 || shadow) continue;
    const Vector3d r = 2 * cosine * best->normal - l;
    color += cosine * on->kd.cwiseProduct(light.rgb);
    color += std::pow(std::max(0.0, -r.dot(d)), 16) * on->ks.cwiseProduct(light.rgb);
  }
  if (depth > 0 && on->kr.sum() > 0) {
    const Vector3d r = d - 2 * d.dot(best->normal) * best->normal;
    color += on->kr.cwiseProduct(shoot(best->point, r, depth - 1));
  }
  return color;
}

Vector3d read3(std::istream& in) {
  Vector3d v;
  in >> v.x() >> v.y() >> v.z();
  return v;
}

int main(int argc, char** argv) {
  if (argc != 3) return 1;
  Vector3d eye, look, up;
  double d, left, right, bottom, top, unused;
  int w, h, depth = 0;
  std::ifstream in(argv[1]);
  for (std::string line; std::getline(in, line);) {
    std::istringstream s(line);
    std::string key;
    s >> key;
    if (key == "camera") eye = read3(s), look = read3(s), up = read3(s), s >> d;
    if (key == "bounds") s >> left >> right >> bottom >> top;
    if (key == "res") s >> w >> h;
    if (key == "recursionlevel") s >> depth;
    if (key == "ambient") ambient = read3(s);
    if (key == "light") {
      Light l;
      l.p = read3(s);
      s >> unused;
      l.rgb = read3(s);
      lights.push_back(l);
    }
    if (key == "sphere") {
      auto b = std::make_unique<Sphere>();
      b->c = read3(s);
      s >> b->r;
      b->ka = read3(s), b->kd = read3(s), b->ks = read3(s), b->kr = read3(s);
      s >> unused;
      if (!s) throw std::runtime_error("sphere line too short");
      objects.push_back(std::move(b));
    }
  }
  const Vector3d W = (eye - look).normalized(), U = up.cross(W).normalized(), V = W.cross(U);
  std::ofstream out(argv[2]);
  out << "P3\n" << w << ' ' << h << "\n255\n";
  for (int y = h - 1; y >= 0; --y)
    for (int x = 0; x < w; ++x) {
      const double a = left + (right - left) * x / (w - 1), b = bottom + (top - bottom) * y / (h - 1);
      const Vector3d p = eye + d * W + a * U + b * V;
      const Vector3d c = shoot(p, (p - eye).normalized(), depth).cwiseMin(1.0) * 255.0;
      out << std::lround(c.x()) << ' ' << std::lround(c.y()) << ' ' << std::lround(c.z()) << '\n';
    }
}
