#pragma once

// What every intersection method must do, whatever it computes with.

#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "fast/intersect.h"

namespace raycheck {

inline fast::Rays batch_of(const std::vector<scene::Ray>& given) {
  fast::Rays rays;
  rays.resize(given.size());
  for (std::size_t k = 0; k < given.size(); ++k) rays.set(k, given[k]);
  return rays;
}

/// A batch has the answers of single calls, to the bit. Returns how many of them are hits.
inline int expect_batch_is_single_calls(const fast::IntersectMethod& method,
                                        const std::vector<scene::Ray>& rays,
                                        const scene::Sphere& sphere, scene::HitRule rule) {
  fast::Hits hits;
  method.intersect(batch_of(rays), sphere, rule, hits);
  EXPECT_EQ(hits.size(), rays.size()) << method.name;
  if (hits.size() != rays.size()) return 0;
  int count = 0;
  for (std::size_t k = 0; k < rays.size(); ++k) {
    const auto one = method.intersect_one(rays[k], sphere, rule);
    EXPECT_EQ(one.has_value(), hits.hit[k] != 0) << method.name << " ray " << k;
    if (!one || hits.hit[k] == 0) continue;
    ++count;
    const auto expect_same = [&](double a, double b) {
      EXPECT_EQ(std::bit_cast<std::uint64_t>(a), std::bit_cast<std::uint64_t>(b))
          << method.name << " ray " << k;
    };
    expect_same(one->parameter, hits.parameter[k]);
    expect_same(one->point.x, hits.point.x[k]);
    expect_same(one->point.y, hits.point.y[k]);
    expect_same(one->point.z, hits.point.z[k]);
  }
  return count;
}

/// What a method says when it refuses; empty when it does not.
inline std::string refusal_of(const fast::IntersectMethod& method,
                              const std::vector<scene::Ray>& rays, const scene::Sphere& sphere) {
  fast::Hits hits;
  try {
    method.intersect(batch_of(rays), sphere, {}, hits);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

/// Input that is not a problem is refused by the name of the field, and no other is.
inline void expect_refusals(const fast::IntersectMethod& method) {
  const auto expect_names = [&](const std::vector<scene::Ray>& rays, const scene::Sphere& sphere,
                                const std::vector<std::string>& names) {
    const std::string refusal = refusal_of(method, rays, sphere);
    for (const std::string& name : names) {
      EXPECT_NE(refusal.find(name), std::string::npos) << method.name << ": " << refusal;
    }
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const scene::Ray good = {{-5, 0, 0}, {1, 0, 0}};
  const scene::Sphere sphere = {{0, 0, 0}, 1};
  EXPECT_EQ(refusal_of(method, {good, good}, sphere), "") << method.name;
  EXPECT_EQ(refusal_of(method, {}, sphere), "") << method.name;
  expect_names({good}, {{0, 0, 0}, -1}, {"radius"});
  expect_names({}, {{0, nan, 0}, 1}, {"centre"});
  expect_names({good, {{0, 0, 0}, {0, 0, 0}}}, sphere, {"ray 1", "direction"});
  expect_names({good, good, {{0, 0, nan}, {1, 0, 0}}}, sphere, {"ray 2", "origin"});
}

}  // namespace raycheck
