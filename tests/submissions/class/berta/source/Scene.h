#pragma once
#include <string>
#include <vector>
#include "Vec3d.h"

struct Ball {
  Vec3d center, ka, kd, ks;
  double radius;
  // true if the ray meets the ball in front of its start; then t is where
  bool meets(const Vec3d& start, const Vec3d& dir, double& t) const;
};

struct Bulb {
  Vec3d position, color;
};

class Scene {
 public:
  bool read(const std::string& name);
  Vec3d color(const Vec3d& start, const Vec3d& dir) const;

  Vec3d eye, look, up, ambient;
  double d, bounds[4];
  int res[2];
  std::vector<Ball> balls;
  std::vector<Bulb> bulbs;
};
