#include <fmt/core.h>
#include <raycheck/candidate.h>

#include <cstdint>
#include <memory>
#include <stdexcept>
#include <utility>

#include "contract/public_structs.h"
#include "fast/method_list.h"
#include "library/conversions.h"
#include "properties/candidates/fast_candidate.h"
#include "properties/interfaces.h"
#include "scene/validate.h"

namespace raycheck::library {
namespace {

using Pixels = properties::Candidate::Pixels;
using Rays = properties::Candidate::Rays;
using Spheres = properties::Candidate::Spheres;

/// Of the public headers, with all of today's declarations.
constexpr std::uint32_t kVersion = RAYCHECK_CANDIDATE_VERSION;

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

void add_batch(const IntersectBatch& from, properties::Candidate& to) {
  to.intersect = [&from](Rays rays, Spheres spheres, const scene::Conventions& /*by*/) {
    std::vector<Ray> seen;
    for (const scene::Ray& one : rays) seen.push_back(ray(one));
    std::vector<Hit> found(rays.size());
    const auto is_hit = std::make_unique<bool[]>(rays.size());
    std::vector<properties::SphereHits> all;
    for (const scene::Sphere& one : spheres) {
      properties::SphereHits& hits = all.emplace_back();
      from(seen.data(), seen.size(), sphere(one), found.data(), is_hit.get());
      for (std::size_t k = 0; k < found.size(); ++k) {
        if (is_hit[k]) hits.push_back({k, {found[k].parameter, point(found[k].point)}});
      }
    }
    return all;
  };
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

}  // namespace

properties::Candidate inside(const Candidate& candidate, const IntersectBatch* batch) {
  const bool has_any = candidate.frame || candidate.pixel_point || candidate.pixel_ray ||
                       candidate.focal_ray || candidate.intersect || candidate.nearest;
  if (!has_any) {
    throw std::invalid_argument(fmt::format(
        "candidate {}: it has no functions, so there is nothing to judge", candidate.name));
  }
  const contract::Declarations declared =
      contract::declarations(candidate, candidate.declares, candidate.declares.valid, kVersion);
  if (const auto wrong = contract::defects(declared); !wrong.empty()) {
    throw std::invalid_argument(scene::sentences(wrong));
  }
  properties::Candidate inside = properties::declaring(
      declared, candidate.name, properties::fast_candidate(fast::kDirectRays, fast::kCross));
  add_cameras(candidate, inside);
  add_intersections(candidate, inside);
  if (batch != nullptr) add_batch(*batch, inside);
  static_cast<properties::Functions&>(inside) =
      properties::adapted(inside, declared.interface, declared.precision);
  return judged_in(declared.precision, std::move(inside));
}

}  // namespace raycheck::library
