#include "properties/mistakes/imprecision.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "properties/mistakes/mistake_list.h"

namespace raycheck::properties {

PossibleHit possible_hit(Arithmetic arithmetic, const Ray& ray, const Sphere& sphere,
                         const Conventions& conventions) {
  const bool is_expanded =
      arithmetic == Arithmetic::kExpanded || arithmetic == Arithmetic::kSingleExpanded;
  const bool is_single = arithmetic == Arithmetic::kSingle ||
                         arithmetic == Arithmetic::kSingleDifference ||
                         arithmetic == Arithmetic::kSingleExpanded;
  const bool cancels = is_expanded || arithmetic == Arithmetic::kDifference ||
                       arithmetic == Arithmetic::kSingleDifference;
  const double u = is_single ? 0x1p-24 : 0x1p-53;
  const double size = norm(ray.direction);
  const Vector3 D = {ray.direction.x / size, ray.direction.y / size, ray.direction.z / size};
  const Vector3 T = sphere.centre - ray.origin;
  const double r = sphere.radius, t = norm(T);
  const double v = T.x * D.x + T.y * D.y + T.z * D.z;
  // |T x D| and the bound of its error, as for v.
  const double m = norm(cross(T, D));
  const double off = kRoundings * u * (norm(ray.origin) + norm(sphere.centre) + t + r);
  double error = 2 * off * (m + r) + off * off;
  if (cancels) error += kRoundings * u * (t * t + r * r);
  if (is_expanded) {
    const double c = norm(sphere.centre), o = norm(ray.origin);
    error += kRoundings * u * (c * c + o * o);
  }
  const double half_chord_sq = (r - m) * (r + m);
  const double longest = std::sqrt(std::max(0.0, half_chord_sq + error));
  const double shortest = std::sqrt(std::max(0.0, half_chord_sq - error));
  const scene::ValidRoots valid = in_multiples(conventions.valid, ray, sphere);
  const double from = valid.t_min * size, to = valid.t_max * size;
  const auto may = [&](double least, double most) { return most >= from && least <= to; };
  const auto must = [&](double least, double most) { return least >= from && most <= to; };
  const double near_least = v - off - longest, near_most = v + off - shortest;
  const double far_least = v - off + shortest, far_most = v + off + longest;
  PossibleHit hit;
  hit.radii = t / r;
  const bool near_counts = valid.culling != scene::Culling::kFrontFaces;
  const bool far_counts =
      conventions.root == scene::Root::kNearest && valid.culling != scene::Culling::kBackFaces;
  const bool may_be_near = near_counts && may(near_least, near_most);
  const bool may_be_far = far_counts && may(far_least, far_most);
  const bool is_near = near_counts && must(near_least, near_most);
  const bool is_far = far_counts && must(far_least, far_most);
  hit.is_possible = half_chord_sq + error >= 0 && (may_be_near || may_be_far);
  hit.is_certain = half_chord_sq - error > 0 && (is_near || is_far);
  hit.least = std::max(from, may_be_near ? near_least : far_least) / size;
  hit.most = std::min(to, is_near || !may_be_far ? near_most : far_most) / size;
  hit.between = near_most / size;
  hit.and_between = far_least / size;
  return hit;
}

PossibleSight possible_sight(Arithmetic arithmetic, const Ray& ray, std::span<const Sphere> spheres,
                             const Conventions& conventions,
                             const std::optional<std::size_t>& shown) {
  std::vector<PossibleHit> hits;
  double latest = std::numeric_limits<double>::infinity();
  for (const Sphere& sphere : spheres) {
    hits.push_back(possible_hit(arithmetic, ray, sphere, conventions));
    if (hits.back().is_certain) latest = std::min(latest, hits.back().most);
  }
  const bool may_be_none = std::isinf(latest);
  PossibleSight sight;
  int answers = may_be_none ? 1 : 0;
  sight.allows = !shown && may_be_none;
  for (std::size_t k = 0; k < hits.size(); ++k) {
    if (!hits[k].is_possible || hits[k].least > latest) continue;
    ++answers;
    sight.allows = sight.allows || shown == k || shown == kSomeSphere;
    if (hits[k].is_doubtful()) sight.radii = std::max(sight.radii, hits[k].radii);
  }
  sight.is_doubtful = answers > 1;
  return sight;
}

std::string imprecision_sentence(Arithmetic arithmetic, double radii) {
  if (arithmetic == Arithmetic::kSingle) return "computed in single precision";
  if (arithmetic == Arithmetic::kExpanded) {
    return "|C - L|^2 loses its digits far from the world's origin, because larger squares are "
           "subtracted; (C - L) . (C - L) keeps them";
  }
  // The largest power of ten that is at most `radii`.
  const auto power_of_ten = [&] { return static_cast<int>(std::floor(std::log10(radii))); };
  return std::string(arithmetic == Arithmetic::kSingleDifference ? "computed in single precision: "
                                                                 : "") +
         "d^2 loses its digits" + (radii < 10 ? " (near tangents)" : "") +
         ", because it is the difference of much larger numbers; r^2 - |T x D|^2 keeps them" +
         (radii < 10 ? ""
                     : " (the wrong cases examined are at 10^" + std::to_string(power_of_ten()) +
                           " radii or more)");
}

void DoubtTally::add(bool is_wrong, bool is_dropped, bool is_allowed, bool is_doubtful,
                     double its_radii) {
  ++answers;
  doubtful += is_doubtful ? 1 : 0;
  if (!is_wrong) return;
  ++wrong;
  dropped += is_dropped ? 1 : 0;
  not_allowed += is_allowed ? 0 : 1;
  if (is_allowed && its_radii > 0) radii = radii > 0 ? std::min(radii, its_radii) : its_radii;
}

bool DoubtTally::tells() const {
  const auto in_doubt = static_cast<double>(doubtful);
  return allows_all() && wrong - dropped >= kFewestWrongByRoundings && radii > 0 &&
         in_doubt <= kMostInDoubt * static_cast<double>(answers) &&
         static_cast<double>(wrong) >= kFewestWrongInDoubt * in_doubt;
}

}  // namespace raycheck::properties
