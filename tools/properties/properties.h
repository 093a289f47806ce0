#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "properties/mistakes/explanation.h"
#include "properties/run_control.h"
#include "properties/search/campaign.h"
#include "properties/search/ranges.h"
#include "properties/search/worst_case.h"
#include "tools/gates/baseline.h"
#include "tools/gates/gate.h"
#include "tools/implementations/implementation.h"
#include "tools/report/view.h"
#include "tools/shards/units.h"
#include "tools/view/document.h"

namespace raycheck::tools {

struct PropertiesOptions {
  std::vector<std::string> filters;  ///< Only laws whose name contains one of these; if empty, all.
  int cases = properties::kCampaignCases;
  std::uint64_t seed = 1;
  std::string replay;  ///< The failure to replay; if empty, campaigns are run.
  std::vector<Implementation> implementations;    ///< If empty, each of raycheck's methods once.
  std::vector<properties::ChosenSource> sources;  ///< If empty, every source that suits the law.
  std::optional<properties::Level> level;         ///< If empty, each candidate's level.
  std::optional<double> max_error;
  bool strict = false;         ///< Whether excused or undecided answers break a law, too.
  std::size_t keep_going = 1;  ///< The number of distinct failures of a law to search for.
  /// If given, after the random cases, hill-climb to maximise this value for each law that has it.
  std::optional<properties::Climb> target;
  std::string corpus;  ///< A folder of cases that once broke a law, or empty.
};

struct CorpusFinding {
  std::string file, law;
  std::string candidate, lasting_name;
  /// Whether the case was kept because this candidate broke the law on it.
  bool was_broken = false;
  properties::Finding finding = properties::Finding::kHolds;
  std::vector<properties::DefectKind> defects;

  bool is_mended() const { return was_broken && finding == properties::Finding::kHolds; }
};

/// The result of trying one law on one candidate.
struct CampaignReport {
  const properties::Law* law;
  std::string candidate;
  std::string lasting_name;  ///< Its name in a baseline (lasting_names).
  properties::CampaignResult result;
  properties::Finding finding;
  /// The mistakes that explain the errors of an external implementation that breaks the law.
  std::vector<properties::Explanation> explanations = {};
  /// The ranges of the numbers of the failure's case; empty if they are not sought (has_ranges).
  std::optional<properties::Ranges> ranges = {};
  Implementation implementation = {};
  scene::Precision precision = scene::Precision::kDouble;  ///< The format in which it was judged.
  properties::Domain domain = {};                          ///< The domain in which it was judged.
  std::optional<properties::WorstCase> worst = {};         ///< The result of the climb to a target.

  /// Whether the failure depends on earlier questions to the candidate.
  bool keeps_state() const { return result.failure && result.failure->is_of_earlier; }
};

/// An external candidate that documents no bounds.
struct BorrowedBounds {
  std::string candidate;
  std::string methods;  ///< The methods whose bounds apply to it: "direct/cross".
};

struct PropertiesReport {
  std::vector<CorpusFinding> corpus;
  std::vector<CampaignReport> campaigns;
  std::vector<BorrowedBounds> borrowed;
  std::optional<std::uint64_t> seed;  ///< Empty if a failure was replayed.
  int cases = 0;
  bool interrupted = false;
  bool strict = false;
  std::optional<properties::Climb> target;
  std::string time = {};           ///< The time that the user wanted to fill, "10m"; or empty.
  std::optional<Ratchet> ratchet;  ///< If it is compared with a baseline.

  std::uint64_t count(properties::Finding finding) const;
  std::uint64_t failures() const { return count(properties::Finding::kBroken); }
  bool holds() const;
  /// Whether something was judged, no law has too few judged cases, and everything undecided is in
  /// the baseline.
  bool is_conclusive() const;
};

/// Runs the campaigns, or replays one failure. If `units` is given, runs only the shard's missing
/// units, and returns an empty report unless the shard is the whole campaign. Throws
/// std::invalid_argument naming the field.
PropertiesReport run_properties(const PropertiesOptions& options,
                                const properties::RunControl& control = {}, Units* units = nullptr);

// A folder of cases that once broke a law, `corpus`: each is a scene whose comments name the law,
// the candidate, and how to replay the case from which it was shrunk.

/// Judges every candidate on every case of the folder, in the order of the file names, by the
/// case's law if that is selected. Shape: a candidate for each implementation, in their order.
/// Errors: std::invalid_argument naming the file.
std::vector<CorpusFinding> try_corpus(const PropertiesOptions& options,
                                      std::span<const properties::Law* const> laws,
                                      std::span<const Implementation> implementations,
                                      std::span<const properties::Candidate> candidates);

/// Adds shrunk cases that break a law to the folder, which is made if missing. Other files stay.
/// Errors: std::invalid_argument, std::runtime_error.
void keep_in_corpus(const PropertiesReport& report, const std::string& folder);

/// The number of cases that take this many seconds on this machine, estimated by campaigns of
/// growing size.
int cases_for(const PropertiesOptions& options, double seconds,
              const properties::RunControl& control);

std::string properties_text(const PropertiesReport& report, const ViewOptions& options);
std::string properties_json(const PropertiesReport& report, const ViewOptions& options);

/// One check per law and source.
Gate properties_gate(const PropertiesReport& report);

inline constexpr View<PropertiesReport> kPropertiesViews[] = {
    {"text", properties_text},
    {"json", properties_json},
};

/// The parts of each source, in the order of sources.
std::vector<std::span<const properties::CampaignPart>> by_source(
    const properties::CampaignResult& result);
/// Which answers were too rarely right to conclude that a law holds.
/// Domain: a campaign with that finding.
std::string too_few_text(const properties::CampaignResult& result);
std::string replay_text(const CampaignReport& campaign, const std::string& replay);
/// Why a law is broken, in lines, with the shrunk case.
/// Domain: a campaign with a failure.
std::string failure_text(const CampaignReport& campaign, bool colours);
/// Why another failure of the same campaign breaks the law.
std::string failure_text(const CampaignReport& campaign, const properties::Failure& failure,
                         bool colours);

/// The shrunk cases of all broken laws as a page, with a scene for each.
ViewDocument properties_document(const PropertiesReport& report,
                                 const properties::RunControl& control);

}  // namespace raycheck::tools
