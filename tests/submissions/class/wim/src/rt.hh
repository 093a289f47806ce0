#pragma once
#include <cmath>
#include <string>
#include <vector>

struct Vec {
  double v[3];
  double& operator[](int k) { return v[k]; }
  double operator[](int k) const { return v[k]; }
};

inline Vec operator+(Vec a, const Vec& b) { for (int k = 0; k < 3; k++) a[k] += b[k]; return a; }
inline Vec operator-(Vec a, const Vec& b) { for (int k = 0; k < 3; k++) a[k] -= b[k]; return a; }
inline Vec operator*(Vec a, const Vec& b) { for (int k = 0; k < 3; k++) a[k] *= b[k]; return a; }
inline Vec operator*(double t, Vec a) { for (int k = 0; k < 3; k++) a[k] *= t; return a; }
inline double dot(const Vec& a, const Vec& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline double norm(const Vec& a) { return std::sqrt(dot(a, a)); }
inline Vec unit(const Vec& a) { return 1 / norm(a) * a; }
inline Vec cross(const Vec& a, const Vec& b) {
  return {{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]}};
}

struct Material { Vec ka, kd, ks, kr; };
struct Sphere { Vec center; double radius; Material m; };
struct Light { Vec pos, color; };

struct World {
  Vec eye, look, up, ambient;
  double d, left, bottom, right, top;
  int width, height, recursion;
  std::vector<Sphere> spheres;
  std::vector<Light> lights;
};

World parse(const std::string& path);
