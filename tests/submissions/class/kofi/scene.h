#pragma once
#include <cmath>
#include <string>
#include <vector>

struct V3 {
  double x, y, z;
  V3(double a = 0, double b = 0, double c = 0) : x(a), y(b), z(c) {}
  V3 operator+(const V3& o) const { return V3(x + o.x, y + o.y, z + o.z); }
  V3 operator-(const V3& o) const { return V3(x - o.x, y - o.y, z - o.z); }
  V3 operator*(const V3& o) const { return V3(x * o.x, y * o.y, z * o.z); }
  V3 operator*(double k) const { return V3(x * k, y * k, z * k); }
};
inline double dot(V3 a, V3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline V3 cross(V3 a, V3 b) {
  return V3(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
}
inline V3 normalize(V3 a) { return a * (1 / std::sqrt(dot(a, a))); }

struct Sphere { V3 c; double r; V3 ka; };

struct Scene {
  V3 eye, look, up, ambient;
  double d, left, right, bottom, top;
  int width, height;
  std::vector<Sphere> spheres;
  bool load(const std::string& file);
};
