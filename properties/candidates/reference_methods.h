#pragma once

#include <span>

#include "fast/intersect.h"

namespace raycheck::properties {

// Exact and nearly exact intersection methods, to compare their cost with those of fast/. They are
// built from the reference, so judging `reference` measures only its cost.

/// `arb-128`: balls of 128 bits; their midpoints decide where they cannot.
extern const fast::IntersectMethod kArb;
/// `reference-intervals`: only the reference's first filter stage; undecided pairs are misses.
extern const fast::IntersectMethod kReferenceIntervals;
/// `reference`: all filter stages, correctly rounded.
extern const fast::IntersectMethod kReference;
/// `reference-field`: every hit class from the exact field, correctly rounded.
extern const fast::IntersectMethod kReferenceField;

/// All of them, in the order of reports.
std::span<const fast::IntersectMethod* const> exact_methods();

}  // namespace raycheck::properties
