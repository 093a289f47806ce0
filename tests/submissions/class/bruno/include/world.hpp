#pragma once
#include <string>
#include <vector>
#include "vec.hpp"

struct Sphere {
  m::vec3 center;
  float radius;
  m::vec3 ka, kd, ks, kr;
};

struct Lamp {
  m::vec3 position, color;
};

struct World {
  m::vec3 eye, look, up, ambient;
  float d = -1, left = -1, right = 1, bottom = -1, top = 1;
  int width = 0, height = 0, depth = 0;
  std::vector<Sphere> spheres;
  std::vector<Lamp> lamps;

  explicit World(const std::string& driver);
  // the sphere that the ray meets first and how far away, or null
  const Sphere* first(const m::vec3& origin, const m::vec3& dir, float& distance) const;
  m::vec3 radiance(const m::vec3& origin, const m::vec3& dir, int level) const;
};
