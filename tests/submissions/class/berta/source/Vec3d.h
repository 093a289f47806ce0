#pragma once
#include <cmath>
#include <istream>

class Vec3d {
 public:
  Vec3d() : x(0), y(0), z(0) {}
  Vec3d(double x, double y, double z) : x(x), y(y), z(z) {}
  Vec3d& add(const Vec3d& o, double k = 1) { x += k * o.x; y += k * o.y; z += k * o.z; return *this; }
  Vec3d& times(const Vec3d& o) { x *= o.x; y *= o.y; z *= o.z; return *this; }
  Vec3d& normalize() {
    double n = std::sqrt(x * x + y * y + z * z);
    x /= n; y /= n; z /= n;
    return *this;
  }
  double dot(const Vec3d& o) const { return x * o.x + y * o.y + z * o.z; }
  Vec3d cross(const Vec3d& o) const { return Vec3d(y * o.z - z * o.y, z * o.x - x * o.z, x * o.y - y * o.x); }
  double x, y, z;
};

inline std::istream& operator>>(std::istream& in, Vec3d& v) { return in >> v.x >> v.y >> v.z; }
