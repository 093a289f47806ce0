#include <fmt/format.h>

#include "tools/check/check.h"
#include "tools/check/verify.h"
#include "tools/report/words.h"

namespace raycheck::tools {

std::string verify_text(const VerifyReport& report, const ViewOptions& options) {
  const properties::Verdict& verdict = report.candidate.verdict;
  std::string text = fmt::format("{} to {}\n\n", count_text(report.answers, "answer"),
                                 count_text(report.cases, "case"));
  text += quantities_table(report.candidate, [&](const properties::Place& place) {
    return fmt::format("{}:{}", report.ray_id(place.ray), place.sphere.value_or(0));
  });
  text += too_few_text(report.candidate);
  if (report.interrupted) text += "\nINTERRUPTED: what is above covers only what was judged\n";
  if (report.cases_left_out > 0) {
    text += fmt::format("\n{} ask nothing: floats cannot hold their numbers\n",
                        count_text(report.cases_left_out, "case"));
  }
  if (report.not_answered > 0) {
    const bool is_all = report.missing.size() == report.not_answered;
    text += fmt::format("\n{} not answered: {}{}\n", count_text(report.not_answered, "question"),
                        fmt::join(report.missing, ", "), is_all ? "" : ", ...");
  }
  auto worst = verdict.worst(report.options.top);
  if (verdict.discrepancies() > 0) {
    text += fmt::format(
        "\nworst discrepancies ({} of {}: {}):\n", worst.size(), verdict.discrepancies(),
        standings_text([&](properties::Standing one) { return verdict.count(one); }));
  } else {
    text += verdict.compared() > 0 ? "\nno discrepancy\n" : "\nnothing was checked\n";
  }
  for (std::size_t k = 0; k < worst.size(); ++k) {
    std::size_t& ray = worst[k].place.ray;
    text += fmt::format("{:>3}. {}\n", k + 1, report.ray_id(ray));
    ray = report.ray_in_case(ray);
    text += indented(discrepancy_text(worst[k], options.colours), "     ");
  }
  return text;
}

}  // namespace raycheck::tools
