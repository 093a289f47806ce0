#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "tools/external/candidate_spec.h"
#include "tools/external/external_candidate.h"

namespace raycheck::tools {

/// How an external candidate is run.
struct RunOptions {
  Layers layers;
  Limits limits;
  MethodPair bounds = kDefaultMethods;
  // For renderers.
  DriverForm driver = {};
  scene::Precision precision = scene::Precision::kDouble;
  double excused_image_change = properties::kExcusedImageChange;
  double image_threshold = 0;
  bool any_sample = false;
  std::optional<DepthForm> depth = {};
  /// Folders that it may read besides its own folder.
  std::vector<std::filesystem::path> reads = {};
  /// Folders with headers for its source, which it may read.
  std::vector<std::filesystem::path> includes = {};
  /// The base of relative paths; empty: the working folder.
  std::filesystem::path folder = {};
  double build_seconds = 120;           ///< The limit on CPU time for compilation.
  std::string build_seconds_name = {};  ///< The name of that limit in messages.
  /// Collects the compile time.
  std::shared_ptr<SpentTime> build_spent = std::make_shared<SpentTime>();
  std::shared_ptr<AnswerStore> answers = std::make_shared<AnswerStore>();
  /// Records why a failure is not the candidate's fault; may be null.
  std::shared_ptr<Surroundings> surroundings = {};

  /// A program to run with these options, without its arguments.
  Confined confined() const {
    return {.arguments = {},
            .readable = reads,
            .layers = layers,
            .limits = limits,
            .surroundings = surroundings};
  }
};

/// Finds an external candidate: compiles it if it is a source, and starts it once. File names in
/// its command line are made absolute.
/// Errors: CandidateError naming the candidate.
External find_external(const CandidateSpec& spec, const RunOptions& options);

/// The candidate for a library that compile() made from a source.
/// Errors: CandidateError naming the candidate.
External compiled_external(const CandidateSpec& spec, const std::filesystem::path& library,
                           const RunOptions& options);

}  // namespace raycheck::tools
