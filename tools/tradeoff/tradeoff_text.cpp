#include <fmt/format.h>
#include <fmt/ranges.h>

#include "tools/report/table.h"
#include "tools/report/words.h"
#include "tools/tradeoff/tradeoff.h"

namespace raycheck::tools {
namespace {

using properties::Quantity;
using properties::Tally;
using properties::Verdict;
using properties::Wrong;

std::string duration_text(const std::optional<Duration>& duration) {
  return duration ? fmt::format("{:.1f}", duration->median) : "-";
}

/// "12.3 (12.1..12.6)"
std::string spread_text(const std::optional<Duration>& duration) {
  if (!duration) return "-";
  return fmt::format("{:.1f} ({:.1f}..{:.1f})", duration->median, duration->low, duration->high);
}

/// The number of hit classes that were wrong in this way, per million decisions.
std::string per_million(const Verdict& verdict, Wrong wrong) {
  const Tally& tally = verdict.tally(Quantity::kClass);
  if (tally.cases == 0) return "-";
  return error_text(1e6 * static_cast<double>(tally.count(wrong)) /
                    static_cast<double>(tally.cases));
}

std::string max_text(const Verdict& verdict, Quantity quantity) {
  return error_text(verdict.tally(quantity).max());
}

/// The largest audited error, divided by the factor by which the bound grows.
std::string audited_text(const Verdict& verdict, Quantity quantity) {
  return error_text(verdict.tally(quantity).max_over_growth);
}

std::string quantile_text(const Verdict& verdict, Quantity quantity, double share) {
  return error_text(verdict.tally(quantity).quantile(share));
}

std::string ratio_text(const Verdict& verdict) {
  return error_text(properties::worst_ratio(verdict));
}

/// The bound on an error for given rays, if the error was measured.
std::string bound_text(const MethodCost& cost, Quantity quantity) {
  if (cost.accuracy.inside.tally(quantity).cases == 0) return "-";
  return error_text(documented_bound(cost.promises, quantity, false));
}

std::string stability_text(const MethodCost& cost) {
  if (cost.accuracy.inside.compared() == 0) return "-";
  if (cost.unstable_on.empty()) return "all";
  return fmt::format("all but {}", fmt::join(cost.unstable_on, ", "));
}

std::string name_text(const MethodCost& cost) {
  return (cost.pareto ? "* " : "  ") + cost.candidate.name;
}

std::string time_ratio_text(const MethodCost& cost, const MethodCost* baseline) {
  if (!cost.batch) return "-";
  return fmt::format("{:.2f}", cost.batch->median / baseline->batch->median);
}

/// The table for candidates that are judged in one format, so that their errors have the same unit.
Table intersection_table(const std::vector<MethodCost>& costs, scene::Precision precision) {
  Table table({"  method", ">ns a call", ">ns in a batch", ">ratio",
               fmt::format(">median {}", unit_name(Quantity::kParameter, precision)), ">99.9%",
               ">max", ">audited", ">bound", ">missed/M", ">false/M", ">defects",
               fmt::format(">backward {}", unit_name(Quantity::kBackwardError, precision)),
               ">max rho", ">outside: max", ">missed/M", ">false/M", "stable on"});
  const MethodCost* const base = baseline(costs);
  for (const MethodCost& cost : costs) {
    if (cost.promises.precision != precision) continue;
    const Verdict& inside = cost.accuracy.inside;
    const Verdict& outside = cost.accuracy.outside;
    table.add({name_text(cost), duration_text(cost.scalar), spread_text(cost.batch),
               time_ratio_text(cost, base), quantile_text(inside, Quantity::kParameter, 0.5),
               quantile_text(inside, Quantity::kParameter, 0.999),
               max_text(inside, Quantity::kParameter), audited_text(inside, Quantity::kParameter),
               bound_text(cost, Quantity::kParameter), per_million(inside, Wrong::kMissed),
               per_million(inside, Wrong::kFalseHit), std::to_string(properties::defects(inside)),
               max_text(inside, Quantity::kBackwardError), ratio_text(inside),
               max_text(outside, Quantity::kParameter), per_million(outside, Wrong::kMissed),
               per_million(outside, Wrong::kFalseHit), stability_text(cost)});
  }
  return table;
}

Table ray_table(const std::vector<MethodCost>& costs, scene::Precision precision) {
  Table table({"  method", ">ns a call", ">ns in a batch", ">ratio",
               fmt::format(">median {} of D", unit_name(Quantity::kDirection, precision)), ">99.9%",
               ">max", ">audited", ">bound",
               fmt::format(">audited {} of P", unit_name(Quantity::kPixelPoint, precision)),
               ">bound", ">max rho", "stable on"});
  const MethodCost* const base = baseline(costs);
  for (const MethodCost& cost : costs) {
    if (cost.promises.precision != precision) continue;
    const Verdict& inside = cost.accuracy.inside;
    table.add({name_text(cost), duration_text(cost.scalar), spread_text(cost.batch),
               time_ratio_text(cost, base), quantile_text(inside, Quantity::kDirection, 0.5),
               quantile_text(inside, Quantity::kDirection, 0.999),
               max_text(inside, Quantity::kDirection), audited_text(inside, Quantity::kDirection),
               bound_text(cost, Quantity::kDirection), audited_text(inside, Quantity::kPixelPoint),
               bound_text(cost, Quantity::kPixelPoint), ratio_text(inside), stability_text(cost)});
  }
  return table;
}

std::string legend(std::string_view item, bool has_single) {
  std::string text = fmt::format(
      "\n{0}*: no other method is at least as good in all three: ns in a batch, the share of "
      "defects "
      "and the 99.9% error\n"
      "{0}ns: the median (and the quartiles) of repetitions, interleaved over the methods; ratio: "
      "ns "
      "in a batch, divided by those of the first method; a call to make rays includes the setup of "
      "its camera\n"
      "{0}/M: per million decisions; defects: failed answers, and wrong decisions that no relative "
      "change of the inputs by {1:g} u would make right\n"
      "{0}bound: the error bound that the method documents up to the condition number {2:g}, above "
      "which it grows in proportion; audited: the largest value of error / max(1, condition "
      "number / {2:g}), which is within the bound, except for methods that do not keep theirs "
      "(`raycheck list`)\n"
      "{0}stable: no defect, and rho = error / ((1 + kappa) u) is at most {3:g}; kappa is the "
      "condition number\n"
      "{0}outside: inputs outside the method's stated domain\n",
      item, properties::kExcusedChange / properties::kDoubleRoundoff,
      properties::kModerateCondition, properties::kStableRatio);
  if (!has_single) return text;
  return text + fmt::format(
                    "{}in single precision: u and ulp are those of float, 2^29 times those of "
                    "double; for *, all errors are converted to those of double\n",
                    item);
}

/// The isolation of external candidates, and the names of those that are timed in this process.
std::string others_text(const TradeoffReport& report, std::string_view item) {
  std::vector<Implementation> methods;
  std::string called_here;
  for (const auto* costs : {&report.rays, &report.intersections}) {
    std::vector<std::string> names;
    for (const MethodCost& cost : *costs) {
      methods.push_back(cost.candidate);
      if (cost.is_called_here) names.push_back(cost.candidate.name);
    }
    if (names.empty()) continue;
    called_here += fmt::format("{}{} of {}", called_here.empty() ? "" : "; ",
                               name(costs->front().stage), fmt::join(names, ", "));
  }
  std::string text = indented(isolation_text(methods), item);
  if (!text.empty()) text = "\n" + text;
  if (called_here.empty()) return text;
  return text + fmt::format(
                    "{}timed in raycheck's process (--sandbox none), by the same loops, after a "
                    "check that "
                    "they answer there as they did when they were judged: {}\n",
                    item, called_here);
}

/// The answers that external candidates failed to give.
std::string failures_text(const TradeoffReport& report, std::string_view item) {
  std::string text;
  for (const auto* costs : {&report.rays, &report.intersections}) {
    for (const MethodCost& cost : *costs) {
      const auto failed = properties::answers_failed(cost.accuracy);
      if (failed.count == 0) continue;
      text += fmt::format("{}{} ({}): {} failed, first: {}\n", item, cost.candidate.name,
                          name(cost.stage), count_text(failed.count, "answer"), failed.first);
    }
  }
  return text;
}

std::vector<std::string> left_out_of(const TradeoffReport& report) {
  std::vector<std::string> notes = report.left_out;
  for (const auto* costs : {&report.rays, &report.intersections}) {
    for (const MethodCost& cost : *costs) {
      if (cost.accuracy.left_out > 0) {
        notes.push_back(fmt::format("{} ({}): {}, not representable in floats", cost.candidate.name,
                                    name(cost.stage), count_text(cost.accuracy.left_out, "case")));
      }
      if (!cost.not_timed.empty()) {
        const std::string stage =
            cost.candidate.methods ? "" : fmt::format(" ({})", name(cost.stage));
        notes.push_back(fmt::format("{}{}: {}", cost.candidate.name, stage, cost.not_timed));
      }
    }
  }
  return notes;
}

std::string rendered(const TradeoffReport& report, Markup markup) {
  const bool is_plain = markup == Markup::kPlain;
  const char* const item = is_plain ? "  " : "- ";
  std::string text;
  if (report.interrupted) text += "INTERRUPTED: what follows covers only what was judged.\n\n";
  text += fmt::format("{}: {}, seed {}\n", report.subject, count_text(report.cases, "case"),
                      report.seed);
  bool has_single = false;
  for (const auto precision : {scene::Precision::kDouble, scene::Precision::kSingle}) {
    const auto add = [&](std::string_view kind, const std::vector<MethodCost>& costs,
                         Table (*table_of)(const std::vector<MethodCost>&, scene::Precision)) {
      if (!has_any(costs, precision)) return;
      has_single = has_single || precision == scene::Precision::kSingle;
      text += table_of(costs, precision)
                  .section(fmt::format("{}{}", kind, precision_words(precision)), markup);
    };
    add("rays", report.rays, ray_table);
    add("intersections", report.intersections, intersection_table);
  }
  text += legend(item, has_single) + others_text(report, item) + failures_text(report, item);
  const std::vector<std::string> notes = left_out_of(report);
  if (!notes.empty()) text += fmt::format("\n{}left out\n\n", is_plain ? "" : "### ");
  for (const std::string& note : notes) text += fmt::format("{}{}\n", item, note);
  return text;
}

}  // namespace

std::string tradeoff_text(const TradeoffReport& report, const ViewOptions& /*options*/) {
  return rendered(report, Markup::kPlain);
}

std::string tradeoff_markdown(const TradeoffReport& report, const ViewOptions& /*options*/) {
  return rendered(report, Markup::kMarkdown);
}

}  // namespace raycheck::tools
