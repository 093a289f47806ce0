#ifndef RAYCHECK_TOOLS_EXTERNAL_LOCATE_H_
#define RAYCHECK_TOOLS_EXTERNAL_LOCATE_H_

#include <filesystem>
#include <string>

#include "tools/external/external_candidate.h"

namespace raycheck::tools {

/// How someone else's implementation is run.
struct RunOptions {
  Layers layers;
  Limits limits;
  // Of renderers.
  scene::Dialect dialect = scene::Dialect::kB;
  double excused_image_change = properties::kExcusedImageChange;
  double image_threshold = 0;
  /// Relative paths start here; empty: in the working folder.
  std::filesystem::path folder = {};
  double build_seconds = 120;  ///< To compile it.
};

/// Someone else's implementation by what `--candidate` calls it:
///   library:PATH.so   functions of <raycheck/candidate.h>
///   source:PATH       a C++ file, a folder of them or with a CMakeLists.txt, to be compiled to one
///   command:'WORDS'   a program that speaks the protocol; words that name files are made absolute
///   renderer:'WORDS'  a finished renderer, started for every scene; {scene} and {image} stand for
///                     files
/// Errors: std::invalid_argument naming what is wrong; a compiler's message is part of it.
External find_external(const std::string& what, const RunOptions& options);

}  // namespace raycheck::tools

#endif  // RAYCHECK_TOOLS_EXTERNAL_LOCATE_H_
