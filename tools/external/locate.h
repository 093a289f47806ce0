#ifndef RAYCHECK_TOOLS_EXTERNAL_LOCATE_H_
#define RAYCHECK_TOOLS_EXTERNAL_LOCATE_H_

#include <filesystem>

#include "tools/external/candidate_spec.h"
#include "tools/external/external_candidate.h"

namespace raycheck::tools {

/// How someone else's implementation is run.
struct RunOptions {
  Layers layers;
  Limits limits;
  MethodPair bounds = kDefaultMethods;
  // Of renderers.
  scene::Dialect dialect = scene::Dialect::kB;
  double excused_image_change = properties::kExcusedImageChange;
  double image_threshold = 0;
  /// Relative paths start here; empty: in the working folder.
  std::filesystem::path folder = {};
  double build_seconds = 120;  ///< To compile it.
};

/// Someone else's implementation, compiled where it is a source, and started once. Of words, those
/// that name files are made absolute.
/// Errors: CandidateError naming the candidate.
External find_external(const CandidateSpec& spec, const RunOptions& options);

}  // namespace raycheck::tools

#endif  // RAYCHECK_TOOLS_EXTERNAL_LOCATE_H_
