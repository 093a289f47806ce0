#include "tools/properties/properties.h"

#include <fmt/core.h>

#include <stdexcept>

namespace raycheck::tools {
namespace {

using properties::CampaignOptions;
using properties::Candidate;
using properties::ChosenSource;
using properties::Law;

std::vector<const Law*> filtered_laws(const std::string& filter) {
  std::vector<const Law*> found;
  for (const Law& law : properties::laws()) {
    if (law.name.find(filter) != std::string_view::npos) found.push_back(&law);
  }
  if (found.empty()) {
    throw std::invalid_argument("filter " + filter +
                                ": no law's name contains it; `raycheck list` shows the laws");
  }
  return found;
}

std::vector<ChosenSource> chosen_sources(const std::vector<std::string>& names) {
  std::vector<ChosenSource> chosen;
  for (const std::string& name : names) {
    try {
      chosen.push_back(properties::chosen_source(name));
    } catch (const std::invalid_argument& error) {
      throw std::invalid_argument("source " + name + ": " + error.what() +
                                  "; `raycheck list` shows the sources");
    }
  }
  return chosen;
}

/// Whether a law can tell this pair from one that is already asked: laws of the camera alone do not
/// see the intersection, those of the intersection alone hardly see the ray method.
bool is_worth_asking(const Law& law, const Contestant& contestant, bool chosen_by_user) {
  const MethodPair* const methods = methods_of(contestant);
  if (chosen_by_user || methods == nullptr) return true;
  const MethodPair& pair = *methods;
  if (speaks_of_cameras(law) == speaks_of_intersections(law)) return true;
  return speaks_of_cameras(law) ? pair.intersect == kDefaultMethods.intersect
                                : pair.rays == kDefaultMethods.rays;
}

/// A renderer is not told the conventions of a random case: it is judged by the default ones, and
/// not at tangents.
Candidate campaigner(const Contestant& contestant) {
  Candidate candidate = candidate_of(contestant);
  if (candidate.image) {
    candidate.declared = {scene::Rows{}, scene::Samples{}, scene::Origin{}, scene::Root{},
                          scene::Tangent::kEither};
  }
  return candidate;
}

PropertiesReport replay(const PropertiesOptions& options) {
  const properties::Replay parsed = properties::parse_replay(options.replay);
  std::vector<Contestant> known = options.contestants;
  for (const MethodPair& pair : all_pairs()) known.emplace_back(pair);
  for (const Contestant& contestant : known) {
    const Candidate candidate = campaigner(contestant);
    if (candidate.name != parsed.candidate) continue;
    PropertiesReport report;
    report.cases = 1;
    report.campaigns.push_back(
        {parsed.law, candidate.name, run_replay(parsed, candidate, options.max_error)});
    return report;
  }
  throw std::invalid_argument("replay: no candidate is called '" + parsed.candidate + "'");
}

}  // namespace

std::uint64_t PropertiesReport::failures() const {
  std::uint64_t count = 0;
  for (const CampaignReport& campaign : campaigns) count += campaign.result.failure ? 1 : 0;
  return count;
}

std::uint64_t PropertiesReport::compared() const {
  std::uint64_t count = 0;
  for (const CampaignReport& campaign : campaigns) count += campaign.result.verdict.compared();
  return count;
}

PropertiesReport run_properties(const PropertiesOptions& options,
                                const properties::RunControl& control) {
  if (!options.replay.empty()) return replay(options);
  PropertiesReport report;
  report.seed = options.seed;
  report.cases = options.cases;
  CampaignOptions campaign;
  campaign.cases = options.cases;
  campaign.seed = options.seed;
  campaign.max_error = options.max_error;
  campaign.sources = chosen_sources(options.sources);
  const bool chosen = !options.contestants.empty();
  const auto judged = chosen ? options.contestants : contestants(each_method_once());
  const auto laws = filtered_laws(options.filter);
  for (const Law* law : laws) {
    for (const Contestant& contestant : judged) {
      if (control.interrupted() || !is_worth_asking(*law, contestant, chosen)) continue;
      const Candidate candidate = campaigner(contestant);
      control.progress(fmt::format("{} on {}", law->name, candidate.name));
      report.campaigns.push_back(
          {law, candidate.name, run_campaign(*law, candidate, campaign, control)});
    }
  }
  report.interrupted = control.interrupted();
  return report;
}

}  // namespace raycheck::tools
