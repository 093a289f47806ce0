#include <algorithm>
#include <fstream>
#include "rt.hh"

static World world;

static const Sphere* firstHit(const Vec& o, const Vec& dir, double& best) {
  const Sphere* which = nullptr;
  best = HUGE_VAL;
  for (const Sphere& s : world.spheres) {
    Vec oc = o - s.center;
    double a = dot(dir, dir);
    double b = 2 * dot(oc, dir);
    double c = dot(oc, oc) - s.radius * s.radius;
    double disc = b * b - 4 * a * c;
    if (disc < 0) continue;
    double t = (-b - std::sqrt(disc)) / (2 * a);
    if (t < 0) t = (-b + std::sqrt(disc)) / (2 * a);
    if (t >= 0 && t < best) {
      best = t;
      which = &s;
    }
  }
  return which;
}

static Vec shade(const Vec& o, const Vec& dir, int level) {
  double t, far;
  const Sphere* s = firstHit(o, dir, t);
  if (!s) return {{0, 0, 0}};
  Vec q = o + t * dir, n = unit(q - s->center), off = q + 1e-5 * n;
  Vec c = world.ambient * s->m.ka;
  for (const Light& light : world.lights) {
    Vec l = unit(light.pos - q);
    double nl = dot(n, l);
    if (nl <= 0 || (firstHit(off, l, far) && far < norm(light.pos - q))) continue;
    c = c + nl * (s->m.kd * light.color);
    double rv = std::max(0.0, dot(2 * nl * n - l, -1 * dir));
    c = c + std::pow(rv, 16) * (s->m.ks * light.color);
  }
  if (level > 0 && norm(s->m.kr) > 0) c = c + s->m.kr * shade(off, unit(dir - 2 * dot(dir, n) * n), level - 1);
  return c;
}

int main(int argc, char** argv) {
  if (argc != 3) return 1;
  world = parse(argv[1]);
  Vec w = unit(world.eye - world.look), u = unit(cross(world.up, w)), v = cross(w, u);
  double du = (world.right - world.left) / (world.width - 1);
  double dv = (world.top - world.bottom) / (world.height - 1);
  std::ofstream out(argv[2]);
  out << "P3\n" << world.width << " " << world.height << " 255\n";
  for (int row = 0; row < world.height; row++) {
    for (int col = 0; col < world.width; col++) {
      Vec g = -world.d * w + (world.left + col * du) * u + (world.top - row * dv) * v;
      Vec c = shade(world.eye + g, unit(g), world.recursion);
      for (int k = 0; k < 3; k++) out << std::min(255, (int)(c[k] * 255)) << " ";
    }
    out << std::endl;
  }
}
