#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "properties/candidate.h"
#include "properties/case.h"
#include "tools/grade/results/result.h"
#include "tools/grade/rubric/rubric.h"

namespace raycheck::tools {

/// A case of an item, and its origin.
struct ItemCase {
  properties::Case the_case;
  CaseOrigin origin;
};

/// The cases of an item, by their numbers: its scenes (for pictures varied as the item says), then
/// random ones. All follow from a seed.
class ItemCases {
 public:
  /// `declared`: the conventions under which the submission is judged, in a format that every case
  /// is rounded to.
  ItemCases(const ItemTask& task, bool pictures, std::uint64_t seed,
            const properties::DeclaredConventions& declared,
            scene::Precision precision = scene::Precision::kDouble);

  std::size_t size() const { return task_.scenes.size() + seeds_.size(); }
  /// Empty if there is nothing to ask: the format cannot hold the case, for example.
  std::optional<ItemCase> operator[](std::size_t k) const;

 private:
  ItemCase of_scene(std::size_t k) const;
  std::optional<ItemCase> of_source(std::size_t k) const;

  const ItemTask& task_;
  bool pictures_;
  const properties::DeclaredConventions& declared_;
  scene::Precision precision_;
  std::vector<std::uint64_t> scene_seeds_;
  std::vector<std::uint64_t> seeds_;
};

}  // namespace raycheck::tools
