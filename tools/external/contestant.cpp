#include "tools/external/contestant.h"

namespace raycheck::tools {

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

std::vector<Contestant> contestants(const std::vector<MethodPair>& pairs) {
  return {pairs.begin(), pairs.end()};
}

}  // namespace raycheck::tools
