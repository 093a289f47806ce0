#pragma once

#include <filesystem>
#include <memory>

#include "tools/external/candidate_spec.h"
#include "tools/external/external_candidate.h"

namespace raycheck::tools {

/// How someone else's implementation is run.
struct RunOptions {
  Layers layers;
  Limits limits;
  MethodPair bounds = kDefaultMethods;
  // Of renderers.
  DriverForm driver = {};
  scene::Precision precision = scene::Precision::kDouble;
  double excused_image_change = properties::kExcusedImageChange;
  double image_threshold = 0;
  /// Relative paths start here; empty: in the working folder.
  std::filesystem::path folder = {};
  double build_seconds = 120;           ///< To compile it, of CPU time.
  std::string build_seconds_name = {};  ///< What who set it calls it.
  /// Where what it takes to compile it is added up.
  std::shared_ptr<SpentTime> build_spent = std::make_shared<SpentTime>();
  /// What it answered in earlier runs; null: it is always asked.
  std::shared_ptr<AnswerStore> answers = {};
  /// Who is told where it fails for a cause outside it; null: nobody.
  std::shared_ptr<Surroundings> surroundings = {};
};

/// Someone else's implementation, compiled where it is a source, and started once. Of words, those
/// that name files are made absolute.
/// Errors: CandidateError naming the candidate.
External find_external(const CandidateSpec& spec, const RunOptions& options);

/// What was compiled (compile.h) of a candidate that is a source.
/// Errors: CandidateError naming the candidate.
External compiled_external(const CandidateSpec& spec, const std::filesystem::path& library,
                           const RunOptions& options);

}  // namespace raycheck::tools
