#include "tools/grade/intake/prepare.h"

#include <fmt/core.h>
#include <fnmatch.h>

#include <algorithm>
#include <boost/algorithm/string/replace.hpp>
#include <cctype>
#include <fstream>
#include <limits>
#include <set>

#include "contract/declarations.h"
#include "scene/text.h"
#include "tools/external/sandbox/file_tree.h"
#include "tools/grade/intake/building.h"
#include "tools/grade/intake/sources.h"
#include "tools/report/digest.h"

namespace raycheck::tools {
namespace {

namespace fs = std::filesystem;

/// If a build shows no spheres, at most this many other ways to build it are tried.
constexpr int kMostFurtherBuilds = 2;

constexpr std::size_t kReadOfFile = std::size_t{4} << 20;

/// A renderer's usual command line, and others to try if it makes no picture.
constexpr std::string_view kCall = "{program} {scene} {image}";
constexpr std::string_view kOtherCalls[] = {
    "{program} {image} {scene}",
    "{program} {scene}",
    "{program} {scene} -o {image}",
    "{program} -i {scene} -o {image}",
    "{program} -input {scene} -output {image} -size {width} {height}",
    "{program} {scene} {image} {width} {height}",
    "{program} {scene} {width} {height} {image}",
    "{program} {width} {height} {scene} {image}",
    "sh -c '$* {scene} > {image}' - {program}",
    "sh -c '$* < {scene} > {image}' - {program}"};

[[noreturn]] void refuse(const std::string& why) { throw SubmissionError({why, ""}, {}); }

bool fits(const Form& form, const std::string& name) {
  return fnmatch(form.has.c_str(), name.c_str(), 0) == 0;
}

/// Whether a form refers to a folder of this name, which must therefore not be unwrapped.
bool means_folder(const Form& form, const std::string& name) {
  if (form.has != "*" && fits(form, name)) return true;
  const auto is_of_name = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '.' || c == '-';
  };
  const std::string words = " " + form.build + " ";
  for (std::size_t at = 0; (at = words.find(name, at + 1)) != std::string::npos;) {
    if (!is_of_name(words[at - 1]) && !is_of_name(words[at + name.size()])) return true;
  }
  return false;
}

/// Copies a submission; adds a Python module for each Jupyter notebook.
Sources copied(const Submission& submission, const Rubric& rubric) {
  const fs::path top = innermost(submission.path, [&](const std::string& name) {
    return std::ranges::any_of(rubric.forms,
                               [&](const Form& form) { return means_folder(form, name); });
  });
  HandedInPaths paths = paths_of(top, rubric.limits);
  const auto folder = std::make_shared<const PrivateFolder>();
  Sources sources{.folder = folder};
  std::vector<std::string> digested = paths.folders;
  for (const std::string& name : paths.folders) fs::create_directories(folder->path() / name);
  for (auto& [name, path] : paths.files) {
    const fs::path to = folder->path() / name;
    fs::create_directories(to.parent_path());
    fs::copy_file(path, to);
    path = to;
    sources.files[name] = {file_bytes(path, kReadOfFile), is_executable(path)};
    digested.insert(digested.end(), {name, file_digest(path)});
  }
  sources.digest = digest(digested);
  sources.opaque = opaque_files(sources.files, paths.files);
  for (const auto& [name, path] : paths.files) {
    const std::string module = fs::path(name).replace_extension(".py").string();
    if (path.extension() != ".ipynb" || sources.files.contains(module)) continue;
    if (const auto code = notebook_module(sources.files.at(name).text)) {
      std::ofstream(folder->path() / module, std::ios::binary) << *code;
      sources.files[module] = {*code, false};
    }
  }
  sources.start = run_folder(sources.files, paths.folders, folder);
  open_to_others(folder->path());
  return sources;
}

FittingForm form_of(const fs::path& folder, const Rubric& rubric) {
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) {
    names.insert(entry.path().filename().string());
  }
  if (names.empty()) refuse("it contains no files");
  for (const Form& form : rubric.forms) {
    const auto file = std::ranges::find_if(names, [&](const auto& one) { return fits(form, one); });
    if (file == names.end()) continue;
    CandidateSpec program = form.program;
    const std::string word = program.is_words() ? candidate_word(*file) : *file;
    boost::replace_all(program.what, "{file}", word);
    return {form, *file, std::move(program)};
  }
  if (rubric.forms.empty()) refuse("the rubric has no [[form]]");
  std::string why =
      "it has none of the required files: " + scene::joined(rubric.forms, ", ", &Form::has);
  std::set<std::string> deeper;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (std::ranges::any_of(rubric.forms, [&](const Form& form) { return fits(form, name); })) {
      deeper.insert(fs::relative(entry.path(), folder).string());
    }
  }
  if (!deeper.empty()) {
    why += fmt::format(" (only in a folder: {}; has = \"*\" accepts every submission)",
                       *deeper.begin());
  }
  refuse(why);
}

/// A digest of everything that a program's answers depend on, except the requests.
std::string answers_key(const std::string& build, const CandidateSpec& program,
                        const Limits& limits) {
  return digest({build, program.text(),
                 fmt::format("{} {} {} {} {} {}", limits.seconds, limits.cpu_seconds, limits.memory,
                             limits.file, limits.files, limits.processes)});
}

/// A submission as built in one way.
struct Build {
  Built made = {};
  std::shared_ptr<const PrivateFolder> folder = {};
  std::string key = {};  ///< In the store.
  bool is_stored = false;
  double seconds = 0;                          ///< Of this and earlier builds.
  std::vector<std::string> draw_nothing = {};  ///< The sources of builds that show no spheres.
};

/// Builds in the way after `last`. Errors: CandidateError.
Build next_build(const Intake& intake, const Build& last) {
  const std::size_t way = last.made.next_way;
  Build build{.folder = intake.sources.folder,
              .key = build_key(intake, way),
              .draw_nothing = last.draw_nothing};
  if (intake.fitting.needs_building()) {
    const auto to = std::make_shared<const PrivateFolder>();
    const auto make = [&] { return build_submission(intake, way, to->path()); };
    build.made = intake.store != nullptr
                     ? intake.store->built(build.key, to->path(), make, build.is_stored)
                     : make();
    open_to_others(to->path());
    build.folder = to;
  }
  build.seconds = intake.options.build_spent->seconds_since({});
  const std::string& before = last.made.what;
  if (!before.empty() && before != build.made.what) build.draw_nothing.push_back(before);
  for (const std::string& other : build.draw_nothing) {
    build.made.notes.push_back(
        fmt::format("the program built from {} shows no spheres; it was built from {} instead",
                    other, build.made.what));
  }
  return build;
}

Preparation found_by(const Intake& intake, const Build& build) {
  const auto& [form, file, program] = intake.fitting;
  Preparation found{.program = program,
                    .adapter = form.adapter ? form.adapter->name : "",
                    .built_automatically = form.is_built_automatically(),
                    .build_words = build.made.words,
                    .notes = build.made.notes,
                    .opaque_files = intake.sources.opaque};
  for (const auto& [name, contents] : intake.sources.files) {
    if (name.find('/') == std::string::npos) found.files.push_back(name);
    if (name == found.adapter && contents.text != form.adapter->text) {
      found.notes.push_back(fmt::format("its {} is replaced by the adapter of this name", name));
    }
  }
  return found;
}

/// The same command without any submitted file, which only an instructor's wrapper answers as
/// before: a submission must not choose its questions.
Confined without_hand_in(Confined program, const std::string& folder) {
  const auto is_handed_in = [&](const std::string& word) {
    return word.find(folder) != std::string::npos;
  };
  std::ranges::replace_if(program.arguments, is_handed_in, "false");
  std::erase_if(program.readable, is_handed_in);
  program.start = nullptr;
  return program;
}

/// Sets up a renderer with the driver form and colours found by a dry run; if it is called in
/// another way than the rubric says, only if it makes a picture. Errors: SubmissionError.
void ask_in_its_form(RunnableSubmission& runnable, const Intake& intake, const fs::path& folder,
                     bool is_other_call, const properties::RunControl& control) {
  Renderer renderer = *runnable.external.renderer;
  const StartingFolder& start = *(renderer.program.start = intake.sources.start);
  renderer.wrapper = without_hand_in(renderer.program, folder);
  if (!start.links.empty()) renderer.program.readable.push_back(start.linked->path());
  if (is_other_call && !makes_a_picture(renderer, intake.rubric.driver)) {
    throw SubmissionError({}, runnable.found);
  }
  const DryRun& found =
      runnable.found.dry_run.emplace(dry_run(renderer, intake.rubric.driver, control));
  if (found.refusal) throw SubmissionError(*found.refusal, runnable.found);
  renderer.driver = found.driver;
  renderer.colours = found.colours;
  // The rubric's `seconds` limit all requests together.
  renderer.most_timeouts = std::numeric_limits<int>::max();
  External asked = rendering(runnable.external.name, std::move(renderer));
  asked.folder = runnable.external.folder;
  asked.copies = runnable.external.copies;
  asked.bounds = runnable.external.bounds;
  declare_over(runnable.external.declares, asked);
  runnable.external = std::move(asked);
}

/// Why a submission cannot be judged: it could not be built or started.
SubmissionError submission_error(const CandidateError& error, Preparation found) {
  const std::string whose =
      found.adapter.empty() ? "" : fmt::format("it does not fit the adapter {}: ", found.adapter);
  return {{whose + error.why(), error.output()}, std::move(found)};
}

/// Starts one of a build's programs, given its command line, as the rubric says or by another
/// `call`. Errors: SubmissionError.
RunnableSubmission started(const Intake& intake, const Build& build, const std::string& by,
                           std::string_view call, const properties::RunControl& control) {
  RunnableSubmission runnable{{}, found_by(intake, build), build.is_stored};
  auto& [external, found, is_stored] = runnable;
  CandidateSpec& program = *found.program;
  if (found.built_automatically) boost::replace_all(program.what, "{program}", by);
  if (!call.empty()) {
    const std::string usual =
        std::exchange(program.what, boost::replace_all_copy(std::string(call), "{program}", by));
    found.notes.push_back(fmt::format(
        "it makes no picture when it is called as {}; it is called as {}", usual, program.what));
  }
  if (const std::size_t count = build.made.programs.size(); count > 1) {
    found.notes.push_back(fmt::format("{} programs are built; {} is run", count, by));
  }
  RunOptions options = intake.options;
  if (intake.store != nullptr) {
    options.answers = intake.store->answers(answers_key(build.key, program, options.limits));
  }
  options.folder = build.folder->path();
  try {
    external = program.kind == CandidateKind::kSource
                   ? compiled_external(program, options.folder / by, options)
                   : find_external(program, options);
    found.build_seconds = build.seconds;
    found.functions = external.introduction.functions;
    // Nor may it choose how it is called: rows for columns, or directions that are not unit, are
    // what items are about, or tolerances. An adapter is the instructor's, and so is what the
    // rubric declares.
    contract::Declarations& declared = external.introduction.declared;
    if (found.adapter.empty() && !external.renderer) {
      declared.interface = {.returns = declared.interface.returns};
      declared.tolerances = {};
      declared.lengths = {};
      declared.conventions.valid = scene::ValidRoots{};
    }
    declare_over(intake.fitting.form.declares, external);
    // The rubric sets the precision, whatever the submission declares.
    external.precision = scene::Precision::kDouble;
    // The program's folder must outlive it; a library keeps its folder itself.
    if (!external.folder) external.folder = build.folder;
    if (external.renderer) {
      ask_in_its_form(runnable, intake, options.folder, !call.empty(), control);
    }
    return runnable;
  } catch (const CandidateError& error) {
    throw submission_error(error, found);
  }
}

/// The error of a submission that cannot be run as a renderer. If it uses raycheck's interface for
/// functions, its file only has another name than the rubric wants.
SubmissionError as_misnamed(const SubmissionError& error, const Intake& intake) {
  if (intake.fitting.form.program.kind != CandidateKind::kRenderer) return error;
  std::vector<std::string> names;
  for (const Form& form : intake.rubric.forms) {
    if (form.program.kind != CandidateKind::kRenderer) names.push_back(form.has);
  }
  if (names.empty()) return error;
  for (const auto& [name, file] : intake.sources.files) {
    for (const char* used : {"raycheck_candidate", "raycheck/candidate", "RaycheckCandidate"}) {
      if (file.text.find(used) == std::string::npos) continue;
      return {
          {fmt::format("{} uses {}, but this rubric takes functions only from {}: rename it; as "
                       "a renderer, {}",
                       name, used, scene::joined(names, ", "), error.refusal.why),
           error.refusal.said},
          error.found};
    }
  }
  return error;
}

/// The program of a build that shows spheres in one of kOtherCalls; empty if there is none.
std::optional<RunnableSubmission> called_otherwise(const Intake& intake, const Build& build,
                                                   const std::string& by,
                                                   const properties::RunControl& control) {
  if (intake.fitting.program.what != kCall) return {};
  for (const std::string_view call : kOtherCalls) {
    if (control.interrupted()) break;
    try {
      RunnableSubmission runnable = started(intake, build, by, call, control);
      if (runnable.found.dry_run->shows_a_sphere()) return runnable;
    } catch (const SubmissionError&) {
      // The reason of the usual call is given.
    }
  }
  return {};
}

/// Searches the ways to build the submission and, for each program, the form that it reads.
RunnableSubmission best_program(const Intake& intake, const properties::RunControl& control) {
  std::optional<RunnableSubmission> best;
  std::optional<SubmissionError> farthest;
  const auto take_failure = [&](const SubmissionError& error) {
    if (!farthest || error.progress() > farthest->progress()) farthest = error;
  };
  Build build;
  for (int builds = 0; builds <= kMostFurtherBuilds; ++builds) {
    try {
      build = next_build(intake, build);
    } catch (const CandidateError& error) {
      take_failure(submission_error(error, found_by(intake, build)));
      break;
    }
    for (const std::string& by : build.made.programs) {
      try {
        RunnableSubmission runnable = started(intake, build, by, "", control);
        const auto& dry = runnable.found.dry_run;
        if (!dry || dry->shows_a_sphere()) return runnable;
        if (!best) best.emplace(std::move(runnable));
      } catch (const SubmissionError& error) {
        take_failure(error);
        const Progress progress = error.progress();
        if (progress != Progress::kFailed && progress != Progress::kNoPicture) continue;
        if (auto other = called_otherwise(intake, build, by, control)) return std::move(*other);
      }
    }
    if (build.made.next_way == 0 || control.interrupted()) break;
  }
  if (!best) throw as_misnamed(*farthest, intake);
  return std::move(*best);
}

}  // namespace

RunOptions run_options(const Rubric& rubric, const Layers& layers) {
  RunOptions options;
  options.layers = layers;
  options.limits.seconds = rubric.reply_seconds;
  options.limits.memory = rubric.limits.memory_mib << 20;
  options.limits.file = rubric.limits.file_mib << 20;
  options.limits.processes = rubric.limits.processes;
  options.limits.disk = rubric.limits.disk_mib << 20;
  options.limits.names = {"reply_seconds", "file_mib", "memory_mib", "processes", "disk_mib"};
  options.build_seconds = rubric.build_seconds;
  options.build_seconds_name = "build_seconds";
  options.driver = rubric.driver.form;
  options.bounds = rubric.bounds;
  options.excused_image_change = rubric.image_change;
  options.image_threshold = rubric.t_threshold;
  options.any_sample = rubric.any_sample;
  options.depth = rubric.depth;
  return options;
}

RunnableSubmission prepare(const Submission& submission, const Rubric& rubric, RunOptions options,
                           const properties::RunControl& control, Store* store) try {
  Sources sources = copied(submission, rubric);
  FittingForm fitting = form_of(sources.folder->path(), rubric);
  if (const auto& adapter = fitting.form.adapter) {
    sources.digest = digest({sources.digest, adapter->name, adapter->text});
    lay_adapter(fitting.form, sources.folder->path());
  }
  return best_program({std::move(sources), std::move(fitting), std::move(options), rubric, store},
                      control);
} catch (const SubmissionError&) {
  throw;
} catch (const fs::filesystem_error& error) {
  if (is_of_the_machine(error.code())) throw;
  refuse("its files: " + error.code().message());
} catch (const std::invalid_argument& error) {
  refuse(error.what());
}

}  // namespace raycheck::tools
