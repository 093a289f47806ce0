#include <tbb/info.h>

#include <fstream>
#include <iterator>
#include <memory>
#include <stdexcept>

#include "tools/arguments.h"
#include "tools/command_line.h"
#include "tools/commands.h"
#include "tools/grade/grade.h"
#include "tools/grade/package.h"
#include "tools/grade/views.h"
#include "tools/grade/wording.h"
#include "tools/terminal.h"

namespace raycheck::tools {
namespace {

struct GradeArguments {
  GradeOptions options;
  int jobs = tbb::info::default_concurrency();  ///< Submissions graded at a time.
  std::string secret_file;
  std::string package;
  std::string sandbox = "auto";
  std::string format = "text";
};

std::string secret_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::string secret{std::istreambuf_iterator<char>(file), {}};
  if (!file) throw std::invalid_argument("--secret-file " + path + ": cannot be read");
  if (secret.empty()) throw std::invalid_argument("--secret-file " + path + ": is empty");
  return secret;
}

/// The class in a format. One that is of results.json alone has no such view: then it is the first.
std::string printed(const ClassGrade& graded, const std::string& format) {
  for (const ClassView& view : printed_views()) {
    if (view.name == format) return view.render(graded);
  }
  return printed_views().front().render(graded);
}

/// Without submissions the rubric itself is tried, on raycheck's own methods.
int try_own_methods(const GradeArguments& arguments) {
  ClassGrade tried;
  tried.rubric = load_rubric(arguments.options.rubric);
  tried.submissions = try_rubric(tried.rubric, arguments.options.seed, run_control("rubric"));
  print_report(printed(tried, arguments.format));
  bool is_full = true;
  for (const SubmissionGrade& grade : tried.submissions) {
    for (const ItemGrade& item : grade.items) {
      const bool is_given = item.state == ItemState::kNotAsked || item.score >= item.points;
      is_full = is_full && is_given;
      if (is_given) continue;
      const std::string reason = reason_text(item.reason);
      print_error(item.name + ": " +
                  (reason.empty() ? "raycheck's own answer is not given all points" : reason) +
                  "\n");
    }
  }
  return exit_code(interrupted(), !is_full, true);
}

int run_grade(const GradeArguments& arguments) {
  GradeOptions options = arguments.options;
  if (!arguments.package.empty()) {
    if (!options.submissions.empty()) {
      throw std::invalid_argument("--package: grades nothing; leave out the submissions");
    }
    if (!arguments.secret_file.empty()) {
      throw std::invalid_argument(
          "--secret-file: every submission to a package has one name; give a --seed");
    }
    write_package(load_rubric(options.rubric), options.seed, arguments.package);
    print_report("wrote " + arguments.package + "\n");
    return kExitNothingFound;
  }
  if (options.submissions.empty()) return try_own_methods(arguments);
  if (options.out.empty()) throw std::invalid_argument("--out: give a folder for the results");
  if (!arguments.secret_file.empty()) options.secret = secret_of(arguments.secret_file);
  options.sandbox = sandbox_of(arguments.sandbox);
  for (const ResultsFormat& format : results_formats()) {
    if (format.name == arguments.format) options.results = &format;
  }
  const ClassGrade graded = grade(options, run_control("submissions", arguments.jobs));
  print_report(printed(graded, arguments.format));
  return exit_code(graded.interrupted, false, true);
}

}  // namespace

Command add_grade(CLI::App& program) {
  const auto given = std::make_shared<GradeArguments>();
  GradeArguments& arguments = *given;
  CLI::App& command = *program.add_subcommand(
      "grade", "Grade submissions by a rubric; without any, try the rubric");
  command
      .add_option("RUBRIC", arguments.options.rubric,
                  "a TOML file, or one that comes with raycheck: lecture7.toml")
      ->required();
  command.add_option("SUBMISSION", arguments.options.submissions, "folders or files handed in");
  command.add_option("--out", arguments.options.out, "the folder that takes the results");
  command.add_option("--jobs", arguments.jobs, "submissions graded at a time")
      ->check(CLI::Range(1, 1024));
  add_seed(command, arguments.options.seed);
  command.add_option("--secret-file", arguments.secret_file,
                     "a file of which, with its name, each submission's seed is made");
  add_sandbox(command, arguments.sandbox);
  command.add_option("--package", arguments.package,
                     "write the zip file that Gradescope takes as an autograder");
  std::vector<std::string> formats;
  for (const ClassView& view : printed_views()) formats.emplace_back(view.name);
  for (const ResultsFormat& format : results_formats()) formats.emplace_back(format.name);
  add_format(command, arguments.format, formats);
  return {&command, [given] { return run_grade(*given); }};
}

}  // namespace raycheck::tools
