#include "tools/view/chart/chart.h"

#include <fmt/core.h>

#include <cctype>

#include "tools/report/words.h"

namespace raycheck::tools {

using properties::Quantity;
using properties::Stage;
using properties::Tally;

std::vector<Quantity> chart_quantities(Stage stage) {
  if (stage == Stage::kRays) return {Quantity::kDirection, Quantity::kPixelPoint};
  return {Quantity::kParameter, Quantity::kBackwardError};
}

std::string chart_stage(Stage stage, scene::Precision precision) {
  std::string text = fmt::format("{}{}", name(stage), precision_words(precision));
  text.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(text.front())));
  return text;
}

std::string chart_title(const ChartFacet& facet) {
  return fmt::format("{} on {}", facet.stage, facet.subject);
}

std::string chart_under(const ChartFacet& facet) {
  return facet.baseline.empty() ? fmt::format("severity: {}", facet.meaning)
                                : fmt::format("run time, times that of {}", facet.baseline);
}

std::string chart_error(Quantity quantity) {
  const std::string_view text = info(quantity).name;
  return fmt::format("{}{}", text, text.ends_with("error") ? "" : " error");
}

std::optional<ChartPoint> chart_point(const std::map<Quantity, Tally>& tallies,
                                      const std::vector<Quantity>& quantities) {
  ChartPoint point;
  std::uint64_t compared = 0;
  for (const auto& [quantity, tally] : tallies) {
    compared += tally.cases;
    if (is_decision(quantity)) {
      point.decisions += tally.cases;
      point.wrong += tally.wrong_answers();
    }
    point.defects += tally.count(properties::Outcome::kWrongDecision);
  }
  if (compared == 0) return std::nullopt;
  for (const Quantity quantity : quantities) {
    ChartPoint::Errors& errors = point.errors.emplace_back();
    const auto found = tallies.find(quantity);
    if (found == tallies.end()) continue;
    const Tally& tally = found->second;
    errors.compared = tally.errors.count();
    for (std::size_t k = 0; k < kChartShares.size(); ++k) {
      const bool is_last = k + 1 == kChartShares.size();
      errors.at[k] = is_last ? tally.max() : tally.quantile(kChartShares[k].share);
      errors.condition[k] = tally.condition_quantile(kChartShares[k].share);
    }
  }
  return point;
}

}  // namespace raycheck::tools
