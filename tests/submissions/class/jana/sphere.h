#ifndef SPHERE_H
#define SPHERE_H

class Sphere {
 public:
  double x, y, z, radius;
  double distance() const;
};
#endif
