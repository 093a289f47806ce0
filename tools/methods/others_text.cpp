#include "tools/methods/others_text.h"

#include <fmt/core.h>

#include <set>

namespace raycheck::tools {

std::string others_text(const std::vector<StagedMethod>& methods) {
  std::string text;
  std::set<std::string_view> said;
  for (const StagedMethod& method : methods) {
    if (!method.other || !said.insert(method.other->name).second) continue;
    const std::string bounds =
        method.other->bounds_of.empty()
            ? ""
            : fmt::format("; documents no bounds: held to those of {} (--bounds)",
                          method.other->bounds_of);
    text += fmt::format("{}  isolated by: {}{}{}\n", method.other->name, method.other->isolated_by,
                        bounds,
                        method.precision() == scene::Precision::kDouble
                            ? ""
                            : "; judged in single precision: u = 2^-24, ulp of float");
  }
  return text;
}

}  // namespace raycheck::tools
