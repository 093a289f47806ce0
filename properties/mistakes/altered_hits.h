#pragma once

// Candidates that choose other roots, hits or spheres than a correct method: the basis of mistakes
// and mutants.

#include <functional>
#include <optional>
#include <vector>

#include "fast/intersect.h"
#include "properties/candidate.h"

namespace raycheck::properties {

using Hit = std::optional<HitAnswer>;
using NearestSpheres = decltype(Candidate::nearest);

/// s, and Q = L + s D.
HitAnswer hit_at(const Ray& ray, double s);

/// Asks about several rays and one sphere; returns one answer per ray.
using AskSphere =
    std::function<std::vector<Hit>(Candidate::Rays, const Sphere&, const Conventions&)>;

/// The answers of a candidate, one sphere at a time.
AskSphere hits_of(const Candidate& candidate);

/// Makes the candidate take its hits from `ask`; its nearest sphere is the one with the smallest s
/// of these hits.
void answer_by(Candidate& candidate, const AskSphere& ask);

using MakeRoots = std::function<fast::Roots(const Ray&, const Sphere&)>;
using ChooseHit = std::function<Hit(const Ray&, const fast::Roots&, const Conventions&)>;

/// Whether a ray's line meets the sphere under the tangent convention.
bool meets(const fast::Roots& roots, const Conventions& conventions);

/// Whether a root counts: it lies between the declared ends, here in multiples of the direction,
/// and on a face that is not culled.
bool smaller_counts(const fast::Roots& roots, const scene::ValidRoots& valid);
bool larger_counts(const fast::Roots& roots, const scene::ValidRoots& valid);

/// The declared ends in multiples of a ray's direction.
scene::ValidRoots in_multiples(scene::ValidRoots valid, const Ray& ray, const Sphere& sphere);

/// The choice of a correct method.
Hit usual_choice(const Ray& ray, const fast::Roots& roots, const Conventions& conventions);

/// Returns the rank of a hit sphere, given its index in the file, the roots and the chosen s.
using RankSphere = std::function<double(std::size_t index, const Ray&, const Sphere&,
                                        const fast::Roots&, double s)>;

/// Wrong formulas for hits and the nearest sphere. An empty one stands for the correct formula,
/// with the roots of `cross`. If there is a `rank`, only the nearest sphere is wrong. The
/// conventions passed to `choose` have their ends in multiples of the direction.
struct HitFormulas {
  MakeRoots roots = {};
  ChooseHit choose = {};
  RankSphere rank = {};
  explicit operator bool() const { return roots || choose || rank; }
};
/// Both sets of formulas; empty if they replace the same formula.
std::optional<HitFormulas> joined(HitFormulas one, const HitFormulas& other);
/// Hits by these formulas. Does not check input.
AskSphere hits_by(HitFormulas formulas);
/// The nearest sphere: of the spheres hit, the one with the least rank; if ranks are equal, the
/// first in the file.
NearestSpheres nearest_by(HitFormulas formulas);

}  // namespace raycheck::properties
