#include "tools/implementations/implementation.h"

#include <fmt/core.h>

#include <algorithm>
#include <set>
#include <string_view>

#include "scene/text.h"
#include "tools/report/words.h"

namespace raycheck::tools {

bool Implementation::offers(properties::Stage stage) const {
  return std::ranges::find(stages, stage) != stages.end();
}

std::string Implementation::name_in(properties::Stage stage) const {
  if (!methods) return name;
  return std::string(stage == properties::Stage::kRays ? methods->rays->name
                                                       : methods->intersect->name);
}

std::vector<std::string> lasting_names(const std::vector<Implementation>& implementations) {
  std::vector<std::string> names;
  for (const Implementation& one : implementations) {
    const auto called_the_same =
        std::ranges::count(implementations, one.lasting_name, &Implementation::lasting_name);
    names.push_back(called_the_same == 1 ? one.lasting_name : one.name);
  }
  return names;
}

std::string isolation_text(const std::vector<Implementation>& implementations) {
  Grouped<std::string> lines;  // the names that share a text
  std::set<std::string_view> said;
  for (const Implementation& one : implementations) {
    if (one.isolated_by.empty() || !said.insert(one.name).second) continue;
    std::string holds = fmt::format("isolated by: {}", one.isolated_by);
    if (!one.bounds_of.empty()) {
      holds += fmt::format(
          "; states no error bounds, so those of {} apply; --bounds chooses others", one.bounds_of);
    }
    if (one.precision != scene::Precision::kDouble) {
      holds += "; judged in single precision: u = 2^-24, ulp of float";
    }
    add_to(lines, holds, one.name);
  }
  return scene::joined(lines, "", [](const auto& line) {
    return fmt::format("{}  {}\n", scene::joined(line.second), line.first);
  });
}

}  // namespace raycheck::tools
