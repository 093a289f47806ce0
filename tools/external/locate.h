#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "tools/external/candidate_spec.h"
#include "tools/external/external_candidate.h"

namespace raycheck::tools {

/// How an external implementation is run.
struct RunOptions {
  Layers layers;
  Limits limits;
  MethodPair bounds = kDefaultMethods;
  // For renderers.
  DriverForm driver = {};
  scene::Precision precision = scene::Precision::kDouble;
  double excused_image_change = properties::kExcusedImageChange;
  double image_threshold = 0;
  std::optional<scene::Origin> origin = {};  ///< Where their rays start; empty: as asked.
  /// What it may read besides its own folder.
  std::vector<std::filesystem::path> reads = {};
  /// Where a source's headers are, which it may read.
  std::vector<std::filesystem::path> includes = {};
  /// The base of relative paths; empty: the working folder.
  std::filesystem::path folder = {};
  double build_seconds = 120;           ///< To compile it, of CPU time.
  std::string build_seconds_name = {};  ///< The name of that limit.
  /// Where compile time is added up.
  std::shared_ptr<SpentTime> build_spent = std::make_shared<SpentTime>();
  std::shared_ptr<AnswerStore> answers = std::make_shared<AnswerStore>();
  /// Is told about failures with a cause outside the candidate; null: nobody is.
  std::shared_ptr<Surroundings> surroundings = {};

  /// A program to run in this way, without its words yet.
  Confined confined() const {
    return {.arguments = {},
            .readable = reads,
            .layers = layers,
            .limits = limits,
            .surroundings = surroundings};
  }
};

/// An external implementation, compiled if it is a source, and started once. Words that name files
/// are made absolute.
/// Errors: CandidateError naming the candidate.
External find_external(const CandidateSpec& spec, const RunOptions& options);

/// The candidate for a library that was compiled from a source (compile.h).
/// Errors: CandidateError naming the candidate.
External compiled_external(const CandidateSpec& spec, const std::filesystem::path& library,
                           const RunOptions& options);

}  // namespace raycheck::tools
