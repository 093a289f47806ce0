#include "tools/properties/campaigns.h"

#include <fmt/core.h>

#include <nlohmann/json.hpp>
#include <stdexcept>

#include "tools/report/json.h"
#include "tools/report/words.h"

namespace raycheck::tools {
namespace {

using properties::CampaignOptions;
using properties::CampaignResult;
using properties::Candidate;
using properties::ChosenSource;
using properties::Failure;
using properties::Law;

std::vector<const Law*> filtered_laws(const std::string& filter) {
  std::vector<const Law*> found;
  for (const Law& law : properties::laws()) {
    if (law.name.find(filter) != std::string_view::npos) found.push_back(&law);
  }
  if (found.empty()) {
    throw std::invalid_argument("--filter " + filter +
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
      throw std::invalid_argument("--source " + name + ": " + error.what() +
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
  switch (law.subject) {
    case Law::Subject::kCamera:
      return pair.intersect == kDefaultMethods.intersect;
    case Law::Subject::kIntersection:
      return pair.rays == kDefaultMethods.rays;
    default:
      return true;
  }
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
  throw std::invalid_argument("--replay: no candidate is called '" + parsed.candidate + "'");
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

namespace {

std::string failure_text(const CampaignReport& campaign, bool colours) {
  const Failure& failure = *campaign.result.failure;
  std::string text = fmt::format("    the law: {}\n", campaign.law->sentence);
  for (const auto& discrepancy : failure.verdict.worst(1)) {
    text += discrepancy_text(discrepancy, "    ", colours);
  }
  text += fmt::format("    replay: raycheck properties --replay {}\n", failure.replay);
  text += "    the shrunk case, as a scene for `raycheck check`:\n";
  const std::string scene = properties::text(
      failure.shrunk,
      fmt::format("breaks the law {} with {}", campaign.law->name, campaign.candidate));
  for (std::size_t at = 0; at < scene.size();) {
    const std::size_t end = std::min(scene.find('\n', at), scene.size());
    text += end == at ? "\n" : fmt::format("      {}\n", scene.substr(at, end - at));
    at = end + 1;
  }
  return text;
}

}  // namespace

std::string properties_text(const PropertiesReport& report, bool colours) {
  std::string text;
  for (const CampaignReport& campaign : report.campaigns) {
    const CampaignResult& result = campaign.result;
    const std::uint64_t compared = result.verdict.compared();
    std::string outcome = "holds";
    if (result.failure) {
      outcome = red("BROKEN", colours);
    } else if (compared == 0) {
      outcome = "left out";
    }
    text += fmt::format("{:<16} {:<26} {}", campaign.law->name, campaign.candidate, outcome);
    if (compared == 0 && !result.failure) {
      text += fmt::format(": {}\n", result.reason);
      continue;
    }
    text += fmt::format(" ({}, {}", count_text(static_cast<std::uint64_t>(result.cases), "case"),
                        count_text(compared, "comparison"));
    if (result.verdict.excused() > 0) text += fmt::format(", {} excused", result.verdict.excused());
    if (result.left_out > 0) {
      text += fmt::format(", {} left out: {}", result.left_out, result.reason);
    }
    text += ")\n";
    if (result.failure) text += failure_text(campaign, colours);
  }
  if (report.interrupted) text += "INTERRUPTED: the laws above are those that were tried.\n";
  const std::uint64_t failures = report.failures();
  text += fmt::format("{}, {} broken\n", count_text(report.campaigns.size(), "campaign"), failures);
  return text;
}

std::string properties_json(const PropertiesReport& report) {
  Json json = json_header("properties");
  json["seed"] = report.seed ? Json(*report.seed) : Json(nullptr);
  json["cases"] = report.cases;
  json["interrupted"] = report.interrupted;
  json["campaigns"] = Json::array();
  for (const CampaignReport& campaign : report.campaigns) {
    const CampaignResult& result = campaign.result;
    Json entry;
    entry["law"] = campaign.law->name;
    entry["sentence"] = campaign.law->sentence;
    entry["candidate"] = campaign.candidate;
    entry["holds"] = !result.failure.has_value();
    entry["cases"] = result.cases;
    entry["comparisons"] = result.verdict.compared();
    entry["excused"] = result.verdict.excused();
    entry["quantities"] = tallies_json(result.verdict);
    entry["left_out"] = result.left_out;
    entry["reason_left_out"] = result.reason.empty() ? Json(nullptr) : Json(result.reason);
    if (result.failure) {
      entry["replay"] = result.failure->replay;
      entry["scene"] = properties::text(result.failure->shrunk);
      entry["discrepancies"] = Json::array();
      for (const auto& discrepancy : result.failure->verdict.worst(10)) {
        entry["discrepancies"].push_back(discrepancy_json(discrepancy));
      }
    }
    json["campaigns"].push_back(std::move(entry));
  }
  json["failures"] = report.failures();
  return json.dump(2) + "\n";
}

}  // namespace raycheck::tools
