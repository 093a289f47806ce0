#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "properties/run_control.h"
#include "properties/search/worst_case.h"
#include "tools/implementations/implementation.h"
#include "tools/report/view.h"
#include "tools/shards/units.h"
#include "tools/view/document.h"

namespace raycheck::tools {

struct WorstOptions {
  /// The candidate. Judged is the stage that computes `quantity`; if that is empty, its last stage.
  Implementation candidate;
  /// The quantity's name with hyphens for spaces; empty: the main quantity of the stage.
  std::string quantity;
  properties::SearchOptions search;  ///< From one source; the quantity is set from the one above.
  /// The number of searches, with different seeds; the worst input of all is reported.
  std::int64_t searches = 1;
};

struct WorstFound {
  std::optional<properties::WorstCase> worst;  ///< Empty if nothing was measured.
  std::uint64_t failures = 0;  ///< The number of times that the candidate gave no answer.
  std::string first_failure;   ///< The first of these failures.

  /// Adds the result of later searches. Keeps the worst input; of equally bad ones, the earliest.
  void merge(WorstFound later);
  template <class Archive>
  void serialize(Archive& archive) {
    archive(worst, failures, first_failure);
  }
};

struct WorstReport : WorstFound {
  properties::Stage stage = properties::Stage::kRays;
  Implementation candidate;
  properties::SearchOptions search;
  std::int64_t searches = 1;
  bool interrupted = false;

  const properties::ChosenSource& source() const { return search.sources.front(); }
  bool is_unstable() const;
};

/// Searches for the input on which a candidate's certified error is largest. If `units` is given,
/// runs only the shard's missing units, and returns an empty report unless the shard is the whole
/// campaign. Throws std::invalid_argument naming the field.
WorstReport find_worst(const WorstOptions& options, const properties::RunControl& control = {},
                       Units* units = nullptr);

std::string worst_text(const WorstReport& report, const ViewOptions& options);
std::string worst_json(const WorstReport& report, const ViewOptions& options);

inline constexpr View<WorstReport> kWorstViews[] = {
    {"text", worst_text},
    {"json", worst_json},
};

/// The input found as a TOML scene, with its error in a comment.
/// Domain: something was measured.
std::string worst_scene(const WorstReport& report);

/// The input found, as a page.
/// Domain: something was measured.
ViewDocument worst_document(const WorstReport& report, const properties::RunControl& control);

}  // namespace raycheck::tools
