#include "tools/external/contestant.h"

#include <algorithm>
#include <cstddef>
#include <string_view>

namespace raycheck::tools {
namespace {

/// "renderer:python3 ../mine/rt.py {scene}" is "python3 rt.py {scene}".
std::string without_folders(std::string_view name) {
  name.remove_prefix(name.find(':') + 1);
  std::string words;
  while (!name.empty()) {
    const std::size_t end = std::min(name.find(' '), name.size() - 1) + 1;
    const std::string_view word = name.substr(0, end);
    words += word.substr(word.rfind('/') + 1);
    name.remove_prefix(end);
  }
  return words;
}

std::string lasting_name(const Contestant& contestant) {
  const External* const external = external_of(contestant);
  if (external == nullptr) return candidate_of(*methods_of(contestant)).name;
  const std::string& said = external->introduction.name;
  return said.empty() ? without_folders(external->name) : said;
}

}  // namespace

properties::Candidate candidate_of(const Contestant& contestant) {
  if (const External* external = external_of(contestant)) return external_candidate(*external);
  return candidate_of(*methods_of(contestant));
}

const MethodPair* methods_of(const Contestant& contestant) {
  return std::get_if<MethodPair>(&contestant);
}
const External* external_of(const Contestant& contestant) {
  return std::get_if<External>(&contestant);
}

std::vector<std::string> lasting_names(const std::vector<Contestant>& contestants) {
  std::vector<std::string> names;
  for (const Contestant& contestant : contestants) names.push_back(lasting_name(contestant));
  const std::vector<std::string> all = names;
  for (std::size_t k = 0; k < all.size(); ++k) {
    const External* const external = external_of(contestants[k]);
    const bool is_alone = std::count(all.begin(), all.end(), all[k]) == 1;
    if (external != nullptr && !is_alone) names[k] = external->name;
  }
  return names;
}

std::vector<Contestant> contestants(const std::vector<MethodPair>& pairs) {
  return {pairs.begin(), pairs.end()};
}

}  // namespace raycheck::tools
