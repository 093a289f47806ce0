#pragma once

// Someone else's library under the stopwatch of `tradeoff`: in raycheck's own process, by the same
// loops as raycheck's methods. Internal to tools/tradeoff/.

#include <string>
#include <vector>

#include "properties/candidate.h"
#include "tools/methods/methods.h"
#include "tools/tradeoff/tradeoff_items.h"

namespace raycheck::tools {

/// What is timed, or why it is not. Inputs are in the library's own structs before the clock runs.
struct OthersTimed {
  Timed single, batch;
  std::string not_timed;  ///< Empty: it is timed.
};

/// Timed where the answers in raycheck's own process are, to the bit, those that `judged` gives,
/// which is kept in a process of its own.
OthersTimed others_intersections(const OtherMethod& other, const properties::Candidate& judged,
                                 const std::vector<Pair>& pairs, const std::vector<Batch>& batches);
OthersTimed others_rays(const OtherMethod& other, const properties::Candidate& judged,
                        const std::vector<PixelBatch>& singles,
                        const std::vector<PixelBatch>& batches);

}  // namespace raycheck::tools
