#pragma once

#include "properties/search/campaign.h"
#include "tests/standard.h"

namespace raycheck {

/// This number of cases of all or some sources, at the hardest level.
inline properties::CampaignOptions options_of(
    int cases, std::initializer_list<std::string_view> sources = {},
    properties::Level level = properties::Level::kExtreme) {
  properties::CampaignOptions options;
  options.cases = cases;
  options.level = level;
  for (const std::string_view source : sources) {
    options.sources.push_back(properties::chosen_source(source));
  }
  return options;
}

/// The campaigns of these laws in one pass: each case is made once, its exact answer is computed
/// once, and the candidate is asked once for all of them.
inline std::vector<properties::CampaignResult> run_campaigns(
    const std::vector<const properties::Law*>& laws, const properties::Candidate& candidate,
    const properties::CampaignOptions& options) {
  properties::Campaigns campaigns({{laws, options}});
  for (std::size_t unit = 0; unit < campaigns.unit_count(); ++unit) {
    campaigns.take(unit, campaigns.run(unit, {&candidate, 1}, {}));
  }
  std::vector<properties::CampaignResult> results;
  for (std::size_t law = 0; law < laws.size(); ++law) {
    results.push_back(campaigns.finished(0, law, candidate));
  }
  return results;
}

/// Throws if a name is unknown.
inline std::vector<const properties::Law*> laws_named(const std::vector<std::string_view>& names) {
  std::vector<const properties::Law*> laws;
  for (const std::string_view name : names) {
    laws.push_back(properties::find_law(name));
    if (laws.back() == nullptr) throw std::invalid_argument(std::string(name));
  }
  return laws;
}

}  // namespace raycheck
