#ifndef RAYCHECK_PROPERTIES_SEARCH_CAMPAIGN_H_
#define RAYCHECK_PROPERTIES_SEARCH_CAMPAIGN_H_

#include <array>
#include <cstdint>
#include <iosfwd>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "properties/cases/case_source.h"
#include "properties/laws/law.h"
#include "properties/level.h"
#include "properties/run_control.h"

namespace raycheck::properties {

/// Cases for each law and candidate: with so many every mutant and every dull or subtly wrong
/// candidate of the tests is found out by a law that it breaks.
inline constexpr int kCampaignCases = 1000;

struct CampaignOptions {
  /// Shared evenly among the sources, and within a source among its severities; every source has at
  /// least one, at its highest severity.
  int cases = kCampaignCases;
  std::uint64_t seed = 1;
  std::optional<double> max_error;
  /// Severities of this level and of those before it are asked.
  Level level = Level::kDemanding;
  /// Where cases come from; empty: every source of the level that suits the law. One without a
  /// severity stands for its severities of the level, one with a severity for that, of any level.
  std::vector<ChosenSource> sources;
};

/// What became of cases, all of which are counted once.
struct CaseCounts {
  int cases = 0;       ///< Tried, before an end or a break.
  int left_out = 0;    ///< Of those, the ones that the law had nothing to say about,
  int not_judged = 0;  ///< and those outside the candidate's stated domain.
  std::string reason;  ///< Why the last of those left out was.

  void add(const CaseCounts& other);
};

/// What a law says of the cases of one source, at one severity where it has a dial. The first case
/// that breaks it without an excuse ends them.
struct CampaignPart {
  ChosenSource source;
  CaseCounts counts;
  Verdict verdict;
  /// Finds the case that breaks it again: "LAW:CANDIDATE:SOURCE:SEED"; a SOURCE may be
  /// SOURCE@SEVERITY. Empty where the law is not broken.
  std::string replay;

  bool is_broken() const { return !replay.empty(); }
};

/// A case found to break a law, shrunk while it still does.
struct Failure {
  Case shrunk;
  Verdict verdict;
  std::string replay;
};

/// What a law comes to with a candidate.
enum class Finding { kHolds, kBroken, kUndecided, kTooFewJudged, kNotJudged, kLeftOut };
inline constexpr std::array<std::string_view, 6> kFindingNames = {
    "holds", "broken", "undecided", "too few judged", "not judged here", "left out"};
constexpr std::string_view name(Finding finding) {
  return kFindingNames[static_cast<std::size_t>(finding)];
}

struct CampaignResult {
  Level level = Level::kDemanding;
  std::vector<CampaignPart> parts;  ///< In the order of sources and severities.
  CaseCounts counts;                ///< Of all parts together,
  Verdict verdict;                  ///< shrinking aside.
  /// Of the first part that is broken, among those of the lowest level.
  std::optional<Failure> failure;

  /// Under `strict` a discrepancy that is excused breaks a law, too.
  Finding finding(bool strict = false) const;
};

/// Runs a law on random cases (RapidCheck generates and shrinks) of every source and severity, each
/// of which has a seed of its own: a break of one ends no other. The same options give the same
/// result, and a part is the same whatever other parts there are, but for the number of its cases.
CampaignResult run_campaign(const Law& law, const Candidate& candidate,
                            const CampaignOptions& options, const RunControl& control = {});

/// How far along a family's dial a law holds.
struct Reach {
  const CaseSource* family = nullptr;
  /// The highest severity that was judged before the first broken one; empty where there is none.
  std::optional<int> holds_to;
  std::optional<int> broken_at;  ///< Empty: nowhere on the dial.
  std::string replay;            ///< Of broken_at.
};

/// Follows the dial of every source that stands for its severities in a campaign of these options,
/// through the level and beyond it, to the first severity that breaks the law or to the end: on as
/// many cases at each severity as that campaign has, and on the same ones where it has any.
std::vector<Reach> reaches(const Law& law, const Candidate& candidate,
                           const CampaignOptions& options, const RunControl& control = {});

/// The parts of a replay string; throws std::invalid_argument naming the part that is wrong.
struct Replay {
  const Law* law;
  std::string candidate;
  ChosenSource source;
  std::uint64_t seed;
};
Replay parse_replay(std::string_view text);

/// The case of a replay string again, judged and shrunk.
CampaignResult run_replay(const Replay& replay, const Candidate& candidate,
                          std::optional<double> max_error = {});

/// How RapidCheck shows a case.
void showValue(const Case& the_case, std::ostream& out);

}  // namespace raycheck::properties

#endif  // RAYCHECK_PROPERTIES_SEARCH_CAMPAIGN_H_
