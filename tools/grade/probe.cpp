#include "tools/grade/probe.h"

#include <fmt/core.h>

#include <algorithm>
#include <cstdint>
#include <utility>

#include "tools/grade/self_test.h"
#include "tools/run/in_order.h"

namespace raycheck::tools {
namespace {

SubmissionProbe probed(const Submission& submission, const Rubric& rubric, const Layers& layers,
                       const properties::RunControl& control) {
  SubmissionProbe probe;
  probe.name = submission.name;
  try {
    const RunnableSubmission runnable = prepare(submission, rubric, {layers}, control);
    probe.found = runnable.found;
    probe.functions = runnable.external.introduction.functions;
  } catch (const SubmissionError& error) {
    probe.found = error.found();
    probe.refusal = error.refusal();
  }
  return probe;
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
  in_order<SubmissionProbe>(
      static_cast<std::int64_t>(submissions.size()), control,
      [&](std::int64_t k) {
        return probed(submissions[static_cast<std::size_t>(k)], report.rubric, layers, control);
      },
      [&](SubmissionProbe& one) {
        report.submissions.push_back(std::move(one));
        control.progress(
            fmt::format("{} of {} tried", report.submissions.size(), submissions.size()));
      });
  report.interrupted = control.interrupted();
  return report;
}

}  // namespace raycheck::tools
