#pragma once

// How a candidate answers rays that has a choice of its own among roots, hits or spheres: what
// mistakes and mutants are made of.

#include <functional>
#include <optional>
#include <vector>

#include "fast/intersect.h"
#include "properties/candidate.h"

namespace raycheck::properties {

using Hit = std::optional<HitAnswer>;
using NearestSpheres = decltype(Candidate::nearest);

/// s, and Q = L + s D.
HitAnswer hit_at(const scene::Ray& ray, double s);

/// One sphere at a time, an answer a ray.
using AskSphere = std::function<std::vector<Hit>(Candidate::Rays, const scene::Sphere&,
                                                 const scene::Conventions&)>;

/// The answers of a candidate, one sphere at a time.
AskSphere hits_of(const Candidate& candidate);

/// The hits by `ask`, and the nearest sphere by these, as nearest_spheres() has it.
void answer_by(Candidate& candidate, const AskSphere& ask);

using MakeRoots = std::function<fast::Roots(const scene::Ray&, const scene::Sphere&)>;
using ChooseHit =
    std::function<Hit(const scene::Ray&, const fast::Roots&, const scene::Conventions&)>;

/// Whether a ray's line meets the sphere under the tangent convention.
bool meets(const fast::Roots& roots, const scene::Conventions& conventions);

/// What a right method chooses.
Hit usual_choice(const scene::Ray& ray, const fast::Roots& roots,
                 const scene::Conventions& conventions);

/// answer_by() a choice among two roots; input is not checked.
void answer_by_choice(Candidate& candidate, const MakeRoots& roots, const ChooseHit& choose);

/// What a hit sphere is ranked by: its index in the file, the roots, and the s that was chosen.
using RankSphere = std::function<double(std::size_t index, const scene::Ray&, const scene::Sphere&,
                                        const fast::Roots&, double s)>;

/// The formulas by which the nearest sphere is found; one that is empty is as a right method has
/// it, with the roots of `cross`.
struct HitFormulas {
  MakeRoots roots = {};
  ChooseHit choose = {};
  RankSphere rank = {};
};

/// The formulas of both, where there are no two for the same thing.
std::optional<HitFormulas> joined(HitFormulas one, const HitFormulas& other);

/// Of the spheres that are hit the one of the least rank is the nearest, the earlier in the file
/// among equals.
NearestSpheres nearest_by(const HitFormulas& formulas);

}  // namespace raycheck::properties
