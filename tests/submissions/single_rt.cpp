// A student's finished renderer in C++, all in `float`, right as it stands: rt DRIVER IMAGE reads a
// driver file of dialect B and writes a PPM (P3). A first line `#define FORM lecture` takes the
// lecture's d^2 = r^2 - (|T|^2 - v^2), which cancels.

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iostream>
#include <map>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#ifdef MISTAKE_BY_NAME
#include "by_name.h"
#elif !defined FORM
#define FORM careful
#endif

namespace {

enum class Form { careful, lecture };
#ifdef MISTAKE_BY_NAME
const Form kForm = static_cast<Form>(PLACE_BY_NAME(careful, lecture));
#else
constexpr Form kForm = Form::FORM;
#endif

struct Vec {
  float x = 0, y = 0, z = 0;
};

Vec operator+(Vec a, Vec b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
Vec operator-(Vec a, Vec b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
Vec operator*(float k, Vec a) { return {k * a.x, k * a.y, k * a.z}; }
float dot(Vec a, Vec b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Vec cross(Vec a, Vec b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
float length(Vec a) { return std::sqrt(dot(a, a)); }
Vec normalize(Vec a) { return 1 / length(a) * a; }

struct Sphere {
  Vec centre;
  float radius = 0;
  Vec colour;
};

struct Scene {
  std::map<std::string, std::vector<float>> view;
  std::vector<Sphere> spheres;

  Vec triple(const std::string& key) const {
    const auto& n = view.at(key);
    return {n.at(0), n.at(1), n.at(2)};
  }
};

Scene read(const std::string& path) {
  std::ifstream file(path);
  Scene scene;
  for (std::string line; std::getline(file, line);) {
    std::istringstream words(line.substr(0, line.find('#')));
    std::string keyword;
    if (!(words >> keyword)) continue;
    std::vector<float> n;
    for (float x; words >> x;) n.push_back(x);
    if (keyword == "sphere") {
      scene.spheres.push_back({{n.at(0), n.at(1), n.at(2)}, n.at(3), {n.at(4), n.at(5), n.at(6)}});
    } else {
      scene.view[keyword] = n;
    }
  }
  return scene;
}

struct Roots {
  float smaller, larger;
};

std::optional<Roots> lecture_roots(Vec t, Vec d, float r) {
  const float v = dot(t, d);
  const float d_sq = r * r - (dot(t, t) - v * v);
  if (d_sq < 0) return {};
  return Roots{v - std::sqrt(d_sq), v + std::sqrt(d_sq)};
}

/// |T x D|^2 does not cancel where d^2 would.
std::optional<Roots> careful_roots(Vec t, Vec d, float r) {
  const Vec moment = cross(t, d);
  const float a = dot(d, d);
  const float b = dot(t, d);
  const float discriminant = a * r * r - dot(moment, moment);
  if (discriminant < 0) return {};
  const float q = b + std::copysign(std::sqrt(discriminant), b);
  const float other = q == 0 ? 0 : (length(t) - r) * (length(t) + r) / q;
  return Roots{std::min(q / a, other), std::max(q / a, other)};
}

Vec colour(const Scene& scene, Vec origin, Vec d) {
  const Sphere* best = nullptr;
  float least = 0;
  for (const Sphere& sphere : scene.spheres) {
    const Vec t = sphere.centre - origin;
    const auto roots = kForm == Form::lecture ? lecture_roots(t, d, sphere.radius)
                                              : careful_roots(t, d, sphere.radius);
    if (!roots) continue;
    const float s = roots->smaller < 0 ? roots->larger : roots->smaller;
    if (s < 0 || (best != nullptr && s >= least)) continue;
    best = &sphere;
    least = s;
  }
  return best == nullptr ? Vec{} : best->colour;
}

long level(float share) { return std::lround(255 * std::clamp(share, 0.0f, 1.0f)); }

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  const Scene scene = read(argv[1]);
  const Vec eye = scene.triple("eye");
  const Vec w = normalize(eye - scene.triple("look"));
  const Vec u = normalize(cross(scene.triple("up"), w));
  const Vec v = cross(w, u);
  const float near_plane = scene.view.at("d").at(0);
  const std::vector<float>& bounds = scene.view.at("bounds");
  const int width = static_cast<int>(scene.view.at("res").at(0));
  const int height = static_cast<int>(scene.view.at("res").at(1));
  std::ofstream image(argv[2]);
  image << "P3\n" << width << " " << height << "\n255\n";
  for (int j = height - 1; j >= 0; --j) {
    for (int i = 0; i < width; ++i) {
      const float across = static_cast<float>(i) / static_cast<float>(width - 1);
      const float up = static_cast<float>(j) / static_cast<float>(height - 1);
      const float alpha = bounds.at(0) + across * (bounds.at(1) - bounds.at(0));
      const float beta = bounds.at(2) + up * (bounds.at(3) - bounds.at(2));
      const Vec g = near_plane * w + alpha * u + beta * v;
      const Vec c = colour(scene, eye + g, normalize(g));
      image << level(c.x) << " " << level(c.y) << " " << level(c.z) << "\n";
    }
  }
  return image.flush() ? 0 : 1;
}
