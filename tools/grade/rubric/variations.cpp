#include "tools/grade/rubric/variations.h"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string>

namespace raycheck::tools {

std::vector<properties::Variation> read_variations(const scene::TomlFields& fields,
                                                   const scene::TomlFields::Field& field) {
  const auto& names = properties::kVariationNames;
  std::vector<properties::Variation> found;
  for (const scene::TomlFields::Field& each : fields.list(field)) {
    const auto name = std::find(names.begin(), names.end(), fields.text(each));
    if (name == names.end()) {
      fields.fail(each, fmt::format("must be one of {}", fmt::join(names, ", ")));
    }
    found.push_back(static_cast<properties::Variation>(name - names.begin()));
  }
  return found;
}

}  // namespace raycheck::tools
