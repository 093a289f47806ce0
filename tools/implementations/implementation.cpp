#include "tools/implementations/implementation.h"

#include <fmt/core.h>

#include <algorithm>
#include <set>
#include <string_view>

namespace raycheck::tools {

bool Implementation::offers(properties::Stage stage) const {
  return std::find(stages.begin(), stages.end(), stage) != stages.end();
}

std::string Implementation::name_in(properties::Stage stage) const {
  if (!methods) return name;
  return std::string(stage == properties::Stage::kRays ? methods->rays->name
                                                       : methods->intersect->name);
}

std::vector<std::string> lasting_names(const std::vector<Implementation>& implementations) {
  std::vector<std::string> names;
  for (const Implementation& one : implementations) {
    const auto called_the_same = std::count_if(
        implementations.begin(), implementations.end(),
        [&](const Implementation& other) { return other.lasting_name == one.lasting_name; });
    names.push_back(called_the_same == 1 ? one.lasting_name : one.name);
  }
  return names;
}

std::string isolation_text(const std::vector<Implementation>& implementations) {
  std::string text;
  std::set<std::string_view> said;
  for (const Implementation& one : implementations) {
    if (one.isolated_by.empty() || !said.insert(one.name).second) continue;
    text += fmt::format("{}  isolated by: {}", one.name, one.isolated_by);
    if (!one.bounds_of.empty()) {
      text += fmt::format("; documents no bounds: judged by those of {} (--bounds)", one.bounds_of);
    }
    if (one.precision != scene::Precision::kDouble) {
      text += "; judged in single precision: u = 2^-24, ulp of float";
    }
    text += "\n";
  }
  return text;
}

}  // namespace raycheck::tools
