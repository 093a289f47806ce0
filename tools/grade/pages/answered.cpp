#include "tools/grade/pages/answered.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "tools/grade/results/result.h"

namespace raycheck::tools {
namespace {

using properties::Candidate;

/// Thrown for questions that were not asked then.
struct NotAsked : std::runtime_error {
  NotAsked() : std::runtime_error("it was not asked") {}
};

/// The hits of the one ray with spheres of the case.
properties::SphereHits hits_of(const FailingCase& failing, const scene::Sphere& sphere) {
  const auto& spheres = failing.the_case.scene.spheres;
  const auto known = std::find(spheres.begin(), spheres.end(), sphere);
  if (known == spheres.end()) throw NotAsked();
  const auto& hits = *failing.answers->hits;
  const auto hit = hits.find(static_cast<std::size_t>(known - spheres.begin()));
  if (hit == hits.end()) return {};
  return {{0, hit->second}};
}

Candidate candidate_that_answered(const FailingCase& failing, const Tolerance& tolerance) {
  const RayAnswers& answers = *failing.answers;
  Candidate candidate;
  candidate.name = kYours;
  candidate.precision = failing.answer.precision;
  candidate.unit_roundoff = scene::unit_roundoff(candidate.precision);
  candidate = tolerated(std::move(candidate), tolerance);
  if (tolerance.ulp) candidate.max_error.fill(*tolerance.ulp);
  if (answers.frame) {
    candidate.frame = [frame = *answers.frame](const scene::Camera&) { return frame; };
  }
  if (answers.pixel_point) {
    candidate.pixel_points = [point = *answers.pixel_point](const auto&, const auto&, const auto&) {
      return std::vector<scene::Point3>{point};
    };
  }
  if (answers.ray) {
    const bool from_pixel = failing.the_case.scene.conventions.origin == scene::Origin::kPixel;
    (from_pixel ? candidate.pixel_rays : candidate.focal_rays) =
        [ray = *answers.ray](const auto&, const auto&, const auto&) {
          return std::vector<scene::Ray>{ray};
        };
  }
  if (answers.hits) {
    candidate.intersect = [failing](const auto&, Candidate::Spheres spheres, const auto&) {
      std::vector<properties::SphereHits> hits;
      for (const scene::Sphere& sphere : spheres) hits.push_back(hits_of(failing, sphere));
      return hits;
    };
  }
  return candidate;
}

}  // namespace

std::shared_ptr<const Implementation> answered(const FailingCase& failing,
                                               const Tolerance& tolerance,
                                               const Layers& isolation) {
  if (!failing.answers) return nullptr;
  return std::make_shared<const Implementation>(Implementation{
      .name = kYours,
      .isolated_by = isolation.text(),
      .precision = failing.answer.precision,
      .make = [candidate = candidate_that_answered(failing, tolerance)] { return candidate; }});
}

}  // namespace raycheck::tools
