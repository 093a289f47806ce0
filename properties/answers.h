#pragma once

#include <cstddef>
#include <exception>
#include <optional>
#include <vector>

#include "properties/candidate.h"
#include "properties/case.h"
#include "properties/truth.h"
#include "scene/plan/plan.h"
#include "scene/scene.h"

namespace raycheck::properties {

/// A candidate's answers to a case. Each function is called once, and its answer is kept for the
/// next law. Exceptions of the candidate pass through.
/// Domain: a valid scene, pixels inside its image. The case and the candidate must outlive this
/// object.
class Answers {
 public:
  /// `share` is passed to Functions::allow: the part of the time limit for a reply.
  Answers(const Case& the_case, const Candidate& candidate, double share);

  const Scene& scene() const { return case_.scene; }
  const std::vector<Pixel>& pixels() const { return case_.pixels; }
  std::size_t ray_count() const { return count_rays(case_); }
  const Candidate& candidate() const { return candidate_; }
  /// The scene's conventions, overridden by those that the candidate declares.
  const Conventions& conventions() const { return conventions_; }

  const FrameAnswer& frame();
  const std::vector<Point3>& pixel_points();
  /// The rays of the case: the candidate's own under the origin convention, or the given ones; of a
  /// candidate that only picks, the exact ones, rounded.
  const std::vector<Ray>& rays();
  bool has_rays() const;
  /// Whether its hits are those of pixels, from `pick`.
  bool picks() const { return case_.scene.camera && candidate_.pick; }
  /// Whether the candidate failed to make rays.
  bool lacks_rays() const { return rays_.failure != nullptr; }
  const SphereHits& hits(std::size_t sphere);
  const std::vector<std::optional<std::size_t>>& nearest();
  /// One plan for each element of scene::kEveryWanted, in that order.
  const std::vector<scene::ScenePlan>& plans();
  /// Asks the candidate about other rays or spheres. Rays that are not finite, or have the
  /// direction 0, count as misses, and the candidate does not get them.
  std::vector<SphereHits> intersect(const std::vector<Ray>& rays,
                                    const std::vector<Sphere>& spheres,
                                    const Conventions& conventions) const;
  std::vector<std::optional<std::size_t>> rank(const std::vector<Ray>& rays,
                                               const std::vector<Sphere>& spheres) const;
  /// If the case has a single ray and it was intersected: that ray, as the candidate got it, with
  /// the spheres. Otherwise the scene.
  Scene asked_scene() const;

 private:
  /// A candidate's answers, or its failure, so that it is not called twice.
  template <class Given>
  struct Once {
    std::optional<Given> answers;
    std::exception_ptr failure;
  };
  template <class Given, class Ask>
  const Given& once(Once<Given>& kept, const Ask& ask) const;

  const Case& case_;
  const Candidate& candidate_;
  Conventions conventions_;
  double share_;
  Once<FrameAnswer> frame_;
  Once<std::vector<Point3>> pixel_points_;
  Once<std::vector<Ray>> rays_;
  Once<std::vector<SphereHits>> hits_;
  Once<std::vector<std::optional<std::size_t>>> nearest_;
  Once<std::vector<scene::ScenePlan>> plans_;
};

/// Throws CandidateFailed if index >= count: the candidate names a sphere that does not exist.
void require_sphere(std::size_t index, std::size_t count);

/// The hit of this ray in a list of hits; null if the ray misses.
const HitAnswer* find_hit(const SphereHits& hits, std::size_t ray);

}  // namespace raycheck::properties
