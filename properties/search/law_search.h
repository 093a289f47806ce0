#pragma once

// Internal to properties/search/.

#include <cstdint>
#include <optional>
#include <string>

#include "properties/search/campaign.h"

namespace raycheck::properties {

/// Judges a candidate by a law on one case of a source after another, until a case breaks the law.
class LawSearch {
 public:
  /// Law and candidate must outlive it.
  LawSearch(const Law& law, const Candidate& candidate, const CampaignOptions& options,
            const ChosenSource& source)
      : law_(&law), candidate_(&candidate), max_error_(options.max_error), strict_(options.strict) {
    part.source = source;
  }

  CampaignPart part;
  std::optional<Failure> failure;
  bool interrupted = false;

  /// Judges the source's case of a seed, as rounded for the candidate. `trials` is null if the case
  /// is not valid under the candidate's conventions.
  void judge(std::uint64_t seed, const RoundedCase& rounded, Trials* trials);
  /// Judges one case of the source, and shrinks the failure if `shrinks`.
  void replay(std::uint64_t seed, bool shrinks = true);
  /// Restarts the candidate and judges the failure's case again, as the first question. If the
  /// candidate is then right, the failure depends on earlier questions. If it is still wrong on the
  /// case before shrinking, that case replaces the shrunk one.
  void judge_restarted();
  /// Judges an undecided case of the source, and shrinks it as long as it stays undecided.
  void replay_undecided(std::uint64_t seed);
  /// Judges a case, and shrinks it.
  void replay(Case the_case);

 private:
  template <class Work>
  void until_interrupted(const Work& work);
  void judge(std::uint64_t seed);
  std::string replay_of(std::uint64_t seed) const;
  void leave_out(const std::string& reason);
  /// Whether a case breaks the law; counts the cases up to the first that does.
  bool breaks(const Case& the_case);
  /// Whether this verdict on a case breaks the law; counts it like breaks().
  bool take(const Case& the_case, bool judged, bool given, Verdict verdict);
  void count(bool judged, bool given, const Verdict& verdict);
  /// Replaces the failure's case by the first simpler case that breaks the law, as long as there is
  /// one.
  void shrink();
  /// Shrinks while `breaks` is true; it stores each such case as the failure. If the candidate
  /// makes no rays, the rays that it was given replace the camera.
  template <class Breaks>
  void shrink_while(const Breaks& breaks);
  /// If the candidate fails on the case, reduces it to the question that fails. The question is
  /// found by halving, because each simpler case could run into the time limit for a reply.
  void take_failed_question();

  const Law* law_;
  const Candidate* candidate_;
  std::optional<double> max_error_;
  bool strict_;
  std::optional<Case> whole_;  ///< The failure's case before it was shrunk.
};

}  // namespace raycheck::properties
