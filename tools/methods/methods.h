#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "fast/intersect.h"
#include "fast/pixel_ray.h"
#include "properties/search/stress.h"

namespace raycheck::tools {

/// A ray method and an intersection method that together make a candidate.
struct MethodPair {
  const fast::PixelRayMethod* rays;
  const fast::IntersectMethod* intersect;
  bool operator==(const MethodPair&) const = default;
};

/// What is judged when nothing is asked for: stable and plain.
inline constexpr MethodPair kDefaultMethods = {&fast::kDirectRays, &fast::kCross};

/// The method of that name; throws std::invalid_argument naming the field and the known names.
const fast::PixelRayMethod& find_rays(const std::string& name, const char* field = "rays");
const fast::IntersectMethod& find_intersect(const std::string& name,
                                            const char* field = "intersect");

/// The pair called "RAYS/INTERSECT", or "INTERSECT" with the default rays: whose bounds hold.
/// Throws as above.
MethodPair find_pair(const std::string& name);

/// Someone else's implementation, known by what it is called and how it is asked.
struct OtherMethod {
  std::string name;
  std::string isolated_by;  ///< What keeps it: "own user, seccomp, bubblewrap".
  /// The methods whose bounds it is held to; empty: it has bounds of its own.
  std::string bounds_of;
  /// Of its own for each call.
  std::function<properties::Candidate()> candidate;
  scene::Precision precision = scene::Precision::kDouble;  ///< That it is asked and judged in.
  /// The shared library that may be called in raycheck's own process; empty: there is none, or it
  /// is to be kept.
  std::string library = {};
  bool is_kept = false;  ///< In a sandbox.
};

/// A method of either kind, to be judged in its own stage.
struct StagedMethod {
  properties::Stage stage = properties::Stage::kRays;
  /// Of someone else's implementation the methods whose bounds it is held to.
  const fast::PixelRayMethod* rays = kDefaultMethods.rays;
  const fast::IntersectMethod* intersect = kDefaultMethods.intersect;
  /// Null: it is raycheck's own.
  std::shared_ptr<const OtherMethod> other = nullptr;
  /// Pictures tell the methods of a stage apart by it: the place among all of them, others' last.
  std::size_t number = 0;

  /// That it is asked and judged in. raycheck's own methods in floats take doubles, and round them:
  /// they are judged as what they are for their callers.
  scene::Precision precision() const {
    return other ? other->precision : scene::Precision::kDouble;
  }
  std::string_view name() const {
    if (other) return other->name;
    return stage == properties::Stage::kRays ? rays->name : intersect->name;
  }
};

/// Every intersection method: those of fast/, the exact ones, then those of other libraries.
std::vector<const fast::IntersectMethod*> all_intersect_methods();

/// The methods of those names, of either kind ("rays/NAME" and "intersect/NAME" tell them apart;
/// "all" is every one); when there are none those of fast/, which is what a renderer may use.
/// Throws std::invalid_argument naming the field and the known names.
std::vector<StagedMethod> find_methods(const std::vector<std::string>& names);

/// The methods of those names and others' behind them; where others are given and no name, those
/// alone. Throws as above.
std::vector<StagedMethod> find_methods(const std::vector<std::string>& names,
                                       const std::vector<StagedMethod>& others);

properties::Candidate candidate_of(const MethodPair& pair);
properties::Candidate candidate_of(const StagedMethod& method);

/// Every pair, in the order of reports.
std::vector<MethodPair> all_pairs();
/// Each method once, the others at their default.
std::vector<MethodPair> each_method_once();

}  // namespace raycheck::tools
