#include "tools/grade/probe.h"

#include <algorithm>
#include <utility>

#include "tools/grade/self_test.h"

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
  for (Probed& one :
       done_for_each<Probed>(submissions, control, "tried", [&](const Submission&each, bool alone) {
         return probed(each, report.rubric, layers, control, alone);
       })) {
    report.submissions.push_back(std::move(one.probe));
  }
  report.interrupted = control.interrupted();
  return report;
}

}  // namespace raycheck::tools
