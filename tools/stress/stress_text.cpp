#include <fmt/core.h>

#include "tools/report/table.h"
#include "tools/report/words.h"
#include "tools/stress/stress.h"

namespace raycheck::tools {
namespace {

using properties::Outcome;
using properties::Quantity;
using properties::Stage;
using properties::StressResult;
using properties::Tally;
using properties::Verdict;

/// With more curves than this, the report omits single curves and severities.
constexpr std::size_t kMostSummed = 40;
constexpr std::size_t kMostDetailed = 4;

std::string failing_text(const StressCurve& curve) {
  if (!curve.is_judged()) return "-";
  const std::optional<int> failing = curve.first_failing();
  return failing ? std::to_string(*failing) : "stable";
}

/// The first failing severities of one stage's candidates, a row for each source.
Table first_failing_table(const StressReport& report, Stage stage) {
  std::vector<std::string> columns = {"source", "severities"};
  std::vector<std::vector<std::string>> rows;
  for (const FamilyReport& family : report.families) {
    std::vector<std::string> row = {
        std::string(family.family->name),
        family.curves.empty() ? ""
                              : fmt::format("{}..{}", family.curves.front().severities.front(),
                                            family.curves.front().severities.back())};
    for (const StressCurve& curve : family.curves) {
      if (curve.stage != stage) continue;
      if (rows.empty()) {
        columns.push_back(">" + curve.candidate.name);
      }
      row.push_back(failing_text(curve));
    }
    if (row.size() > 2) rows.push_back(std::move(row));
  }
  Table table(columns);
  for (auto& row : rows) table.add(std::move(row));
  return table;
}

/// The numbers of one candidate on one source at one severity.
std::vector<std::string> detail_row(const FamilyReport& family, const StressCurve& curve,
                                    std::size_t k) {
  const StressResult& result = curve.results[k];
  const Tally& main = curve.tally(k);
  std::uint64_t decisions = 0;
  std::uint64_t excused = 0;
  std::uint64_t undecided = 0;
  for (const auto& [quantity, each] : result.inside.tallies()) {
    if (!each.errors.empty()) continue;
    decisions += each.cases;
    excused += each.count(properties::Standing::kExcused);
    undecided += each.count(properties::Standing::kUndecided);
  }
  return {std::string(family.family->name),
          curve.candidate.name,
          std::to_string(curve.severities[k]),
          std::to_string(decisions),
          std::to_string(properties::defects(result.inside)),
          std::to_string(undecided),
          std::to_string(excused),
          std::to_string(main.cases),
          std::string(curve.unit()),
          error_text(main.median()),
          error_text(main.quantile(0.999)),
          error_text(main.max()),
          error_text(result.inside.tally(Quantity::kBackwardError).max()),
          error_text(properties::worst_ratio(result.inside)),
          error_text(main.condition_quantile(0.5)),
          std::to_string(main.count(Outcome::kExact)),
          std::to_string(main.count(Outcome::kAccurate)),
          std::to_string(main.count(Outcome::kIllConditioned)),
          std::to_string(main.count(Outcome::kUnstable)),
          std::to_string(result.outside.compared())};
}

Table detail_table(const StressReport& report) {
  Table table({"source",     "method",    ">severity",        ">decisions", ">defects",
               ">undecided", ">excused",  ">answers",         "unit",       ">median",
               ">99.9%",     ">max",      ">backward u",      ">max rho",   ">median kappa",
               ">exact",     ">accurate", ">ill-conditioned", ">unstable",  ">outside domain"});
  for (const FamilyReport& family : report.families) {
    for (const StressCurve& curve : family.curves) {
      for (std::size_t k = 0; k < curve.results.size(); ++k) {
        table.add(detail_row(family, curve, k));
      }
    }
  }
  return table;
}

/// A table with a row for each candidate on each source.
Table summary_table(const StressReport& report) {
  Table table({"source", "method", ">first failing", ">slope", ">max rho", ">missed", ">false",
               ">other defects", ">max error", "unit"});
  for (const FamilyReport& family : report.families) {
    for (const StressCurve& curve : family.curves) {
      Verdict all;
      for (const StressResult& result : curve.results) all.merge(result.inside);
      const Tally& classes = all.tally(Quantity::kClass);
      const std::uint64_t other_defects =
          properties::defects(all) - classes.count(Outcome::kWrongDecision);
      const std::optional<double> slope = curve.slope(family.family->severities->base);
      table.add({std::string(family.family->name), curve.candidate.name, failing_text(curve),
                 slope ? fmt::format("{:.2f}", *slope) : "-", error_text(curve.worst_ratio()),
                 std::to_string(classes.count(properties::Wrong::kMissed)),
                 std::to_string(classes.count(properties::Wrong::kFalseHit)),
                 std::to_string(other_defects), error_text(all.tally(curve.quantity()).max()),
                 std::string(curve.unit())});
    }
  }
  return table;
}

std::size_t count_curves(const StressReport& report) {
  std::size_t curves = 0;
  for (const FamilyReport& family : report.families) curves += family.curves.size();
  return curves;
}

std::string explanation() {
  return fmt::format(
      "A number is the first severity at which the method is not stable: it gives no answer; or "
      "it\ndecides wrongly, and no relative change of the inputs by {:g} u would make the decision "
      "right;\nor a stability ratio rho = error / ((1 + kappa) u) is above {:g}. u is the unit "
      "roundoff of the\nmethod's precision, kappa the condition number; an error of k ulp counts "
      "as k u. \"stable\": it is\nstable at all severities. \"-\": no case lies in the method's "
      "domain. More cases may find an earlier\nseverity.\n",
      properties::kExcusedChange / properties::kDoubleRoundoff, properties::kStableRatio);
}

std::string rendered(const StressReport& report, Markup markup) {
  const char* const item = markup == Markup::kPlain ? "" : "- ";
  std::string text;
  if (report.interrupted) text += "INTERRUPTED: what follows covers only what was judged.\n\n";
  text += fmt::format("{} cases at each severity, seed {}.\n{}", report.cases, report.seed,
                      explanation());
  std::vector<Implementation> methods;
  for (const FamilyReport& family : report.families) {
    for (const StressCurve& curve : family.curves) methods.push_back(curve.candidate);
  }
  const std::string others = isolation_text(methods);
  if (!others.empty()) text += "\n" + others;
  for (const Stage stage : {Stage::kRays, Stage::kIntersection}) {
    const Table table = first_failing_table(report, stage);
    if (table.empty()) continue;
    text += table.section(fmt::format("first failing severity, {}", name(stage)), markup);
  }
  const std::size_t curves = count_curves(report);
  if (curves <= kMostSummed) text += summary_table(report).section("by method", markup);
  if (curves <= kMostDetailed) text += detail_table(report).section("by severity", markup);
  text += "\n";
  if (curves <= kMostSummed) {
    text += fmt::format(
        "{0}slope: the power of 10^severity (or 2^severity) with which the error grows\n"
        "{0}missed, false: all such wrong decisions, also excused and undecided ones\n"
        "{0}other defects: no answer, or a wrong root or sphere\n",
        item);
  }
  if (curves <= kMostDetailed) {
    text += fmt::format(
        "{0}decisions: the judged hits, misses and choices of a root; answers: the measured "
        "numbers\n"
        "{0}backward u: the largest backward error, in u\n"
        "{0}exact, accurate: off by at most 1/2, and by at most {1} units; ill-conditioned: by "
        "more, but rho is at most {2:g}; unstable: rho is larger\n",
        item, properties::kAccurateError, properties::kStableRatio);
  }
  for (const FamilyReport& family : report.families) {
    for (const StressCurve& curve : family.curves) {
      const std::string where = fmt::format("{}{} on {} ({})", item, curve.candidate.name,
                                            family.family->name, name(curve.stage));
      const properties::AnswersFailed failed = curve.failed();
      if (failed.count > 0) {
        text += fmt::format("{}: {} failed, first: {}\n", where, count_text(failed.count, "answer"),
                            failed.first);
      }
      if (curve.left_out() == 0) continue;
      text += fmt::format("{}: {} left out, not representable in floats\n", where,
                          count_text(curve.left_out(), "case"));
    }
  }
  for (const FamilyReport& family : report.families) {
    text += fmt::format("{}{}: severity is {}\n", item, family.family->name,
                        family.family->severities->meaning);
  }
  return text;
}

}  // namespace

std::string stress_text(const StressReport& report, const ViewOptions& /*options*/) {
  return rendered(report, Markup::kPlain);
}

std::string stress_markdown(const StressReport& report, const ViewOptions& /*options*/) {
  return rendered(report, Markup::kMarkdown);
}

}  // namespace raycheck::tools
