#include <fmt/core.h>

#include "properties/cases/case_text.h"
#include "tools/properties/properties_views.h"
#include "tools/report/words.h"

namespace raycheck::tools {
namespace {

std::string failure_text(const CampaignReport& campaign, bool colours) {
  const properties::Failure& failure = *campaign.result.failure;
  std::string text = fmt::format("    the law: {}\n", campaign.law->sentence);
  for (const auto& discrepancy : failure.verdict.worst(1)) {
    text += indented(discrepancy_text(discrepancy, colours), "    ");
  }
  text += fmt::format("    replay: raycheck properties --replay {}\n", failure.replay);
  text += "    the shrunk case, as a scene for `raycheck check`:\n";
  const std::string reason =
      fmt::format("breaks the law {} with {}", campaign.law->name, campaign.candidate);
  text += indented(properties::scene_text(failure.shrunk, reason), "      ");
  return text;
}

}  // namespace

std::string properties_text(const PropertiesReport& report, const ViewOptions& options) {
  std::string text;
  for (const CampaignReport& campaign : report.campaigns) {
    const properties::CampaignResult& result = campaign.result;
    const std::uint64_t compared = result.verdict.compared();
    std::string outcome = "holds";
    if (result.failure) {
      outcome = red("BROKEN", options.colours);
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
    const std::uint64_t excused = result.verdict.count(properties::Standing::kExcused);
    if (excused > 0) text += fmt::format(", {} excused", excused);
    if (result.left_out > 0) {
      text += fmt::format(", {} left out: {}", result.left_out, result.reason);
    }
    text += ")\n";
    if (result.failure) text += failure_text(campaign, options.colours);
  }
  if (report.interrupted) text += "INTERRUPTED: the laws above are those that were tried.\n";
  const std::uint64_t failures = report.failures();
  text += fmt::format("{}, {} broken\n", count_text(report.campaigns.size(), "campaign"), failures);
  return text;
}

}  // namespace raycheck::tools
