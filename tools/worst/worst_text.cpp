#include <fmt/core.h>

#include <array>

#include "properties/cases/case_text.h"
#include "tools/report/words.h"
#include "tools/worst/worst.h"

namespace raycheck::tools {
namespace {

std::string headline(const WorstReport& report) {
  const properties::WorstCase& worst = *report.worst;
  return fmt::format("{} {} on {}: off by {} {}, condition number {}, rho {}: {}",
                     report.candidate.name, info(report.search.quantity).name,
                     report.source().name(), error_text(worst.error),
                     unit_name(report.search.quantity, report.candidate.precision),
                     error_text(worst.stability.condition), error_text(worst.stability.ratio),
                     name(worst.stability.outcome));
}

std::string failures_text(const WorstReport& report) {
  if (report.failures == 0) return "";
  return fmt::format("failed {}, first: {}\n",
                     report.failures == 1 ? "once" : fmt::format("{} times", report.failures),
                     report.first_failure);
}

}  // namespace

std::string worst_text(const WorstReport& report, const ViewOptions& /*options*/) {
  const std::string others = isolation_text({report.candidate}) + failures_text(report);
  if (!report.worst) {
    return others + fmt::format(
                        "{} on {}: nothing was measured: each case lies outside the judged domain, "
                        "or its answer failed, is a wrong decision, or is not finite\n",
                        report.candidate.name, report.source().name());
  }
  const properties::WorstCase& worst = *report.worst;
  std::string text = others + headline(report) + "\n";
  constexpr std::array<std::string_view, 3> kMeasures = {"error", "error / growth of the bound",
                                                         "stability ratio rho"};
  text += report.stage == properties::Stage::kRays
              ? fmt::format(
                    "only the {} is measured; `raycheck properties` also judges other quantities\n",
                    info(report.search.quantity).name)
              : "only errors of right decisions are measured; `raycheck properties` also judges "
                "decisions\n";
  text += fmt::format(
      "rho = error / ((1 + condition number) u), with k u for an error of k ulp; at most {:g} is "
      "stable\n"
      "largest {}: {} among random cases, {} after climbing from the worst of them; the case below "
      "is simplified and has {}\n",
      properties::kStableRatio, kMeasures[static_cast<std::size_t>(report.search.climb)],
      error_text(worst.height_random), error_text(worst.height_climbed), error_text(worst.height));
  text += fmt::format("  got   {}\n  exact {}\n\n", got_text(worst.shown), exact_text(worst.shown));
  return text + properties::scene_text(worst.the_case);
}

std::string worst_scene(const WorstReport& report) {
  return properties::scene_text(report.worst->the_case, headline(report));
}

}  // namespace raycheck::tools
