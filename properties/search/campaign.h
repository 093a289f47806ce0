#ifndef RAYCHECK_PROPERTIES_SEARCH_CAMPAIGN_H_
#define RAYCHECK_PROPERTIES_SEARCH_CAMPAIGN_H_

#include <cstdint>
#include <iosfwd>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "properties/cases/case_source.h"
#include "properties/laws/law.h"
#include "properties/run_control.h"

namespace raycheck::properties {

/// A case found to break a law, shrunk while it still does.
struct Failure {
  Case shrunk;
  Verdict verdict;
  std::string replay;  ///< Finds it again: "LAW:CANDIDATE:SOURCE:SEED"; a SOURCE may be
                       ///< SOURCE@SEVERITY.
};

struct CampaignOptions {
  int cases = 100;
  std::uint64_t seed = 1;
  std::optional<double> max_error;
  /// Where cases come from; empty: every source that suits the law.
  std::vector<ChosenSource> sources;
};

struct CampaignResult {
  int cases = 0;       ///< Cases judged before the campaign ended or failed.
  int left_out = 0;    ///< Of those, the ones that the law had nothing to say about.
  std::string reason;  ///< Why the last of them was left out.
  Verdict verdict;     ///< All cases together, shrinking aside.
  std::optional<Failure> failure;
};

/// Runs a law on random cases (RapidCheck generates and shrinks) until one breaks it without an
/// excuse. The same options give the same result.
CampaignResult run_campaign(const Law& law, const Candidate& candidate,
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
