#include "tools/grade/results/tolerated.h"

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

}  // namespace raycheck::tools
