#pragma once

#include <span>

#include "fast/intersect.h"

namespace raycheck::properties {

// The exact and nearly exact ways to intersect, as methods to compare with those of fast/: what
// certainty costs. They are built from the reference, so judging `reference` tells its cost and
// nothing else.

/// `arb-128`: balls of 128 bits; their midpoints decide where they cannot.
extern const fast::IntersectMethod kArb;
/// `reference-intervals`: the first step of the reference's ladder; what it leaves open is a miss.
extern const fast::IntersectMethod kReferenceIntervals;
/// `reference`: the whole ladder, correctly rounded.
extern const fast::IntersectMethod kReference;
/// `reference-field`: every class from the exact field, correctly rounded.
extern const fast::IntersectMethod kReferenceField;

/// All of them, in the order of reports.
std::span<const fast::IntersectMethod* const> exact_methods();

}  // namespace raycheck::properties
