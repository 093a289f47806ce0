#ifndef RAYCHECK_PROPERTIES_IMAGE_EXPLANATION_H_
#define RAYCHECK_PROPERTIES_IMAGE_EXPLANATION_H_

#include <cstdint>
#include <string>
#include <vector>

#include "properties/candidate.h"

namespace raycheck::properties {

/// One convention or one classic mistake that makes right what was wrong.
struct Explanation {
  std::string sentence;  ///< "rows are upside down"
  std::uint64_t errors = 0, explained = 0;
};

/// What explains at least kExplainedShare of an image's errors; of several the best, all where they
/// explain as many. The image as each mistake makes it is worked out exactly.
/// Domain: a scene with a camera; an answer for every pixel, under these conventions.
std::vector<Explanation> explanations(const scene::Scene& scene,
                                      const scene::Conventions& conventions,
                                      const ImageAnswer& image);
inline constexpr double kExplainedShare = 0.9;

}  // namespace raycheck::properties

#endif  // RAYCHECK_PROPERTIES_IMAGE_EXPLANATION_H_
