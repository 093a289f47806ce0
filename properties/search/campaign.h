#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>
#include <deque>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "properties/case.h"
#include "properties/cases/case_source.h"
#include "properties/laws/law.h"
#include "properties/run_control.h"

namespace raycheck::properties {

/// The default number of cases for each law and candidate. 300 cases are enough for the laws to
/// catch every mutant, and correct code perturbed by 2^-46 in s, Q or D, by an epsilon of 1e-12, or
/// within 2^-20 radii of tangency; 500 leave a margin.
inline constexpr int kCampaignCases = 500;

struct CampaignOptions {
  /// For each level up to `level`, this number is divided evenly among the sources of that level,
  /// and within a source among its severities. A severity gets the largest of the numbers from
  /// these levels, so a level includes all cases of lower levels. Every source has at least one
  /// case, at its highest severity.
  int cases = kCampaignCases;
  std::uint64_t seed = 1;
  std::optional<double> max_error;
  bool strict = false;  ///< Whether excused or undecided answers break a law, too.
  /// Severities up to this level are tried.
  Level level = Level::kDemanding;
  /// The sources of the cases; if empty, every source of the level that suits the law. A source
  /// without a severity stands for all its severities of the level.
  std::vector<ChosenSource> sources = {};
  /// The number of distinct failures to shrink: above one, a law's cases go on after a break.
  std::size_t keep_going = 1;
};

/// Counts of cases by their treatment.
struct CaseCounts {
  std::int64_t cases = 0;  ///< The number of cases tried, until the end or the first break.
  /// Cases to which the law does not apply, or which the candidate's format cannot hold.
  std::int64_t left_out = 0;
  std::int64_t not_judged = 0;  ///< Cases outside the candidate's stated domain.
  std::int64_t given_rays = 0;  ///< Cases judged on raycheck's rays (given_rays()).
  std::string reason;           ///< Why the last case that was left out was left out.

  void add(const CaseCounts& other);
  void serialize(auto& archive) { archive(cases, left_out, not_judged, given_rays, reason); }
};

/// A case that breaks a law.
struct Break {
  /// The replay string, "LAW:CANDIDATE:SOURCE:SEED"; SOURCE may be SOURCE@SEVERITY.
  std::string replay;
  std::vector<DefectKind> defects;
  std::optional<CodeLine> failed_at = {};  ///< Where the candidate died or threw.
  void serialize(auto& archive) { archive(replay, defects, failed_at); }
};

/// A law's verdict on the cases of one source and, if the source has severities, of one severity.
/// It ends at the first case that breaks the law, unless CampaignOptions::keep_going is above one.
struct CampaignPart {
  ChosenSource source;
  CaseCounts counts;
  Verdict verdict;  ///< Only counts, since there are thousands of parts.
  /// The first case that breaks the law, and later ones that show other kinds of defects.
  std::vector<Break> breaks;
  std::vector<DefectKind> undecided;            ///< The undecided kinds of all its cases.
  std::optional<std::uint64_t> undecided_seed;  ///< The seed of the first undecided case.

  bool failed_at_once = false;  ///< Whether the candidate failed before it answered anything.
  bool timed_out = false;       ///< Whether a case broke the law because the candidate timed out.

  bool is_broken() const { return !breaks.empty(); }
  /// Whether one of these kinds of defects is not among those of the known breaks.
  bool is_new(const std::vector<DefectKind>& defects) const;
  /// Adds later cases of the same source and severity.
  void merge(CampaignPart later);
  /// Called after the last case: stores the undecided kinds.
  void close(bool strict);
  /// Does not contain the source.
  void serialize(auto& archive) {
    archive(counts, verdict, breaks, undecided, undecided_seed, failed_at_once, timed_out);
  }
};

/// A case that breaks a law, or leaves it undecided, shrunk as long as it does so.
struct Failure {
  Case shrunk;
  Verdict verdict;
  std::string replay;
  bool is_undecided = false;
  /// Whether the candidate is right on the shrunk case after a restart: it keeps state between
  /// questions.
  bool is_of_earlier = false;
  /// The number of tries after which shrinking was given up; 0 if it was completed.
  std::int64_t tries = 0;
  /// False: the case as it was found, since the candidate fails on every question or depends on
  /// earlier ones, or since the search was interrupted.
  bool is_shrunk = true;
};

/// A law holds only if at least this many answers to each kind of question (hits, for example) were
/// right without an excuse. Ten questions expose code that is right half of the time, at random,
/// with a probability of 999 in 1000.
inline constexpr std::uint64_t kFewestRight = 10;

/// A law is undecided if more than one in this many of its comparisons are; fewer are counted.
inline constexpr std::uint64_t kComparisonsOfUndecided = 200;

/// The outcome of a law for a candidate.
enum class Finding { kHolds, kBroken, kUndecided, kTooFewJudged, kNotJudged, kLeftOut };
inline constexpr std::array<std::string_view, 6> kFindingNames = {
    "holds", "broken", "undecided", "too few judged", "not judged here", "left out"};
constexpr auto& names_of(Finding /*of*/) { return kFindingNames; }

struct CampaignResult {
  Level level = Level::kDemanding;
  std::vector<CampaignPart> parts;  ///< In the order of sources and severities.
  CaseCounts counts;                ///< Of all parts together, without shrinking.
  Verdict verdict;                  ///< Of all parts together, without shrinking.
  /// The failure of the first broken part of the lowest level; if no part is broken, of the first
  /// part with an undecided case.
  std::optional<Failure> failure;
  /// Further failures, each of another source or kind, if keep_going is above one.
  std::vector<Failure> others = {};

  std::uint64_t fewest_right = kFewestRight;  ///< 0 for a replay, whose one case is enough.
  /// Whether hits must be among the questions, because the candidate declares which roots count,
  /// and may exclude all.
  bool wants_hits = false;

  Finding finding() const;
  /// The first kind of question with too few right answers; empty if there is none.
  std::optional<std::pair<Quantity, Expected>> too_few_right() const {
    return verdict.too_few_right(fewest_right, wants_hits);
  }
};

/// Cases from which the cause of a broken law may be found. Round 0 has `most` cases at the lowest
/// level at which the law is broken: the first case that broke it at each source and severity, and
/// further cases of these, right or wrong. Unless all sources break the law, `most` cases of all
/// sources follow, to rule out causes that would break these. Round 1 has four times as many cases
/// of each kind. Rounds 2 and 3 do the same at the next level at which the law is broken, and so
/// on. Empty after the last round.
std::vector<Case> telling_cases(const CampaignResult& result, std::size_t most,
                                std::size_t round = 0);

/// The number of cases in a unit of a small campaign: so few that threads end together.
inline constexpr int kUnitCases = 64;
/// In a large campaign, units have kUnitCases times a power of two cases, so that there are at most
/// about this many units.
inline constexpr std::int64_t kMostUnits = 1 << 14;
constexpr std::int64_t pieces_of_unit(std::int64_t all_pieces) {
  std::int64_t pieces = 1;
  while (all_pieces / pieces > kMostUnits) pieces *= 2;
  return pieces;
}

/// A candidate is dropped after this number of units without an answer, after this number of units
/// in which it times out, or if it times out before it has answered anything.
inline constexpr std::size_t kUnitsToFail = 3;

/// The laws by which a candidate is tested, and the options.
struct LawsOfCandidate {
  std::vector<const Law*> laws;
  CampaignOptions options;  ///< The seed and the sources must be the same for all candidates.
};

/// The sources on which a law is tried, each at its severities.
std::vector<ChosenSource> sources_of(const Law& law, const CampaignOptions& options);

/// Runs the campaigns of several candidates and laws in one pass: for all laws that are tried on a
/// case, the case is made once, its truth is computed once, and each candidate is asked once. The
/// work is divided into units. A unit is some cases of one source at one severity. Units are
/// independent: any thread, process or machine may run any of them.
/// Domain: at least one candidate; `candidates[k]` is the candidate of `of_candidates[k]`.
class Campaigns {
 public:
  /// `units_are_kept`: whether units are stored, so that a unit's result must depend only on the
  /// unit. If not, a unit leaves out laws that an earlier unit broke.
  explicit Campaigns(std::vector<LawsOfCandidate> of_candidates, bool units_are_kept = false);

  std::size_t unit_count() const { return unit_count_; }
  /// The results of a unit's cases, for each law of each candidate that is tried on them. An
  /// interrupt ends a unit early. Discrepancies are only counted.
  std::vector<CampaignPart> run(std::size_t unit, std::span<const Candidate> candidates,
                                const RunControl& control) const;
  /// Adds the results of run(), in the order of units.
  void take(std::size_t unit, std::vector<CampaignPart> parts);
  /// The result of all units for a law of a candidate, with its failure shrunk. To be called once
  /// for each.
  CampaignResult finished(std::size_t candidate, std::size_t law, const Candidate& judged);

 private:
  /// A law of a candidate, both by index, on the cases of a series.
  struct Tried {
    Tried(std::size_t of_candidate, std::size_t its_law, int in_series)
        : candidate(of_candidate), law(its_law), cases(in_series) {}
    std::size_t candidate, law;
    int cases;
    /// The first unit in which the law is broken: later ones do not count.
    mutable std::atomic<std::size_t> broken_in = std::numeric_limits<std::size_t>::max();
  };
  /// A source at a severity.
  struct Series {
    ChosenSource source;
    std::deque<Tried> tried;  ///< Candidate after candidate.
    std::size_t first_unit = 0;
    /// The largest number of cases of a law.
    int most() const { return std::ranges::max_element(tried, {}, &Tried::cases)->cases; }
  };
  struct Unit {
    const Series& series;
    int number;  ///< In the series.
  };
  /// A candidate's campaigns, and whether it is asked any more.
  struct OfCandidate {
    LawsOfCandidate asked;
    std::vector<CampaignResult> results;  ///< By law.
    bool has_answered = false;
    std::size_t units_failed = 0;  ///< In which it only failed, before it answered anything.
    std::size_t units_timed_out = 0;
    std::atomic<bool> is_dropped = false;  ///< As kUnitsToFail says.
    bool answers_nothing() const { return units_failed == kUnitsToFail; }
  };
  Unit unit(std::size_t number) const;

  std::vector<OfCandidate> candidates_;
  std::deque<Series> series_;  ///< In the order of sources and severities.
  std::size_t unit_count_ = 0;
  int unit_cases_ = kUnitCases;
  bool units_are_kept_;
};

/// Runs a law on random cases (by RapidCheck's streams) of every source and severity, each with its
/// own seed: a broken part does not end the others. The same options give the same result. Another
/// source changes only the number of cases that each source gets.
CampaignResult run_campaign(const Law& law, const Candidate& candidate,
                            const CampaignOptions& options, const RunControl& control = {});

/// Whether a case and a candidate meet a law's needs; if necessary, with raycheck's rays.
bool has_question(const Law& law, const Candidate& candidate, const Case& the_case);

/// The parts of a replay string; throws std::invalid_argument naming the part that is wrong.
struct Replay {
  const Law* law;
  std::string candidate;
  ChosenSource source;
  std::uint64_t seed;
};
Replay parse_replay(std::string_view text);

/// Judges and shrinks a given case.
CampaignResult run_case(const Law& law, const Candidate& candidate, const Case& the_case,
                        std::optional<double> max_error = {}, bool strict = false);

/// Judges and shrinks the case of a replay string again.
CampaignResult run_replay(const Replay& replay, const Candidate& candidate,
                          std::optional<double> max_error = {}, bool strict = false);

}  // namespace raycheck::properties
