// A student's finished renderer in C++, correct by default: rt DRIVER IMAGE reads a driver file of
// dialect B and writes a PPM (P3), top line first, with ambient light only. A first line `#define
// MISTAKE u_flipped` adds the mistake of that name; `#define NUMBER float` computes in floats.

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <map>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#ifndef NUMBER
#define NUMBER double
#endif

#ifdef MISTAKE_BY_NAME
#include "by_name.h"
#elif !defined MISTAKE
#define MISTAKE none
#endif

namespace {

#define MISTAKES                                                                                 \
  none, width_height, top_from_right, top_is_minus_bottom, u_flipped, u_and_w_flipped,           \
      no_test_for_t, first_sphere_wins, normalize_discarded, by_discriminant, eye_plus_point,    \
      axes_dropped, float_directions, near_root_only, centre_behind, far_root, upside_down,      \
      mirrored, cancelling, left_and_right_negated, bottom_and_top_negated, symmetric_bounds,    \
      bottom_first, size_exchanged, aspect_twice, shares_of_the_count, plane_at_1, from_the_eye, \
      epsilon, whole_numbers, whole_bounds, one_radius, sorted_once, exits_where_all_is_behind,  \
      lines_for_columns, lines_from_the_last, loops_too_short, whole_view, whole_d,              \
      least_size_wins, largest_distance, crossed_bounds, normalize_discarded_and_upside_down,    \
      steps_of_larger, largest_multiple
enum class Mistake { MISTAKES };

#ifdef MISTAKE_BY_NAME
const auto kMade = static_cast<Mistake>(PLACE_BY_NAME(MISTAKES));
#else
constexpr Mistake kMade = Mistake::MISTAKE;
#endif
bool has(Mistake mistake) {
  if (kMade != Mistake::normalize_discarded_and_upside_down) return mistake == kMade;
  return mistake == Mistake::normalize_discarded || mistake == Mistake::upside_down;
}

using Number = NUMBER;
struct Vector {
  Number x = 0, y = 0, z = 0;
};

Vector operator+(Vector a, Vector b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
Vector operator-(Vector a, Vector b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
Vector operator*(Number k, Vector a) { return {k * a.x, k * a.y, k * a.z}; }
Number dot(Vector a, Vector b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Vector cross(Vector a, Vector b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
Number length(Vector a) { return std::hypot(a.x, a.y, a.z); }
Vector normalize(Vector a) {
  const Number l = length(a);
  return {a.x / l, a.y / l, a.z / l};
}
Vector to_float(Vector a) {
  return {static_cast<float>(a.x), static_cast<float>(a.y), static_cast<float>(a.z)};
}

struct Ray {
  Vector origin, direction;
};
struct Sphere {
  Vector centre;
  Number radius = 0;
  Vector ambient;
};
struct Roots {
  Number smaller, larger;
  Number d_sq;  // the square of half the chord, for unit directions
};

class Camera {
 public:
  void find_axes() {
    w_ = normalize(eye - look);
    if (has(Mistake::u_and_w_flipped)) w_ = normalize(look - eye);
    u_ = normalize(cross(up, w_));
    if (has(Mistake::u_flipped)) u_ = normalize(cross(w_, up));
    // An up vector near W makes U inaccurate.
    v_ = normalize(cross(w_, u_));
    u_ = cross(v_, w_);
    if (has(Mistake::top_from_right)) top = right;
    if (has(Mistake::top_is_minus_bottom)) top = -bottom;
    if (has(Mistake::left_and_right_negated)) left = -left, right = -right;
    if (has(Mistake::bottom_and_top_negated)) bottom = -bottom, top = -top;
    if (has(Mistake::symmetric_bounds)) left = -right, bottom = -top;
    if (has(Mistake::plane_at_1)) near_plane = -1;
    if (has(Mistake::axes_dropped)) u_ = v_ = w_ = {};
  }

  /// The ray from the pixel's point away from the eye; row 0 is the lowest.
  Ray ray(int i, int j) const {
    if (has(Mistake::mirrored)) i = width - 1 - i;
    if (has(Mistake::upside_down)) j = height - 1 - j;
    const int one = has(Mistake::shares_of_the_count) ? 0 : 1;
    Number across = (has(Mistake::width_height) ? height : width) - one;
    Number down = (has(Mistake::width_height) ? width : height) - one;
    if (has(Mistake::steps_of_larger)) across = down = std::max(width, height) - one;
    Number alpha = left + i / across * (right - left);
    if (has(Mistake::aspect_twice)) alpha *= Number(width) / height;
    const Number beta = bottom + j / down * (top - bottom);
    const Vector g = near_plane * w_ + alpha * u_ + beta * v_;
    const Vector point = eye + g;
    if (has(Mistake::normalize_discarded)) {
      const Vector d = point - eye;
      normalize(d);
      return {point, d};
    }
    if (has(Mistake::eye_plus_point)) return {point, normalize(eye + point)};
    if (has(Mistake::from_the_eye)) return {eye, normalize(g)};
    if (has(Mistake::largest_multiple)) return {point, g};
    if (has(Mistake::float_directions)) return {point, to_float(normalize(g))};
    return {point, normalize(g)};
  }

  Vector eye, look, up;
  Number near_plane = 0, left = 0, right = 0, bottom = 0, top = 0;
  int width = 0, height = 0;

 private:
  Vector u_, v_, w_;
};

struct Scene {
  Camera camera;
  Vector ambient;
  std::vector<Sphere> spheres;
};

Scene read(const std::string& path) {
  std::ifstream file(path);
  std::map<std::string, std::vector<Number>> view;
  Scene scene;
  for (std::string line; std::getline(file, line);) {
    std::istringstream words(line.substr(0, line.find('#')));
    std::string keyword;
    if (!(words >> keyword)) continue;
    std::vector<Number> n;
    const bool is_view = keyword == "eye" || keyword == "look" || keyword == "up";
    const bool is_whole = (has(Mistake::whole_numbers) && keyword != "ambient") ||
                          (has(Mistake::whole_bounds) && keyword == "bounds") ||
                          (has(Mistake::whole_view) && is_view) ||
                          (has(Mistake::whole_d) && keyword == "d");
    for (Number x; words >> x;) n.push_back(is_whole && n.size() < 4 ? std::trunc(x) : x);
    if (keyword == "sphere") {
      scene.spheres.push_back({{n.at(0), n.at(1), n.at(2)}, n.at(3), {n.at(4), n.at(5), n.at(6)}});
    } else {
      view[keyword] = n;
    }
  }
  const auto triple = [&](const char* key) {
    const auto& n = view[key];
    return Vector{n.at(0), n.at(1), n.at(2)};
  };
  Camera camera;
  camera.eye = triple("eye");
  camera.look = triple("look");
  camera.up = triple("up");
  camera.near_plane = view["d"].at(0);
  std::vector<Number> b = view["bounds"];
  if (has(Mistake::bottom_first)) std::rotate(b.begin(), b.begin() + 2, b.begin() + 4);
  if (has(Mistake::crossed_bounds)) std::swap(b.at(1), b.at(2));
  camera.left = b.at(0);
  camera.right = b.at(1);
  camera.bottom = b.at(2);
  camera.top = b.at(3);
  camera.width = static_cast<int>(view["res"].at(0));
  camera.height = static_cast<int>(view["res"].at(1));
  if (has(Mistake::size_exchanged)) std::swap(camera.width, camera.height);
  camera.find_axes();
  scene.camera = camera;
  scene.ambient = triple("ambient");
  for (Sphere& sphere : scene.spheres) {
    if (has(Mistake::one_radius)) sphere.radius = scene.spheres.back().radius;
  }
  if (has(Mistake::sorted_once)) {
    const auto distance = [&](const Sphere& s) { return length(s.centre - camera.eye) - s.radius; };
    std::stable_sort(scene.spheres.begin(), scene.spheres.end(),
                     [&](const Sphere& p, const Sphere& q) { return distance(p) < distance(q); });
  }
  return scene;
}

/// a s^2 - 2 b s + c = 0; this discriminant does not cancel on far spheres.
std::optional<Roots> roots(const Ray& ray, const Sphere& sphere) {
  const Vector t = sphere.centre - ray.origin, d = ray.direction;
  const Number r = sphere.radius;
  if (has(Mistake::normalize_discarded) || has(Mistake::cancelling)) {
    // The lecture's formula, for unit directions.
    const Number v = dot(t, d), d_sq = r * r - (dot(t, t) - v * v);
    if (d_sq < 0) return {};
    return Roots{v - std::sqrt(d_sq), v + std::sqrt(d_sq), d_sq};
  }
  const Vector moment = cross(t, d);
  const Number a = dot(d, d), b = dot(t, d);
  const Number discriminant = a * r * r - dot(moment, moment);
  if (discriminant < 0) return {};
  const Number q = b + std::copysign(std::sqrt(discriminant), b);
  const Number c = (length(t) - r) * (length(t) + r);
  const Number one = q / a;
  const Number other = q == 0 ? 0 : c / q;
  return Roots{std::min(one, other), std::max(one, other), discriminant / a};
}

/// The parameter of the hit.
std::optional<Number> intersect(const Roots& found) {
  Number s = found.smaller;
  if (has(Mistake::no_test_for_t) || has(Mistake::least_size_wins)) return s;
  if ((has(Mistake::largest_distance) || has(Mistake::largest_multiple)) && s > 1e5) return {};
  if (has(Mistake::centre_behind) && found.smaller + found.larger < 0) return {};
  if ((s < 0 && !has(Mistake::near_root_only)) || has(Mistake::far_root)) s = found.larger;
  if (s < (has(Mistake::epsilon) ? Number(0.001) : 0)) return {};
  return s;
}

Vector colour(const Scene& scene, const Ray& ray) {
  const Sphere* best = nullptr;
  Number least = 0;
  bool is_behind = false;
  for (const Sphere& sphere : scene.spheres) {
    const auto found = roots(ray, sphere);
    const auto s = found ? intersect(*found) : std::nullopt;
    is_behind = is_behind || (found && found->larger < 0);
    const bool is_first = has(Mistake::first_sphere_wins) || has(Mistake::sorted_once);
    if (!s || (best != nullptr && is_first)) continue;
    const Number key = has(Mistake::by_discriminant)   ? -found->d_sq
                       : has(Mistake::least_size_wins) ? std::abs(*s)
                                                       : *s;
    if (best != nullptr && key >= least) continue;
    best = &sphere;
    least = key;
  }
  if (best == nullptr && is_behind && has(Mistake::exits_where_all_is_behind)) std::exit(3);
  if (best == nullptr) return {};
  return {scene.ambient.x * best->ambient.x, scene.ambient.y * best->ambient.y,
          scene.ambient.z * best->ambient.z};
}

long level(Number share) { return std::lround(255 * std::clamp(share, Number(0), Number(1))); }

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::cerr << "usage: rt DRIVER IMAGE\n";
    return 2;
  }
  const Scene scene = read(argv[1]);
  const Camera& camera = scene.camera;
  std::ofstream image(argv[2]);
  image << "P3\n" << camera.width << " " << camera.height << "\n255\n";
  const bool from_last = has(Mistake::lines_from_the_last);
  const bool exchanged = from_last || has(Mistake::lines_for_columns);
  const int lines = exchanged ? camera.width : camera.height;
  const int values = exchanged ? camera.height : camera.width;
  for (int line = 0; line < lines; ++line) {
    for (int i = 0; i < values; ++i) {
      const bool is_last = line == lines - 1 || i == values - 1;
      const Ray ray = camera.ray(i, (from_last ? lines : camera.height) - 1 - line);
      const Vector c = has(Mistake::loops_too_short) && is_last ? Vector{} : colour(scene, ray);
      image << level(c.x) << " " << level(c.y) << " " << level(c.z) << "\n";
    }
  }
  return image.flush() ? 0 : 1;
}
