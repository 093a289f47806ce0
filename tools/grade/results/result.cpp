#include "tools/grade/results/result.h"

#include <regex>

#include "tools/external/sandbox/private_folder.h"

namespace raycheck::tools {

properties::Candidate tolerated(properties::Candidate candidate, const Tolerance& tolerance) {
  const double unit = scene::unit_roundoff(candidate.precision);
  if (tolerance.conditioning) {
    candidate.max_error.fill(properties::kModerateCondition * *tolerance.conditioning);
    candidate.max_error_end_to_end.fill({});
    candidate.unit_roundoff = unit * *tolerance.conditioning;
  } else if (tolerance.ulp) {
    candidate.unit_roundoff = unit * *tolerance.ulp / properties::kExcusedRoundoffs;
  }
  return candidate;
}

std::string plain_text(const std::string& said) {
  // Quotes as compilers print them.
  static const std::regex quotes("\xe2\x80[\x98\x99]");
  std::string text = std::regex_replace(without_private_folders(said), quotes, "'");
  for (char& c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if ((byte < ' ' && c != '\n' && c != '\t') || byte > '~') c = '?';
  }
  return text;
}

}  // namespace raycheck::tools
