#pragma once

// How `check` judges many rays. Internal to `check`.

#include <tbb/enumerable_thread_specific.h>

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "properties/case.h"
#include "properties/cases/scene_cases.h"
#include "properties/run_control.h"
#include "scene/plan/plan.h"
#include "scene/scene.h"
#include "tools/check/check.h"
#include "tools/shards/units.h"

namespace raycheck::tools {

/// The number of rays judged at a time. After each chunk, progress is shown and interrupts are
/// handled. Mistakes are searched for on the first chunk.
inline constexpr std::size_t kChunk = 512;

/// Why laws were left out, by law.
using ReasonsLeftOut = std::map<std::string, std::string, std::less<>>;

/// A candidate's report while it is being made.
struct Draft {
  CandidateReport report;
  ReasonsLeftOut left_out;
};

/// A scene in the formats of the candidates.
class ScenesOfFormats {
 public:
  struct InFormat {
    properties::RoundedCase rounded;
    /// The scene's rays; empty if the format cannot hold the scene.
    std::optional<properties::SceneCases> cases;
  };
  /// Rounds the scene to doubles and to the formats of these candidates.
  ScenesOfFormats(const scene::Scene& given, std::optional<std::int64_t> pixels,
                  const std::vector<Implementation>& implementations) {
    const auto add = [&](properties::InputFormat format) {
      InFormat& here = formats_[format];
      if (here.cases || !here.rounded.reason.empty()) return;
      here.rounded = properties::rounded_scene(given, format);
      if (here.rounded.the_case) here.cases.emplace(here.rounded.the_case->scene, pixels);
    };
    add(properties::InputFormat());
    for (const Implementation& one : implementations) add(one.input_format());
  }
  const InFormat& in(properties::InputFormat format) const { return formats_.at(format); }
  auto begin() const { return formats_.begin(); }
  auto end() const { return formats_.end(); }
  const properties::SceneCases& given() const { return *in(properties::InputFormat()).cases; }

 private:
  properties::ByFormat<InFormat> formats_;
};

/// The verdict on one candidate on a chunk of the rays.
struct ChunkVerdict;
using ChunkVerdicts = std::vector<ChunkVerdict>;  ///< One for each candidate.

/// Judges the rays for the drafts' candidates, chunk by chunk. Every thread has separate
/// candidates. Chunks share only the plans; their verdicts are merged in the order of the rays.
class Judgement {
 public:
  /// The arguments must outlive it.
  Judgement(std::optional<double> max_error, const ScenesOfFormats& scenes,
            std::vector<Draft>& drafts);

  /// Judges all chunks; sets the number of rays judged, and calls `tell` after each chunk. `units`
  /// stores the results of chunks, and may be null.
  void run(const properties::RunControl& control, Units* units, std::uint64_t& rays_judged,
           const std::function<void()>& tell);

 private:
  ChunkVerdicts judge(std::uint64_t first);
  void merge(ChunkVerdicts& verdicts, std::uint64_t first);
  void seek_failures(std::size_t k, std::uint64_t first, ChunkVerdict& failed);

  std::optional<double> max_error_;
  const ScenesOfFormats& scenes_;
  std::vector<Draft>& drafts_;
  properties::ByFormat<std::vector<scene::ScenePlan>> plans_;
  tbb::enumerable_thread_specific<std::vector<properties::Candidate>> candidates_;
  /// For candidates that have failed.
  std::vector<std::optional<properties::Candidate>> searchers_;
};

}  // namespace raycheck::tools
