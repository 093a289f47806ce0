#include "world.hpp"

#include <algorithm>
#include <fstream>
#include <limits>
#include <sstream>
#include <stdexcept>

using namespace m;

static std::istream& operator>>(std::istream& in, vec3& v) { return in >> v.x >> v.y >> v.z; }

World::World(const std::string& driver) {
  std::ifstream file(driver);
  if (!file) throw std::runtime_error("no such file: " + driver);
  for (std::string line; std::getline(file, line);) {
    std::istringstream in(line);
    std::string what;
    in >> what;
    float w;
    if (what == "eye") in >> eye;
    else if (what == "look") in >> look;
    else if (what == "up") in >> up;
    else if (what == "d") in >> d;
    else if (what == "bounds") in >> left >> right >> bottom >> top;
    else if (what == "res") in >> width >> height;
    else if (what == "recursionlevel") in >> depth;
    else if (what == "ambient") in >> ambient;
    else if (what == "light") {
      Lamp lamp;
      in >> lamp.position >> w >> lamp.color;
      lamps.push_back(lamp);
    } else if (what == "sphere") {
      Sphere s;
      in >> s.center >> s.radius >> s.ka >> s.kd >> s.ks >> s.kr >> w;
      if (!in) throw std::runtime_error("spheres have 17 numbers: " + line);
      spheres.push_back(s);
    }
  }
}

const Sphere* World::first(const vec3& origin, const vec3& dir, float& distance) const {
  const Sphere* result = nullptr;
  distance = std::numeric_limits<float>::infinity();
  for (const Sphere& s : spheres) {
    vec3 toCenter = s.center - origin;
    float along = dot(toCenter, dir);
    // the vector from the center to the ray: its square does not cancel as |T|^2 - v^2 does
    vec3 aside = toCenter - along * dir;
    float b = length(aside);
    float square = (s.radius - b) * (s.radius + b);
    if (square < 0) continue;
    float half = std::sqrt(square);
    float hit = along - half;
    if (hit < 0) hit = along + half;
    if (hit >= 0 && hit < distance) {
      distance = hit;
      result = &s;
    }
  }
  return result;
}

vec3 World::radiance(const vec3& origin, const vec3& dir, int level) const {
  float t;
  const Sphere* s = first(origin, dir, t);
  if (!s) return vec3(0.f);
  vec3 q = origin + t * dir;
  vec3 n = normalize(q - s->center);
  if (dot(n, dir) > 0) n = -n;
  vec3 lifted = q + (1e-3f * std::max(1.f, s->radius)) * n;
  vec3 sum = ambient * s->ka;
  for (const Lamp& lamp : lamps) {
    vec3 way = lamp.position - q;
    float far = length(way), t2;
    vec3 l = normalize(way);
    float cosine = dot(n, l);
    if (cosine <= 0 || (first(lifted, l, t2) && t2 < far)) continue;
    sum += cosine * (s->kd * lamp.color);
    sum += std::pow(std::max(0.f, dot(reflect(-l, n), -dir)), 16.f) * (s->ks * lamp.color);
  }
  if (level > 0 && length(s->kr) > 0)
    sum += s->kr * radiance(lifted, normalize(reflect(dir, n)), level - 1);
  return sum;
}
