#pragma once
#include <cmath>
#include <vector>

template <typename T>
struct Vec3 {
  T x{}, y{}, z{};
  Vec3 operator+(const Vec3& o) const { return {x + o.x, y + o.y, z + o.z}; }
  Vec3 operator-(const Vec3& o) const { return {x - o.x, y - o.y, z - o.z}; }
  Vec3 operator*(const Vec3& o) const { return {x * o.x, y * o.y, z * o.z}; }
  Vec3 operator*(T k) const { return {x * k, y * k, z * k}; }
  T operator%(const Vec3& o) const { return x * o.x + y * o.y + z * o.z; }  // dot
  Vec3 operator^(const Vec3& o) const {                                     // cross
    return {y * o.z - z * o.y, z * o.x - x * o.z, x * o.y - y * o.x};
  }
  T length() const { return std::sqrt(*this % *this); }
  Vec3 unit() const { return *this * (T(1) / length()); }
};
using Vec = Vec3<double>;

struct Ray {
  Vec from, dir;
};

struct Ball {
  Vec at;
  double r;
  Vec ka, kd, ks, kr;
  double hit(const Ray& ray) const {
    Vec t = at - ray.from;
    double v = t % ray.dir, b2 = t % t - v * v;
    if (b2 > r * r) return -1;
    double half = std::sqrt(r * r - b2);
    if (v >= half) return v - half;
    return v + half;
  }
};

struct Bulb {
  Vec at, color;
};
