#include "tools/grade/probe.h"

#include <fmt/core.h>

#include <algorithm>
#include <cstdint>
#include <utility>

#include "tools/grade/grade.h"
#include "tools/run/in_order.h"

namespace raycheck::tools {
namespace {

/// And the cause outside it for which nothing is known of it; empty: it is known.
struct Probed {
  SubmissionProbe probe;
  std::string outside;
};

Probed probed(const Submission& submission, const Rubric& rubric, const Layers& layers,
              const properties::RunControl& control, bool alone) {
  const auto surroundings = std::make_shared<Surroundings>(alone);
  SubmissionProbe probe;
  probe.name = submission.name;
  try {
    const RunnableSubmission runnable =
        prepare(submission, rubric, {layers, surroundings}, until_blamed(control, *surroundings));
    probe.found = runnable.found;
    probe.functions = runnable.external.introduction.functions;
  } catch (const SubmissionError& error) {
    probe.found = error.found();
    probe.refusal = error.refusal();
  }
  const std::string cause = surroundings->cause();
  if (!cause.empty()) probe.refusal = outside_refusal(cause);
  return {std::move(probe), cause};
}

}  // namespace

bool ProbeReport::holds() const {
  return std::none_of(submissions.begin(), submissions.end(),
                      [](const SubmissionProbe& one) { return one.refusal.has_value(); });
}

ProbeReport probe(const GradeOptions& options, const properties::RunControl& control) {
  ProbeReport report;
  report.rubric = load_rubric(options.rubric, options.dialect);
  const Layers layers = chosen_layers(options.sandbox).layers;
  test_environment(report.rubric, layers);
  const std::vector<Submission> submissions = find_submissions(options.submissions, {});
  std::vector<std::size_t> again;
  in_order<Probed>(
      static_cast<std::int64_t>(submissions.size()), control,
      [&](std::int64_t k) {
        return probed(submissions[static_cast<std::size_t>(k)], report.rubric, layers, control,
                      false);
      },
      [&](Probed& one) {
        if (!one.outside.empty()) again.push_back(report.submissions.size());
        report.submissions.push_back(std::move(one.probe));
        const std::string state =
            fmt::format("{} of {} tried", report.submissions.size(), submissions.size());
        control.progress(state);
        control.done(fmt::format("{}: {}", state, report.submissions.back().name));
      });
  for (const std::size_t k : again) {
    if (control.interrupted()) break;
    control.progress(fmt::format("{} again, alone", submissions[k].name));
    report.submissions[k] = probed(submissions[k], report.rubric, layers, control, true).probe;
    control.done(fmt::format("tried again, alone: {}", submissions[k].name));
  }
  report.interrupted = control.interrupted();
  return report;
}

}  // namespace raycheck::tools
