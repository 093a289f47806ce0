#include <fmt/core.h>

#include <algorithm>

#include "tools/properties/properties.h"
#include "tools/report/words.h"
#include "tools/view/scene_view.h"

namespace raycheck::tools {
namespace {

/// A page has at most this many cases, one for each law and candidate.
constexpr std::size_t kMostCasesShown = 40;

}  // namespace

ViewDocument properties_document(const PropertiesReport& report,
                                 const properties::RunControl& control) {
  ViewDocument document;
  document.title = "broken laws";
  const auto is_shown = [](const CampaignReport& campaign) {
    return campaign.result.failure.has_value();
  };
  const auto broken = static_cast<std::size_t>(std::ranges::count_if(report.campaigns, is_shown));
  const std::size_t shown = std::min(broken, kMostCasesShown);
  if (shown < broken) {
    document.left_out.push_back(fmt::format(
        "cases of {} of {} broken laws; `raycheck properties --filter LAW --view` shows others",
        shown, broken));
  }
  for (const CampaignReport& campaign : report.campaigns) {
    if (control.interrupted() || document.scenes.size() == shown) break;
    if (!is_shown(campaign)) continue;
    const properties::Failure& failure = *campaign.result.failure;
    const auto worst = failure.verdict.worst(1);
    SceneViewOptions view;
    view.name = fmt::format("{}.toml", campaign.law->name);
    view.file = view.name;
    view.limits.panel_bytes = kPanelBytes / shown;
    if (!campaign.implementation.draws()) show(campaign.implementation, view);
    const properties::Place place = worst.empty() ? properties::Place{} : worst.front().place;
    view.wanted = selections_of(failure.shrunk, place);
    document.findings.push_back(
        {fmt::format(
             "{}: {}", campaign.law->name,
             worst.empty() ? std::string(campaign.law->sentence) : discrepancy_head(worst.front())),
         campaign.candidate,
         campaign.implementation.name_in(
             campaign.law->stage.value_or(properties::Stage::kIntersection)),
         worst.empty() ? properties::Standing::kDefect : worst.front().excuse.standing(),
         document.scenes.size(), selection_of(place, failure.shrunk.scene)});
    document.scenes.push_back(view_of(failure.shrunk.scene, view, document.left_out, control));
  }
  document.found = std::to_string(document.findings.size());
  return document;
}

}  // namespace raycheck::tools
