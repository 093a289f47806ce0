#pragma once

#include <span>

#include "fast/intersect.h"

namespace raycheck::properties {

// The exact and nearly exact ways to intersect, as methods to compare with those of fast/: what
// certainty costs. They are built from the reference, so judging `reference` tells its cost and
// nothing else.

/// The precision of `arb-128`, in bits.
inline constexpr int kArbBits = 128;

/// Correctly rounded: half an ulp in s. Each coordinate of Q too, which makes at most u of |Q|.
inline constexpr double kCorrectlyRoundedUlp = 0.5;
inline constexpr double kCorrectlyRoundedPointUlp = 1;
/// The enclosure's midpoint, rounded once: what 128 bits lose shows only beyond the condition
/// numbers that bounds are about.
inline constexpr double kArbMaxUlp = kCorrectlyRoundedUlp + 0x1p-30;
inline constexpr double kArbMaxPointUlp = kCorrectlyRoundedPointUlp + 0x1p-30;
/// The middle of an interval of doubles; Q in doubles.
inline constexpr double kIntervalsMaxUlp = 96;
inline constexpr double kIntervalsMaxPointUlp = 192;

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
