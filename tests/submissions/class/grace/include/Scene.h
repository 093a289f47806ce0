#ifndef SCENE_H
#define SCENE_H
#include <string>
#include <vector>
#include "Vector.h"

struct Sphere { Vector center; double radius; Vector ka, kd, ks, kr, ko; };
struct Light { Vector position, color; };

class Scene {
 public:
  explicit Scene(const std::string& path);
  Vector shade(const Vector& start, const Vector& dir, int level) const;

  Vector eye, look, up, ambient;
  double d = 0, left = 0, right = 0, bottom = 0, top = 0;
  int width = 0, height = 0, level = 0;

 private:
  bool closest(const Vector& start, const Vector& dir, double& t, int& index) const;
  std::vector<Sphere> spheres_;
  std::vector<Light> lights_;
};
#endif
