#include "properties/cases/varied_scene.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#include "properties/cases/generators.h"
#include "properties/cases/random.h"
#include "scene/number.h"

namespace raycheck::properties {
namespace {

/// Positions and sizes on the image plane count as equal if they differ by at most this share of a
/// pixel.
constexpr double kSamePlace = 1e-3;
/// Coordinates that are smaller than this share of a sphere's distance count as rounding errors.
constexpr double kNoLength = 1e-12;

double rounded(double x) { return scene::to_digits(x, kVariedDigits); }

/// A sphere's centre relative to the eye, in coordinates along the axes.
struct Seen {
  double u = 0, v = 0, w = 0;
};

Seen seen_from(const Camera& camera, const Axes& axes, const Sphere& sphere) {
  const Vector3 T = sphere.centre - camera.eye;
  return {dot(T, axes.u), dot(T, axes.v), dot(T, axes.w)};
}

Point3 in_world(const Camera& camera, const Axes& axes, const Seen& at) {
  const auto coordinate = [&](double eye, double u, double v, double w) {
    const double x = u * at.u + v * at.v + w * at.w;
    const double distance = std::abs(at.u) + std::abs(at.v) + std::abs(at.w);
    // Smaller coordinates are only rounding error.
    return std::abs(x) < kNoLength * distance ? eye : rounded(eye + rounded(x));
  };
  return {coordinate(camera.eye.x, axes.u.x, axes.v.x, axes.w.x),
          coordinate(camera.eye.y, axes.u.y, axes.v.y, axes.w.y),
          coordinate(camera.eye.z, axes.u.z, axes.v.z, axes.w.z)};
}

double gap(double low, double high, std::int64_t count) {
  return (high - low) / static_cast<double>(std::max<std::int64_t>(1, count - 1));
}

/// A sphere's position and size on the image plane: where the line through the eye and its centre
/// meets the plane, and its size there. Domain: the centre is not in the eye's plane.
struct OnPlane {
  double alpha = 0, beta = 0, radius = 0;
  OnPlane(const Camera& camera, const Seen& at, double r)
      : alpha(at.u * camera.near / at.w),
        beta(at.v * camera.near / at.w),
        radius(r * std::abs(camera.near / at.w)) {}
};

bool are_same(double a, double b, double pixel) {
  return std::abs(a - b) <= kSamePlace * std::abs(pixel);
}

/// One set of factors for each distinct look (position or size) in a scene.
template <std::size_t Count>
class Factors {
 public:
  /// The factors of the look for which `is_it` holds; if there is none, new factors.
  template <class IsIt>
  const std::array<double, Count>& of(const OnPlane& look, IsIt is_it, Random& random) {
    for (const auto& [known, factors] : all_) {
      if (is_it(known)) return factors;
    }
    std::array<double, Count> drawn{};
    for (double& x : drawn) x = random.between(kLeastVariedFactor, kMostVariedFactor);
    return all_.emplace_back(look, drawn).second;
  }

 private:
  std::vector<std::pair<OnPlane, std::array<double, Count>>> all_;
};

void vary_spheres(Random& random, const Axes& axes, Scene& scene) {
  const Camera& c = *scene.camera;
  const double column = gap(c.left, c.right, c.width), row = gap(c.bottom, c.top, c.height);
  Factors<2> places;
  Factors<1> sizes;
  for (Sphere& sphere : scene.spheres) {
    Seen at = seen_from(c, axes, sphere);
    const OnPlane look(c, at, sphere.radius);
    const auto [across, along] = places.of(
        look,
        [&](const OnPlane& other) {
          return are_same(std::abs(look.alpha), std::abs(other.alpha), column) &&
                 are_same(std::abs(look.beta), std::abs(other.beta), row);
        },
        random);
    const auto [size] = sizes.of(
        look, [&](const OnPlane& other) { return are_same(look.radius, other.radius, column); },
        random);
    at.u *= across;
    at.v *= along;
    sphere = {in_world(c, axes, at), rounded(sphere.radius * size)};
  }
}

void vary_border(Random& random, const Axes& axes, Scene& scene) {
  const Camera& c = *scene.camera;
  if (c.width < 3 || c.height < 3) return;
  /// Moves positions on a border to other pixels. Mirror images move to the same pixel, counted
  /// from either end.
  struct Line {
    double low, high, pixel;
    std::int64_t count;
    std::vector<std::pair<double, std::int64_t>> moved = {};
    bool is_end(double x) const { return are_same(x, low, pixel) || are_same(x, high, pixel); }
    double other(double x, Random& numbers) {
      const double off = x - (low + high) / 2;
      if (are_same(off, 0, pixel)) return x;
      auto known = std::find_if(moved.begin(), moved.end(), [&](const auto& one) {
        return are_same(one.first, std::abs(off), pixel);
      });
      if (known == moved.end()) {
        known = moved.insert(known, {std::abs(off), numbers.integer(1, (count - 1) / 2)});
      }
      const double way = pixel * static_cast<double>(known->second);
      return (off > 0) == (high > low) ? high - way : low + way;
    }
  };
  Line across{c.left, c.right, gap(c.left, c.right, c.width), c.width};
  Line along{c.bottom, c.top, gap(c.bottom, c.top, c.height), c.height};
  for (Sphere& sphere : scene.spheres) {
    Seen at = seen_from(c, axes, sphere);
    const double depth = at.w / c.near;
    if (!(depth > 0)) continue;
    const OnPlane place(c, at, sphere.radius);
    const bool is_at_side = across.is_end(place.alpha);
    if (is_at_side == along.is_end(place.beta)) continue;
    if (is_at_side) {
      at.v = depth * along.other(place.beta, random);
    } else {
      at.u = depth * across.other(place.alpha, random);
    }
    sphere.centre = in_world(c, axes, at);
  }
}

/// What a picture shows, computed in doubles.
struct Shown {
  std::vector<bool> spheres;  ///< Whether each sphere is seen.
  bool is_clear = true;       ///< Every ray is kClearOfEdges from every sphere's edge.
};

/// The distance from the eye at which a ray from the image plane, at distance `plane`, meets a
/// sphere; infinite if it does not.
double met_at(double middle, double half_chord, double plane) {
  if (middle - half_chord >= plane) return middle - half_chord;
  if (middle + half_chord >= plane) return middle + half_chord;
  return std::numeric_limits<double>::infinity();
}

Shown shown_by(const Scene& scene) {
  const Camera& c = *scene.camera;
  const Axes axes(c);
  std::vector<Seen> centres;
  for (const Sphere& sphere : scene.spheres) centres.push_back(seen_from(c, axes, sphere));
  Shown shown{std::vector<bool>(centres.size())};
  const double column = gap(c.left, c.right, c.width), row = gap(c.bottom, c.top, c.height);
  for (std::int64_t j = 0; j < c.height; ++j) {
    for (std::int64_t i = 0; i < c.width; ++i) {
      const Vector3 D = {c.left + column * static_cast<double>(i),
                         c.bottom + row * static_cast<double>(j), c.near};
      const double plane = length(D);
      double least = std::numeric_limits<double>::infinity();
      std::size_t first = centres.size();
      for (std::size_t k = 0; k < centres.size(); ++k) {
        const Vector3 T = {centres[k].u, centres[k].v, centres[k].w};
        const Vector3 moment = cross(T, D);
        const double r = scene.spheres[k].radius;
        const double ratio_sq = dot(moment, moment) / (plane * plane * r * r);
        shown.is_clear = shown.is_clear && std::abs(ratio_sq - 1) >= kClearOfEdges;
        if (!(ratio_sq <= 1)) continue;
        const double at = met_at(dot(T, D) / plane, r * std::sqrt(1 - ratio_sq), plane);
        if (at < least) least = at, first = k;
      }
      if (first < centres.size()) shown.spheres[first] = true;
    }
  }
  return shown;
}

Scene drawn(Random& random, Scene scene, std::span<const Variation> what) {
  const auto varies = [&what](Variation variation) {
    return std::find(what.begin(), what.end(), variation) != what.end();
  };
  const auto exponent = static_cast<int>(random.integer(0, kMostVariedExponent));
  const std::int64_t more = 2 * random.integer(0, kMostVariedPixels / 2);
  const Axes axes(*scene.camera);
  if (varies(Variation::kSpheres)) vary_spheres(random, axes, scene);
  if (varies(Variation::kSize)) {
    scene.camera->width += more;
    scene.camera->height += more;
  }
  if (varies(Variation::kBorder)) vary_border(random, axes, scene);
  if (varies(Variation::kScale)) scale_lengths(scene, exponent);
  return scene;
}

}  // namespace

Scene varied_scene(const Scene& scene, std::span<const Variation> what, std::uint64_t seed) {
  Random random(seed);
  const Shown asked = shown_by(scene);
  for (int draw = 1;; ++draw) {
    Scene result = drawn(random, scene, what);
    if (draw == kMostVariedDraws) return result;
    const Shown shown = shown_by(result);
    if (shown.is_clear && shown.spheres == asked.spheres) return result;
  }
}

}  // namespace raycheck::properties
