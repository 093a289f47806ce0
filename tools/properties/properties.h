#ifndef RAYCHECK_TOOLS_PROPERTIES_PROPERTIES_H_
#define RAYCHECK_TOOLS_PROPERTIES_PROPERTIES_H_

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "properties/run_control.h"
#include "properties/search/campaign.h"
#include "tools/external/contestant.h"

namespace raycheck::tools {

struct PropertiesOptions {
  std::string filter;  ///< Laws whose name contains it; empty: all.
  int cases = 100;
  std::uint64_t seed = 1;
  std::string replay;                   ///< Empty: a campaign.
  std::vector<Contestant> contestants;  ///< Empty: each method once.
  std::vector<std::string> sources;     ///< Empty: every source that suits the law.
  std::optional<double> max_error;
};

/// One law on one candidate.
struct CampaignReport {
  const properties::Law* law;
  std::string candidate;
  properties::CampaignResult result;
};

struct PropertiesReport {
  std::vector<CampaignReport> campaigns;
  std::optional<std::uint64_t> seed;  ///< Empty for a replay.
  int cases = 0;
  bool interrupted = false;

  std::uint64_t failures() const;
  std::uint64_t compared() const;
};

/// Runs the campaigns, or replays one failure. Throws std::invalid_argument naming the field.
PropertiesReport run_properties(const PropertiesOptions& options,
                                const properties::RunControl& control = {});

}  // namespace raycheck::tools

#endif  // RAYCHECK_TOOLS_PROPERTIES_PROPERTIES_H_
