#include "tools/grade/intake/starting.h"

#include <fmt/core.h>

#include <limits>
#include <optional>
#include <string_view>
#include <utility>

#include "tools/external/pictures/dry_run.h"
#include "tools/grade/intake/building.h"
#include "tools/grade/intake/quoting.h"

namespace raycheck::tools {
namespace {

namespace fs = std::filesystem;

/// The reason in one line; what a program said, in lines of its own.
Refusal in_one_line(Refusal refusal) {
  constexpr std::string_view kIntroduction = "; it said:";
  const std::size_t line = refusal.why.find('\n');
  if (line == std::string::npos) return refusal;
  refusal.said = refusal.why.substr(line + 1) + (refusal.said.empty() ? "" : "\n" + refusal.said);
  refusal.why.resize(line);
  if (refusal.why.ends_with(kIntroduction)) {
    refusal.why.resize(line - kIntroduction.size());
  }
  return refusal;
}

/// From the dry run on a renderer is asked as it reads and shows.
void ask_in_its_form(RunnableSubmission& runnable, const Rubric& rubric,
                     const std::shared_ptr<const StartingFolder>& start,
                     const properties::RunControl& control) {
  Renderer renderer = *runnable.external.renderer;
  renderer.program.start = start;
  if (!start->links.empty()) renderer.program.readable.push_back(start->linked->path());
  const DryRun& found = runnable.found.dry_run.emplace(dry_run(renderer, rubric.driver, control));
  if (found.refusal) throw SubmissionError(in_one_line(*found.refusal), runnable.found);
  renderer.driver = found.driver;
  renderer.colours = found.colours;
  // All that it is asked has an end of its own, the rubric's `seconds`.
  renderer.most_silences = std::numeric_limits<int>::max();
  External asked = rendering(runnable.external.name, std::move(renderer));
  asked.folder = runnable.external.folder;
  asked.bounds = runnable.external.bounds;
  runnable.external = std::move(asked);
}

/// One of its programs, by what starts it. Errors: SubmissionError.
RunnableSubmission started(const BuiltSubmission& built, const std::string& by,
                           const properties::RunControl& control) {
  Preparation found = built.found;
  CandidateSpec program = built.program;
  if (found.as_it_comes) program.what = with_mark(program.what, "{program}", by);
  found.program = program;
  if (const std::size_t count = built.made.programs.size(); count > 1) {
    found.notes.push_back(fmt::format("{} programs are built; {} is run", count, by));
  }
  RunOptions options = built.options;
  if (built.store != nullptr) {
    options.answers = built.store->answers(answers_key(built.key, program, options.limits));
  }
  options.folder = built.folder->path();
  try {
    External external = program.kind == CandidateKind::kSource
                            ? compiled_external(program, options.folder / by, options)
                            : find_external(program, options);
    found.build_seconds = built.seconds;
    // The rubric says in which format it is judged, whatever it declares.
    external.precision = scene::Precision::kDouble;
    RunnableSubmission runnable{std::move(external), std::move(found), built.is_stored};
    // The program's folder lasts as long as it; a library has one of its own.
    if (!runnable.external.folder) runnable.external.folder = built.folder;
    if (runnable.external.renderer) ask_in_its_form(runnable, built.rubric, built.start, control);
    return runnable;
  } catch (const CandidateError& error) {
    throw SubmissionError({error.why(), error.said()}, found);
  }
}

}  // namespace

RunnableSubmission likeliest(const BuiltSubmission& built, const properties::RunControl& control) {
  std::optional<RunnableSubmission> best;
  std::optional<SubmissionError> why;
  for (const std::string& by : built.made.programs) {
    try {
      RunnableSubmission runnable = started(built, by, control);
      const auto& dry = runnable.found.dry_run;
      const bool works = !dry || dry->shows_a_sphere;
      if (works || !best) best.emplace(std::move(runnable));
      if (works) break;
    } catch (const SubmissionError& error) {
      if (!why) why = error;
    }
  }
  if (!best) throw SubmissionError(*why);
  return std::move(*best);
}

}  // namespace raycheck::tools
