#pragma once

#include <span>

#include "fast/intersect.h"

namespace raycheck::properties {

// Exact and nearly exact intersection methods, to compare their cost with methods of fast/. They
// are made of the reference's code, so a verdict on `reference` says nothing about its errors.

/// `arb-128`: balls of 128 bits. If a ball contains 0, the sign of its midpoint decides.
extern const fast::IntersectMethod kArb;
/// `reference-intervals`: only the reference's first filter stage; pairs that it cannot decide are
/// misses.
extern const fast::IntersectMethod kReferenceIntervals;
/// `reference`: all filter stages, correctly rounded.
extern const fast::IntersectMethod kReference;
/// `reference-field`: every hit class is decided in the exact field; values are correctly rounded.
extern const fast::IntersectMethod kReferenceField;

/// These methods, in the order of reports.
std::span<const fast::IntersectMethod* const> exact_methods();

}  // namespace raycheck::properties
