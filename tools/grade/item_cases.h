#ifndef RAYCHECK_TOOLS_GRADE_ITEM_CASES_H_
#define RAYCHECK_TOOLS_GRADE_ITEM_CASES_H_

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "properties/candidate.h"
#include "properties/case.h"
#include "tools/grade/rubric.h"

namespace raycheck::tools {

/// A case, and where it comes from.
struct Asked {
  properties::Case the_case;
  std::string origin;  ///< "scene frame.toml", "course, random case 7"
};

/// The cases of an item, by their numbers: its scenes, then random ones that follow from a seed.
class ItemCases {
 public:
  /// `declared`: the conventions under which the submission is judged.
  ItemCases(const Questions& questions, bool pictures, std::uint64_t seed,
            const properties::DeclaredConventions& declared);

  std::size_t size() const { return questions_.scenes.size() + seeds_.size(); }
  /// Empty where there is nothing to ask.
  std::optional<Asked> operator[](std::size_t k) const;

 private:
  Asked of_scene(const RubricScene& scene) const;
  std::optional<Asked> of_source(std::size_t k) const;

  const Questions& questions_;
  bool pictures_;
  const properties::DeclaredConventions& declared_;
  std::uint64_t scene_seed_ = 0;
  std::vector<std::uint64_t> seeds_;
};

}  // namespace raycheck::tools

#endif  // RAYCHECK_TOOLS_GRADE_ITEM_CASES_H_
