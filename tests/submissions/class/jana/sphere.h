#ifndef SPHERE_H
#define SPHERE_H

struct Vec {
  double x, y, z;
  Vec operator+(const Vec& o) const;
  Vec operator-(const Vec& o) const;
  Vec scale(double k) const;
  double dot(const Vec& o) const;
  Vec cross(const Vec& o) const;
  Vec unit() const;
};

class Sphere {
 public:
  Vec center, ka, kd, ks;
  double radius;
  bool hit(const Vec& from, const Vec& dir, double& s) const;
};
#endif
