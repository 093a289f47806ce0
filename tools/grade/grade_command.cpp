#include <tbb/info.h>

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <memory>
#include <span>
#include <stdexcept>

#include "scene/files/file_text.h"
#include "tools/edge.h"
#include "tools/grade/grade.h"
#include "tools/grade/intake/handed_in.h"
#include "tools/grade/pages/views.h"

namespace raycheck::tools {
namespace {

struct GradeArguments {
  GradeOptions options;
  /// The number of submissions graded at the same time.
  int jobs = tbb::info::default_concurrency();
  std::string secret_file;
  std::string package;
  /// Grading with less isolation than required needs an explicit option.
  SandboxArguments sandbox = {.sandbox = Sandbox::kRequire};
  std::string format = "text";
  ShardArguments shards;
};

std::string secret_of(const std::string& path) {
  constexpr std::uintmax_t kMostSecret = 1 << 20;
  try {
    std::string secret = scene::file_text(path, kMostSecret);
    if (!secret.empty()) return secret;
  } catch (const scene::SceneFileError& error) {
    throw std::invalid_argument(std::string("--secret-file ") + error.what());
  }
  throw std::invalid_argument("--secret-file " + path + ": is empty");
}

/// Prints the class in a format. If `format` is only a format of results.json, the first view is
/// used.
void print_class(std::span<const ClassView> views, const std::string& format,
                 const ClassGrade& graded) {
  const auto view = std::ranges::find(views, format, &ClassView::name);
  print_report((view == views.end() ? views.front() : *view).render(graded));
}

/// Tries the rubric on raycheck's own methods, if there are no submissions.
int try_own_methods(const GradeArguments& arguments) {
  const ClassGrade tried = try_rubric(arguments.options, run_control("rubric"));
  print_class(kPrintedViews, arguments.format, tried);
  bool is_full = true;
  for (const SubmissionGrade& grade : tried.submissions) {
    for (const ItemGrade& item : grade.items) {
      const bool is_given = item.state == ItemState::kNotAsked || item.score >= item.points;
      is_full = is_full && is_given;
      if (is_given) continue;
      const std::string reason = reason_text(item.reason);
      print_error(item.name + ": " +
                  (reason.empty() ? "raycheck's own methods do not get all points" : reason) +
                  "\n");
    }
  }
  return exit_code(tried.interrupted, !is_full, true);
}

/// Makes only the dry run. (Its `out` is not used.)
int run_probe(const GradeArguments& arguments) {
  if (std::ranges::find(kProbeViews, arguments.format, &ClassView::name) == std::end(kProbeViews)) {
    throw std::invalid_argument("--format " + arguments.format +
                                ": with --probe, give text or json");
  }
  GradeOptions options = arguments.options;
  options.out.clear();
  options.sandbox = sandbox_of(arguments.sandbox);
  const ClassGrade probed = grade(options, run_control("submissions", arguments.jobs));
  print_class(kProbeViews, arguments.format, probed);
  return exit_code(probed.interrupted, !submissions_that(probed, false).empty(), true);
}

int run_grade(const GradeArguments& arguments) {
  if (arguments.options.probe) return run_probe(arguments);
  GradeOptions options = arguments.options;
  if (!arguments.package.empty()) {
    write_package(load_rubric(options.rubric), options.seed, arguments.package);
    print_report("wrote " + arguments.package + "\n");
    return kExitNothingFound;
  }
  if (options.submissions.empty()) return try_own_methods(arguments);
  if (arguments.shards.merged.size() > 1) {
    throw std::invalid_argument(
        "merge: give one folder; all shards of a class write into the same folder");
  }
  for (const std::string& folder : arguments.shards.merged) options.out = folder;
  if (options.out.empty()) {
    find_submissions(options.submissions);  // a missing submission is named first
    throw std::invalid_argument("--out: give a folder for the results");
  }
  if (!arguments.secret_file.empty()) options.secret = secret_of(arguments.secret_file);
  options.sandbox = sandbox_of(arguments.sandbox);
  for (const ResultsFormat& format : kResultsFormats) {
    if (format.name == arguments.format) options.results = &format;
  }
  ShardArguments shards = arguments.shards;
  if (!shards.shard.empty()) shards.out = options.out + "/" + kUnitsInside;
  for (std::string& folder : shards.merged) folder += std::string("/") + kUnitsInside;
  const std::unique_ptr<Units> units = units_of(shards);
  const ClassGrade graded = grade(options, run_control("submissions", arguments.jobs), units.get());
  if (units && !units->are_all()) {
    shards.out = options.out;
    return shard_done(shards, *units, graded.interrupted);
  }
  print_class(kPrintedViews, arguments.format, graded);
  return exit_code(graded.interrupted, false, graded.not_graded() == 0);
}

}  // namespace

CommandRun add_grade(CLI::App& command) {
  const auto given = std::make_shared<GradeArguments>();
  GradeArguments& arguments = *given;
  command
      .add_option("RUBRIC", arguments.options.rubric,
                  "a TOML file, or one that comes with raycheck: lecture7.toml")
      ->required();
  CLI::Option* const submissions = command.add_option("SUBMISSION", arguments.options.submissions,
                                                      "the folders or files of submissions");
  command.add_option("--out", arguments.options.out, "the folder for the results")
      ->needs(submissions);
  add_shards_inside(command, arguments.shards);
  command.add_option("--jobs", arguments.jobs, "the number of submissions graded at the same time")
      ->check(whole_number(1, 1024));
  // --out is allowed, so that removing --probe gives the command for grading.
  CLI::Option* const probe =
      command
          .add_flag(
              "--probe", arguments.options.probe,
              "only build the submissions and draw a test scene with each; print what each one "
              "reads, writes and shows, and suggest [driver] and [[form]] tables for the rubric")
          ->needs(submissions);
  add_rubric_dialect(command, arguments.options.dialect);
  add_seed(command, arguments.options.seed);
  command
      .add_option("--secret-file", arguments.secret_file,
                  "derive each submission's seed from the secret in this file and from its name")
      ->needs(submissions)
      ->excludes(probe);
  add_sandbox(command, arguments.sandbox);
  command
      .add_option("--package", arguments.package, "write the zip file of a Gradescope autograder")
      ->excludes(submissions)
      ->excludes(command.get_option("--dialect"));
  std::vector<std::string> formats = names_of(kPrintedViews);
  for (const ResultsFormat& format : kResultsFormats) formats.emplace_back(format.name);
  add_format(command, arguments.format, formats);
  return [given] { return run_grade(*given); };
}

}  // namespace raycheck::tools
