#include "tools/methods/others_text.h"

#include <fmt/core.h>

#include <set>

namespace raycheck::tools {

std::string others_text(const std::vector<StagedMethod>& methods) {
  std::string text;
  std::set<std::string_view> said;
  for (const StagedMethod& method : methods) {
    if (!method.other || !said.insert(method.other->name).second) continue;
    text +=
        fmt::format("{}  isolated by: {}; documents no bounds: held to those of {} (--bounds){}\n",
                    method.other->name, method.other->isolated_by, method.other->bounds_of,
                    method.precision() == scene::Precision::kDouble
                        ? ""
                        : "; judged in single precision: u = 2^-24, ulp of float");
  }
  return text;
}

}  // namespace raycheck::tools
