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
  /// Judged at the stage that computes `quantity`; if that is empty, at its last stage.
  Implementation method;
  std::string family;    ///< "SOURCE" or "SOURCE@SEVERITY", where the search starts.
  std::string quantity;  ///< With hyphens for spaces; empty: the main one of the method's stage.
  properties::SearchOptions search;  ///< Its sources and its quantity follow from these.
  std::int64_t searches = 1;         ///< With different seeds; the worst of all is reported.
};

struct WorstFound {
  std::optional<properties::WorstCase> worst;  ///< Empty: nothing was measured.
  std::uint64_t failures = 0;                  ///< The number of times it gave no answer.
  std::string first_failure;                   ///< The message of the first failure.

  /// Adds later searches: keeps the worst case and the first failure.
  void merge(WorstFound later);
  template <class Archive>
  void serialize(Archive& archive) {
    archive(worst, failures, first_failure);
  }
};

struct WorstReport : WorstFound {
  properties::Stage stage = properties::Stage::kRays;
  Implementation method;
  properties::SearchOptions search;
  std::int64_t searches = 1;
  bool interrupted = false;

  const properties::ChosenSource& source() const { return search.sources.front(); }
  bool is_unstable() const;
};

/// Searches for the input on which a method's certified error is largest. With `units`, runs only
/// the missing units of the shard; the report is empty unless all units are then present.
/// Throws std::invalid_argument naming the field.
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
