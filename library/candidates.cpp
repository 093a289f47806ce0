#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "fast/method_list.h"
#include "library/conversions.h"
#include "properties/candidates/fast_candidate.h"

namespace raycheck::library {
namespace {

using Pixels = properties::Candidate::Pixels;
using Rays = properties::Candidate::Rays;
using Spheres = properties::Candidate::Spheres;

scene::UnitVector3 unit(const Vector& v) { return {v.x, v.y, v.z}; }

/// Calls a function that makes one ray, for each pixel.
template <class Function>
auto for_each_pixel(const Function& function) {
  return [&function](const scene::Camera& asked, const scene::Conventions& by, Pixels pixels) {
    const Camera seen = camera(asked);
    const Conventions agreed = conventions(by);
    std::vector<scene::Ray> rays;
    for (const scene::Pixel& one : pixels) rays.push_back(ray(function(seen, agreed, pixel(one))));
    return rays;
  };
}

void add_cameras(const Candidate& from, properties::Candidate& to) {
  if (from.frame) {
    to.frame = [&from](const scene::Camera& asked) {
      const Frame axes = from.frame(camera(asked));
      return properties::FrameAnswer{unit(axes.u), unit(axes.v), unit(axes.w)};
    };
  }
  if (from.pixel_point) {
    to.pixel_points = [&from](const scene::Camera& asked, const scene::Conventions& by,
                              Pixels pixels) {
      const Camera seen = camera(asked);
      const Conventions agreed = conventions(by);
      std::vector<scene::Point3> points;
      for (const scene::Pixel& one : pixels) {
        points.push_back(point(from.pixel_point(seen, agreed, pixel(one))));
      }
      return points;
    };
  }
  if (from.pixel_ray) to.pixel_rays = for_each_pixel(from.pixel_ray);
  if (from.focal_ray) to.focal_rays = for_each_pixel(from.focal_ray);
}

void add_intersections(const Candidate& from, properties::Candidate& to) {
  if (from.intersect) {
    to.intersect = [&from](Rays rays, Spheres spheres, const scene::Conventions& by) {
      const Conventions agreed = conventions(by);
      std::vector<properties::SphereHits> all;
      for (const scene::Sphere& one : spheres) {
        properties::SphereHits& hits = all.emplace_back();
        for (std::size_t k = 0; k < rays.size(); ++k) {
          const auto hit = from.intersect(ray(rays[k]), sphere(one), agreed);
          if (hit) hits.push_back({k, {hit->parameter, point(hit->point)}});
        }
      }
      return all;
    };
  }
  if (from.nearest) {
    to.nearest = [&from](Rays rays, Spheres spheres, const scene::Conventions& by) {
      const Conventions agreed = conventions(by);
      const std::vector<Sphere> list = library::spheres(spheres);
      std::vector<std::optional<std::size_t>> all;
      for (const scene::Ray& one : rays) {
        const auto index = from.nearest(ray(one), list, agreed);
        if (index && *index >= list.size()) {
          throw std::runtime_error(
              fmt::format("nearest: returned sphere {} of a list of {}", *index, list.size()));
        }
        all.push_back(index);
      }
      return all;
    };
  }
}

void require_valid(const Candidate& candidate) {
  const bool has_any = candidate.frame || candidate.pixel_point || candidate.pixel_ray ||
                       candidate.focal_ray || candidate.intersect || candidate.nearest;
  if (!has_any) {
    throw std::invalid_argument(fmt::format(
        "candidate {}: it has no functions, so there is nothing to judge", candidate.name));
  }
  require_one_of(static_cast<int>(candidate.returns), properties::kReturnsNames.size(), "returns");
  require_one_of(static_cast<int>(candidate.precision), 2, "precision");
  require_one_of(static_cast<int>(candidate.directions), 2, "directions");
  require_one_of(static_cast<int>(candidate.roots), 3, "roots");
  const double smallest = candidate.smallest_length, largest = candidate.largest_length;
  if (!(smallest >= 0) || !std::isfinite(smallest)) {
    throw std::invalid_argument(
        fmt::format("smallest_length = {}: must be 0 or more, and finite", smallest));
  }
  if (!(largest >= 0) || (largest > 0 && largest < smallest)) {
    throw std::invalid_argument(fmt::format(
        "largest_length = {}: must be 0, or at least smallest_length = {}", largest, smallest));
  }
}

}  // namespace

properties::Candidate inside(const Candidate& candidate) {
  require_valid(candidate);
  const properties::Candidate bounds = properties::fast_candidate(fast::kDirectRays, fast::kCross);
  properties::Candidate inside;
  inside.name = candidate.name;
  inside.declared = declared(candidate.declares);
  if (candidate.roots == Roots::usual) inside.declared.valid = scene::ValidRoots{};
  if (candidate.roots == Roots::declared) {
    inside.declared.valid = valid_roots(candidate.declares.valid);
  }
  inside.refuses = false;
  inside.level = level(candidate.level).value_or(properties::Level::kOrdinary);
  inside.max_error = bounds.max_error;
  inside.max_error_end_to_end = bounds.max_error_end_to_end;
  inside.unit_roundoff = bounds.unit_roundoff;
  inside.smallest_length = std::max(properties::kSmallestJudgedLength, candidate.smallest_length);
  inside.smallest_camera_length = inside.smallest_length;
  if (candidate.largest_length > 0) inside.largest_length = candidate.largest_length;
  add_cameras(candidate, inside);
  add_intersections(candidate, inside);
  inside.unit_directions = candidate.directions == Directions::unit;
  inside.returns = static_cast<properties::Returns>(candidate.returns);
  static_cast<properties::Functions&>(inside) = properties::completed(inside, inside.returns);
  return judged_in(precision(candidate.precision), std::move(inside));
}

}  // namespace raycheck::library
