#include "tests/mutants/mutants.h"

#include "fast/intersect.h"
#include "properties/mistakes/altered_hits.h"
#include "properties/mistakes/mistakes.h"
#include "tests/properties/cases/drawing.h"

namespace raycheck::mutants {
namespace {

Vector3 turned(const Vector3& D, double angle) {
  const Vector3 any = std::abs(D.x) < std::abs(D.y) ? Vector3{0, D.z, -D.y} : Vector3{-D.z, 0, D.x};
  const double share = angle / std::hypot(any.x, any.y, any.z);
  return {D.x + share * any.x, D.y + share * any.y, D.z + share * any.z};
}

/// Whether the line passes within `band` radii of tangency.
bool is_in_band(const fast::Roots& roots, const Sphere& sphere, double band) {
  return std::abs(roots.half_chord_sq) < 2 * band * sphere.radius * sphere.radius;
}

Hit changed(const Ray& ray, const Sphere& sphere, const Fault& fault, Hit hit) {
  const fast::Roots roots = fast::kCross.roots(ray, sphere);
  if (is_in_band(roots, sphere, fault.band)) {
    const Vector3& d = ray.direction;
    const double middle = roots.axial_distance / std::hypot(d.x, d.y, d.z);
    hit = hit || !(middle >= 0) ? Hit() : properties::hit_at(ray, middle);
  }
  if (!hit || hit->parameter < fault.epsilon) return {};
  hit->parameter *= 1 + fault.s;
  for (double* x : {&hit->point.x, &hit->point.y, &hit->point.z}) *x *= 1 + fault.Q;
  return hit;
}

}  // namespace

Candidate careful_candidate(std::string name, const Fault& fault) {
  Candidate candidate = named(std::move(name));
  for (auto* make : {&candidate.pixel_rays, &candidate.focal_rays}) {
    *make = [base = *make, fault](const auto&... asked) {
      std::vector<Ray> rays = base(asked...);
      for (Ray& ray : rays) ray.direction = turned(ray.direction, fault.D);
      return rays;
    };
  }
  properties::answer_by(candidate,
                        [base = properties::hits_of(unmutated()), fault](
                            Candidate::Rays rays, const Sphere& sphere, const Conventions& asked) {
                          std::vector<Hit> hits = base(rays, sphere, asked);
                          for (std::size_t k = 0; k < hits.size(); ++k) {
                            hits[k] = changed(rays[k], sphere, fault, hits[k]);
                          }
                          return hits;
                        });
  return candidate;
}

Candidate unmutated() { return drawing_candidate(); }

Candidate named(std::string name) {
  Candidate candidate = unmutated();
  candidate.name = std::move(name);
  return candidate;
}

Mutant from_mistake(std::string name, std::string_view sentence,
                    std::vector<std::string_view> caught_by) {
  const properties::Mistake* const mistake = properties::find_mistake(sentence);
  if (mistake == nullptr) {
    throw std::invalid_argument("no mistake is called '" + std::string(sentence) + "'");
  }
  Candidate candidate = named(std::move(name));
  candidate.frame = mistake->candidate.frame;
  candidate.pixel_points = mistake->candidate.pixel_points;
  candidate.pixel_rays = mistake->candidate.pixel_rays;
  candidate.focal_rays = mistake->candidate.focal_rays;
  candidate.intersect = mistake->candidate.intersect;
  candidate.nearest = mistake->candidate.nearest;
  return {mistake->sentence, std::move(caught_by), std::move(candidate)};
}

std::vector<Mutant> all_mutants() {
  return joined({camera_mutants(), intersect_mutants(), plan_mutants(), pick_mutants()});
}

}  // namespace raycheck::mutants
