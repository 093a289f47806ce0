#include <fmt/core.h>

#include "tools/check/check_views.h"
#include "tools/exchange/verify_views.h"
#include "tools/report/words.h"

namespace raycheck::tools {

std::string verify_text(const VerifyReport& report, const ViewOptions& options) {
  const properties::Verdict& verdict = report.candidate.verdict;
  std::string text = fmt::format("{} to {}\n\n", count_text(report.answers, "answer"),
                                 count_text(report.cases, "case"));
  text += quantities_table(report.candidate);
  text += too_few_text(report.candidate);
  if (report.is_short()) {
    text += fmt::format("\n{} of {} are not answered\n", report.cases_asked - report.cases,
                        count_text(report.cases_asked, "case"));
  }
  const auto worst = verdict.worst(report.top);
  if (verdict.discrepancies() > 0) {
    text += fmt::format(
        "\nworst discrepancies ({} of {}: {}):\n", worst.size(), verdict.discrepancies(),
        standings_text([&](properties::Standing one) { return verdict.count(one); }));
  } else {
    text += verdict.compared() > 0 ? "\nno discrepancy\n" : "\nnothing was checked\n";
  }
  for (std::size_t k = 0; k < worst.size(); ++k) {
    text += fmt::format("{:>3}. {}\n", k + 1, report.ids.at(worst[k].place.ray));
    text += indented(discrepancy_text(worst[k], options.colours), "     ");
  }
  return text;
}

}  // namespace raycheck::tools
