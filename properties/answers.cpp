#include "properties/answers.h"

#include <string>

#include "scene/validate.h"

namespace raycheck::properties {
namespace {

template <class Given>
void require_count(const Given& answers, std::size_t expected, const char* what) {
  if (answers.size() == expected) return;
  throw CandidateFailed("the candidate returned " + std::to_string(answers.size()) + " " + what +
                        " where " + std::to_string(expected) + " were asked for");
}

/// The valid rays, and their indices among all rays.
struct ValidRays {
  explicit ValidRays(const std::vector<Ray>& all) {
    indices.reserve(all.size());
    for (std::size_t k = 0; k < all.size(); ++k) {
      if (scene::defects(all[k]).empty()) indices.push_back(k);
    }
    rays = all;
    if (indices.size() == all.size()) return;
    for (const std::size_t k : indices) copies.push_back(all[k]);
    rays = copies;
  }
  ValidRays(const ValidRays&) = delete;
  ValidRays& operator=(const ValidRays&) = delete;

  std::vector<std::size_t> indices;
  std::vector<Ray> copies;  ///< Empty if all rays are valid.
  Candidate::Rays rays;
};

void require_in_order(const SphereHits& hits, std::size_t rays) {
  for (std::size_t k = 0; k < hits.size(); ++k) {
    if (hits[k].ray >= rays || (k > 0 && hits[k].ray <= hits[k - 1].ray)) {
      throw CandidateFailed("the candidate returned hits that are not in the order of the rays");
    }
  }
}

}  // namespace

void require_sphere(std::size_t index, std::size_t count) {
  if (index < count) return;
  throw CandidateFailed("it names sphere " + std::to_string(index) + " of " +
                        std::to_string(count) + ", counted from 0");
}

Answers::Answers(const Case& the_case, const Candidate& candidate, double share)
    : case_(the_case),
      candidate_(candidate),
      conventions_(candidate.declared.over(the_case.scene.conventions)),
      share_(share) {}

template <class Given, class Ask>
const Given& Answers::once(Once<Given>& kept, const Ask& ask) const {
  if (kept.failure) std::rethrow_exception(kept.failure);
  if (kept.answers) return *kept.answers;
  if (candidate_.allow) candidate_.allow(share_);
  try {
    return kept.answers.emplace(ask());
  } catch (const NoAnswer&) {
    kept.failure = std::current_exception();
    throw;
  }
}

const FrameAnswer& Answers::frame() {
  return once(frame_, [&] { return candidate_.frame(case_.scene.camera.value()); });
}

const std::vector<Point3>& Answers::pixel_points() {
  return once(pixel_points_, [&] {
    auto points = candidate_.pixel_points(case_.scene.camera.value(), conventions_, case_.pixels);
    require_count(points, ray_count(), "pixel points");
    return points;
  });
}

bool Answers::has_rays() const {
  if (!case_.scene.camera) return true;
  return static_cast<bool>(candidate_.rays_from(conventions_.origin));
}

const std::vector<Ray>& Answers::rays() {
  if (!case_.scene.camera) return case_.scene.rays;
  return once(rays_, [&] {
    if (picks() && !has_rays()) {
      return rounded_rays(ExactCamera(*case_.scene.camera, conventions_), case_.pixels,
                          candidate_.input_format());
    }
    auto made =
        candidate_.rays_from(conventions_.origin)(*case_.scene.camera, conventions_, case_.pixels);
    require_count(made, ray_count(), "rays");
    return made;
  });
}

const SphereHits& Answers::hits(std::size_t sphere) {
  if (picks()) {
    return once(hits_, [&] {
      auto all =
          candidate_.pick(*case_.scene.camera, conventions_, case_.pixels, case_.scene.spheres);
      require_count(all, case_.scene.spheres.size(), "lists of hits");
      for (const SphereHits& hits : all) require_in_order(hits, case_.pixels.size());
      return all;
    })[sphere];
  }
  const std::vector<Ray>& asked = rays();
  return once(hits_, [&] { return intersect(asked, case_.scene.spheres, conventions_); })[sphere];
}

const std::vector<std::optional<std::size_t>>& Answers::nearest() {
  const std::vector<Ray>& asked = rays();
  return once(nearest_, [&] { return rank(asked, case_.scene.spheres); });
}

const std::vector<scene::ScenePlan>& Answers::plans() {
  return once(plans_, [&] {
    std::vector<scene::ScenePlan> plans;
    for (const scene::Wanted wanted : scene::kEveryWanted) {
      plans.push_back(candidate_.plan(case_.scene, conventions_, wanted));
      const std::size_t spheres = plans.back().spheres.size();
      if (spheres != case_.scene.spheres.size()) {
        throw CandidateFailed("the plan has " + std::to_string(spheres) + " spheres, the scene " +
                              std::to_string(case_.scene.spheres.size()));
      }
    }
    return plans;
  });
}

std::vector<SphereHits> Answers::intersect(const std::vector<Ray>& rays,
                                           const std::vector<Sphere>& spheres,
                                           const Conventions& conventions) const {
  const ValidRays valid(rays);
  std::vector<SphereHits> answers = candidate_.intersect(valid.rays, spheres, conventions);
  require_count(answers, spheres.size(), "lists of hits");
  for (SphereHits& hits : answers) {
    require_in_order(hits, valid.rays.size());
    for (RayHit& hit : hits) hit.ray = valid.indices[hit.ray];
  }
  return answers;
}

std::vector<std::optional<std::size_t>> Answers::rank(const std::vector<Ray>& rays,
                                                      const std::vector<Sphere>& spheres) const {
  const ValidRays valid(rays);
  const auto answers = candidate_.nearest(valid.rays, spheres, conventions_);
  require_count(answers, valid.rays.size(), "nearest spheres");
  std::vector<std::optional<std::size_t>> result(rays.size());
  for (std::size_t k = 0; k < answers.size(); ++k) {
    if (answers[k]) require_sphere(*answers[k], spheres.size());
    result[valid.indices[k]] = answers[k];
  }
  return result;
}

Scene Answers::asked_scene() const {
  Scene scene = case_.scene;
  scene.conventions = conventions_;
  if (rays_.answers && rays_.answers->size() == 1 && !picks()) {
    scene.camera.reset();
    scene.rays = *rays_.answers;
  }
  return scene;
}

const HitAnswer* find_hit(const SphereHits& hits, std::size_t ray) {
  const RayHit* found = find_ray(hits, ray);
  return found == nullptr ? nullptr : &found->hit;
}

}  // namespace raycheck::properties
