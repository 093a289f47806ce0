#include "reference/account/nearby_valid.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "reference/ray_error.h"

namespace raycheck::reference {
namespace {

constexpr int kBits = 256;

/// Where a ray meets a sphere, if this is the same for all inputs of a neighbourhood.
struct Everywhere {
  enum class Meets { kNowhere, kAtOneRoot, kUnknown };
  Meets meets = Meets::kUnknown;
  WhichRoot root = WhichRoot::kSmaller;
  Enclosure s, other_s;  ///< For kAtOneRoot: this root and the other root.
};

/// Balls of the values of a ray and spheres over a neighbourhood.
class Box {
 public:
  Box(const ExactRay& ray, const Neighbourhood& around)
      : ray_(ray.enclose(kBits, around.relative_change)),
        around_(around),
        length_(ray.source().camera ? Enclosure(1) : ray_.length()) {}

  Everywhere meets(const scene::Sphere& sphere) const {
    const auto under_root = ray_.half_chord_sq(sphere).certain_sign();
    if (under_root == -1) return {Everywhere::Meets::kNowhere, {}, {}, {}};
    if (under_root != 1) return {};
    const scene::Culling culling = around_.valid.culling;
    for (const WhichRoot root : {WhichRoot::kSmaller, WhichRoot::kLarger}) {
      const bool is_smaller = root == WhichRoot::kSmaller;
      const bool is_culled = is_smaller ? culling == scene::Culling::kFrontFaces
                                        : culling == scene::Culling::kBackFaces ||
                                              around_.root == scene::Root::kSmaller;
      if (is_culled) continue;
      Enclosure s = ray_.parameter(sphere, {HitClass::kHit, root});
      const std::optional<bool> counts = is_valid(s, sphere);
      if (!counts) return {};
      if (!*counts) continue;
      const WhichRoot other = is_smaller ? WhichRoot::kLarger : WhichRoot::kSmaller;
      return {Everywhere::Meets::kAtOneRoot, root, std::move(s),
              ray_.parameter(sphere, {HitClass::kHit, other})};
    }
    return {Everywhere::Meets::kNowhere, {}, {}, {}};
  }

  bool is_behind(const scene::Sphere& sphere) const {
    return (ray_.axial_distance(sphere) + sqrt(ray_.half_chord_sq(sphere))).certain_sign() == -1;
  }

  /// Whether the roots that count may differ from those >= 0. They do not if all roots are behind
  /// the origin of a ray (not a line), or if all roots lie in front and well inside the interval
  /// and the smaller one is not culled.
  bool ends_matter(const scene::Sphere& sphere) const {
    const Enclosure half_chord_sq = ray_.half_chord_sq(sphere);
    if (half_chord_sq.certain_sign() == -1) return false;
    const Enclosure v = ray_.axial_distance(sphere), half_chord = sqrt(half_chord_sq);
    const Enclosure first = v - half_chord, last = v + half_chord;
    const scene::ValidRoots& valid = around_.valid;
    if (is_behind(sphere)) return std::isinf(valid.t_min);
    const auto above = [&](const Enclosure& distance, double t) {
      return std::isinf(t) ? (t < 0 ? 1 : -1)
                           : (distance - end_at(t, sphere) * length_of_unit()).certain_sign();
    };
    return first.certain_sign() != 1 || above(first, valid.t_min) != 1 ||
           above(last, valid.t_max) != -1 || valid.culling == scene::Culling::kFrontFaces;
  }

 private:
  /// An end of the interval in the unit of s, or in scene lengths if the ends are scene lengths.
  Enclosure end_at(double t, const scene::Sphere& sphere) const {
    const Enclosure end(t, kBits);
    return around_.valid.unit == scene::TUnit::kRadius
               ? end * Enclosure::within(sphere.radius, around_.relative_change, kBits)
               : end;
  }
  /// The length of the unit of end_at() along the ray.
  Enclosure length_of_unit() const {
    return around_.valid.unit == scene::TUnit::kLength ? Enclosure(1) : length_;
  }

  /// Whether a root lies between t_min and t_max; empty if this is not the same everywhere.
  std::optional<bool> is_valid(const Enclosure& s, const scene::Sphere& sphere) const {
    const scene::ValidRoots& valid = around_.valid;
    const auto above = [&](double t) {
      const Enclosure in_unit = valid.unit == scene::TUnit::kLength ? s * length_ : s;
      const auto sign = (in_unit - end_at(t, sphere)).certain_sign();
      return sign == 0 ? std::nullopt : sign;
    };
    const auto above_min = std::isinf(valid.t_min) ? 1 : above(valid.t_min);
    if (!above_min) return {};
    if (*above_min < 0) return false;
    if (std::isinf(valid.t_max)) return true;
    const auto above_max = above(valid.t_max);
    if (!above_max) return {};
    return *above_max < 0;
  }

  EnclosedRay ray_;
  const Neighbourhood& around_;
  Enclosure length_;  ///< The length of the direction of which s is a multiple.
};

using Meets = Everywhere::Meets;

NearbyAnswer refuted_if(bool is_refuted) {
  return {is_refuted ? Nearby::kRefuted : Nearby::kUndecided, {}};
}

bool is_certainly_less(const Enclosure& a, const Enclosure& b) {
  return (b - a).certain_sign() == 1;
}

}  // namespace

NearbyAnswer refuted_nearby(const ExactRay& ray, const scene::Sphere& sphere,
                            const Neighbourhood& around, const std::optional<double>& answer) {
  if (answer && std::isfinite(*answer) && is_outside(around.valid, ray, sphere, *answer)) {
    return refuted_if(true);
  }
  const Everywhere here = Box(ray, around).meets(sphere);
  if (here.meets == Meets::kUnknown) return {};
  if (!answer) return refuted_if(here.meets == Meets::kAtOneRoot);
  if (here.meets == Meets::kNowhere || !std::isfinite(*answer)) return refuted_if(true);
  // Refuted if the answer is at the other root everywhere, as in is_at_other_root().
  const Enclosure from_other = abs(Enclosure(*answer, kBits) - here.other_s);
  return refuted_if(
      is_certainly_less(Enclosure(kOtherRootShare) * from_other, abs(here.s - here.other_s)));
}

NearbyAnswer refuted_nearby(const ExactRay& ray, std::span<const scene::Sphere> spheres,
                            const Neighbourhood& around, const FirstMet& claim) {
  const Box box(ray, around);
  std::vector<Everywhere> all;
  for (const scene::Sphere& sphere : spheres) all.push_back(box.meets(sphere));
  const auto some_are = [&](Meets meets) {
    return std::any_of(all.begin(), all.end(),
                       [meets](const Everywhere& one) { return one.meets == meets; });
  };
  switch (claim.what) {
    case FirstMet::What::kNothing:
      return refuted_if(some_are(Meets::kAtOneRoot));
    case FirstMet::What::kSomething:
      return refuted_if(!some_are(Meets::kAtOneRoot) && !some_are(Meets::kUnknown));
    case FirstMet::What::kSphere:
      break;
  }
  const Everywhere& claimed = all.at(claim.sphere);
  if (claimed.meets != Meets::kAtOneRoot) return refuted_if(claimed.meets == Meets::kNowhere);
  return refuted_if(std::any_of(all.begin(), all.end(), [&](const Everywhere& one) {
    return one.meets == Meets::kAtOneRoot && is_certainly_less(one.s, claimed.s);
  }));
}

bool ends_matter_nearby(const ExactRay& ray, std::span<const scene::Sphere> spheres,
                        const Neighbourhood& around) {
  const Box box(ray, around);
  return std::any_of(spheres.begin(), spheres.end(),
                     [&](const scene::Sphere& sphere) { return box.ends_matter(sphere); });
}

std::optional<ExactRay> reversed_behind(const ExactRay& ray, const scene::Sphere& sphere,
                                        const Neighbourhood& around) {
  const scene::ValidRoots& valid = around.valid;
  const bool all_count =
      std::isinf(valid.t_min) && valid.t_max >= 0 && valid.culling == scene::Culling::kNone;
  if (!all_count || ray.source().camera || !Box(ray, around).is_behind(sphere)) return {};
  const auto& [origin, direction] = ray.source().given;
  return ExactRay(scene::Ray{origin, {-direction.x, -direction.y, -direction.z}});
}

bool is_outside(const scene::ValidRoots& valid, const ExactRay& ray, const scene::Sphere& sphere,
                double s) {
  const auto above = [&](double t) {
    if (std::isinf(t)) return t < 0 ? 1 : -1;
    const bool is_radius = valid.unit == scene::TUnit::kRadius;
    const bool is_length = valid.unit == scene::TUnit::kLength && !ray.source().camera;
    if (!is_radius && !is_length) return s < t ? -1 : s > t ? 1 : 0;
    // The product of two doubles has at most 106 bits, so that a ball of kBits is exact. A length
    // whose ball contains the end is equal to it, since no other length from doubles is that close.
    const Enclosure at = Enclosure(s, kBits), end(t, kBits);
    return (is_length ? at * ray.enclose(kBits).length() - end
                      : at - end * Enclosure(sphere.radius, kBits))
        .certain_sign()
        .value_or(0);
  };
  const int above_min = above(valid.t_min);
  if (above_min < 0 || (above_min == 0 && !valid.includes_min())) return true;
  if (std::isinf(valid.t_max)) return false;
  const int above_max = above(valid.t_max);
  return above_max > 0 || (above_max == 0 && !valid.includes_max());
}

}  // namespace raycheck::reference
