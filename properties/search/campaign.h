#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "properties/cases/case_source.h"
#include "properties/laws/law.h"
#include "properties/level.h"
#include "properties/run_control.h"

namespace raycheck::properties {

/// Cases for each law and candidate: 300 are enough that every mutant is caught by its laws, and so
/// is right code made wrong by 2^-46 in s, Q or D, by an epsilon of 1e-12, or in a band of 2^-20 at
/// tangency.
inline constexpr int kCampaignCases = 500;

struct CampaignOptions {
  /// Shared evenly among the sources, and within a source among its severities; every source has at
  /// least one, at its highest severity.
  int cases = kCampaignCases;
  std::uint64_t seed = 1;
  std::optional<double> max_error;
  bool strict = false;  ///< What is excused or undecided breaks a law, too.
  /// Severities of this level and of those before it are asked.
  Level level = Level::kDemanding;
  /// Where cases come from; empty: every source of the level that suits the law. One without a
  /// severity stands for its severities of the level, one with a severity for that, of any level.
  std::vector<ChosenSource> sources;
};

/// What became of cases, all of which are counted once.
struct CaseCounts {
  int cases = 0;       ///< Tried, before an end or a break.
  int left_out = 0;    ///< Of those, the ones that the law had nothing to say about, or that the
                       ///< candidate's format cannot hold,
  int not_judged = 0;  ///< and those outside the candidate's stated domain.
  int given_rays = 0;  ///< Of all, those whose camera's rays were raycheck's own (given_rays.h).
  std::string reason;  ///< Why the last of those left out was.

  void add(const CaseCounts& other);
};

/// What a law says of the cases of one source, at one severity where it has a dial. The first case
/// that breaks it ends them.
struct CampaignPart {
  ChosenSource source;
  CaseCounts counts;
  Verdict verdict;  ///< Its counts alone: there are thousands of parts.
  /// Finds the case that breaks it again: "LAW:CANDIDATE:SOURCE:SEED"; a SOURCE may be
  /// SOURCE@SEVERITY. Empty where the law is not broken.
  std::string replay;
  std::vector<DefectKind> defects;    ///< What that case shows,
  std::optional<CodeLine> failed_at;  ///< and the line at which the candidate died or threw there.
  std::vector<DefectKind> undecided;  ///< What is left undecided of all its cases.

  bool is_broken() const { return !replay.empty(); }
};

/// A case found to break a law, shrunk while it still does.
struct Failure {
  Case shrunk;
  Verdict verdict;
  std::string replay;
};

/// A law that was asked about hits, say, on random cases shows too little to hold before so many
/// hits were found without an excuse, and so of each kind of question: one that answers right at
/// random, every other time, is found out by ten with a chance of 999 in 1000.
inline constexpr std::uint64_t kFewestRight = 10;

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

  std::uint64_t fewest_right = kFewestRight;  ///< 0 of a replay: its one case is enough.
  /// Who declares which roots count may have declared that none does: hits have to be asked.
  bool wants_hits = false;

  Finding finding() const;
  /// The first kind of question of which fewer answers are right than are needed.
  std::optional<std::pair<Quantity, Expected>> too_few_right() const {
    return verdict.too_few_right(fewest_right, wants_hits);
  }
};

/// At most so many cases that may tell why a law is broken: of the lowest level at which it is, the
/// first that broke it at each source and severity, then others of the same, whatever they show.
std::vector<Case> telling_cases(const CampaignResult& result, std::size_t most);

/// Runs a law on random cases (by RapidCheck's streams) of every source and severity, each
/// of which has a seed of its own: a break of one ends no other. The same options give the same
/// result, and a part is the same whatever other parts there are, but for the number of its cases.
CampaignResult run_campaign(const Law& law, const Candidate& candidate,
                            const CampaignOptions& options, const RunControl& control = {});

/// Whether a case and a candidate have what a law needs, if need be on raycheck's own rays.
bool has_question(const Law& law, const Candidate& candidate, const Case& the_case);

/// How far along a family's dial a law holds.
struct Reach {
  const CaseSource* family = nullptr;
  /// The highest severity that was judged before the first broken one; empty where there is none.
  std::optional<int> holds_to;
  std::optional<int> broken_at;  ///< Empty: nowhere on the dial.
  std::string replay;            ///< Of broken_at.
};

/// How far a law holds is not said by fewer cases at a severity.
inline constexpr int kFewestOfReach = 20;

/// Follows the dial of every source that stands for its severities in a campaign of these options,
/// through the level and beyond it, to the first severity that breaks the law or to the end: on
/// kFewestOfReach cases at each severity, or as many as that campaign has, the same ones first.
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

/// A case of one's own, judged and shrunk.
CampaignResult run_case(const Law& law, const Candidate& candidate, const Case& the_case,
                        std::optional<double> max_error = {}, bool strict = false);

/// The case of a replay string again, judged and shrunk.
CampaignResult run_replay(const Replay& replay, const Candidate& candidate,
                          std::optional<double> max_error = {}, bool strict = false);

}  // namespace raycheck::properties
