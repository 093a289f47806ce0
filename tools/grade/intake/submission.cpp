#include "tools/grade/intake/submission.h"

#include <fmt/core.h>
#include <fnmatch.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <iterator>
#include <limits>
#include <map>
#include <memory>
#include <set>
#include <stdexcept>
#include <system_error>

#include "tools/grade/intake/building.h"
#include "tools/grade/intake/handed_in.h"
#include "tools/grade/intake/notebook.h"
#include "tools/grade/intake/opaque_files.h"
#include "tools/grade/intake/quoting.h"
#include "tools/grade/rubric/digest.h"

namespace raycheck::tools {
namespace {

namespace fs = std::filesystem;

/// A dry run tries no further form after so many.
constexpr double kDryRunSeconds = 60;

[[noreturn]] void refuse(const std::string& why) { throw SubmissionError({why, ""}, {}); }

IntakeLimits intake_limits(const SubmissionLimits& limits) {
  return {limits.submission_mib, static_cast<std::size_t>(limits.files)};
}

}  // namespace

Limits program_limits(const Rubric& rubric) {
  Limits limits;
  limits.seconds = rubric.reply_seconds;
  limits.memory = rubric.limits.memory_mib << 20;
  limits.file = rubric.limits.file_mib << 20;
  limits.processes = rubric.limits.processes;
  limits.disk = rubric.limits.disk_mib << 20;
  limits.names = {"reply_seconds", "file_mib", "memory_mib", "processes", "disk_mib"};
  return limits;
}

namespace {

struct CopiedFiles {
  HandedInFiles files;
  std::string digest;  ///< Of those that were handed in.
  std::vector<OpaqueFile> opaque;
};

/// Copies a submission to a folder; a Jupyter notebook lies there as a module of Python too.
CopiedFiles copied(const Submission& submission, const SubmissionLimits& limits,
                   const fs::path& folder) {
  std::map<std::string, fs::path> copies;
  for (const auto& [name, path] : files_of(innermost(submission.path), intake_limits(limits))) {
    const fs::path to = folder / name;
    fs::create_directories(to.parent_path());
    fs::copy_file(path, to);
    copies.emplace(name, to);
  }
  HandedInFiles files = read_files(copies);
  std::vector<OpaqueFile> opaque = opaque_files(files, copies);
  for (const auto& [name, path] : copies) {
    const std::string module = fs::path(name).replace_extension(".py").string();
    if (path.extension() != ".ipynb" || files.contains(module)) continue;
    if (const auto code = notebook_module(files.at(name).text)) {
      std::ofstream(folder / module, std::ios::binary) << *code;
      files[module] = {*code, false};
    }
  }
  return {std::move(files), digest_of(copies), std::move(opaque)};
}

std::vector<std::string> top_files(const HandedInFiles& files) {
  std::vector<std::string> names;
  for (const auto& [name, file] : files) {
    if (name.find('/') == std::string::npos) names.push_back(name);
  }
  return names;
}

/// The form that fits, and the file that says so.
std::pair<const Form*, std::string> form_of(const fs::path& folder, const Rubric& rubric) {
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) {
    names.insert(entry.path().filename().string());
  }
  if (names.empty()) refuse("there is no file in it");
  for (const Form& form : rubric.forms) {
    for (const std::string& name : names) {
      if (fnmatch(form.has.c_str(), name.c_str(), 0) == 0) return {&form, name};
    }
  }
  std::string asked;
  for (const Form& form : rubric.forms) asked += (asked.empty() ? "" : ", ") + form.has;
  refuse(asked.empty() ? "the rubric has no [[form]] of submissions"
                       : fmt::format("it has none of the files that are asked for: {}", asked));
}

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
                     const properties::RunControl& control) {
  Renderer renderer = *runnable.external.renderer;
  const DryRun& found =
      runnable.found.dry_run.emplace(dry_run(renderer, rubric.driver, kDryRunSeconds, control));
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

}  // namespace

std::vector<Submission> find_submissions(const std::vector<std::string>& paths,
                                         const std::vector<std::string_view>& reserved) {
  std::vector<Submission> found;
  std::map<std::string, std::string> known;
  for (const std::string& given : paths) {
    std::error_code error;
    // A link is not followed: it may lead to someone else's.
    fs::path path = fs::absolute(given).lexically_normal();
    if (!path.has_filename()) path = path.parent_path();
    if (!fs::exists(fs::symlink_status(path, error))) {
      throw std::invalid_argument(fmt::format("{}: there is no such file or folder", given));
    }
    const bool is_file = fs::is_regular_file(fs::symlink_status(path));
    const std::string name = is_file ? path.stem().string() : path.filename().string();
    if (std::find(reserved.begin(), reserved.end(), name) != reserved.end()) {
      throw std::invalid_argument(
          fmt::format("{}: rename it; the results of the class are called so", given));
    }
    const auto [other, is_new] = known.try_emplace(name, given);
    if (!is_new) {
      throw std::invalid_argument(
          fmt::format("{}: {} has the same name, {}", given, other->second, name));
    }
    found.push_back({name, path});
  }
  return found;
}

std::string digest(const Submission& submission, const SubmissionLimits& limits) {
  try {
    return digest_of(files_of(submission.path, intake_limits(limits)));
  } catch (const std::system_error& error) {
    if (is_of_the_machine(error.code())) throw;
    return digest({error.what()});
  } catch (const std::exception& error) {
    return digest({error.what()});
  }
}

RunnableSubmission prepare(const Submission& submission, const Rubric& rubric,
                           const Confinement& confinement, const properties::RunControl& control,
                           Store* store) try {
  const auto& [layers, surroundings] = confinement;
  auto folder = std::make_shared<PrivateFolder>();
  CopiedFiles files = copied(submission, rubric.limits, folder->path());
  const auto [form, file] = form_of(folder->path(), rubric);
  CandidateSpec program = form->program;
  program.what =
      with_mark(program.what, "{file}", program.is_words() ? candidate_word(file) : file);
  RunOptions options;
  options.layers = layers;
  options.surroundings = surroundings;
  options.limits = program_limits(rubric);
  options.build_seconds = rubric.build_seconds;
  options.driver = rubric.driver.form;
  options.build_seconds_name = "build_seconds";
  options.bounds = rubric.bounds;
  options.excused_image_change = rubric.image_change;
  options.image_threshold = rubric.t_threshold;
  open_to_others(folder->path());
  const fs::path copy = folder->path();
  Preparation found{.program = program,
                    .files = top_files(files.files),
                    .as_it_comes = form->builds_as_it_comes(),
                    .opaque_files = std::move(files.opaque)};
  const auto begin = std::chrono::steady_clock::now();
  try {
    const Building building(*form, file, program, copy, files.files, std::move(files.digest));
    Built made;
    bool is_stored = false;
    if (building.is_needed()) {
      auto to = std::make_shared<PrivateFolder>();
      const auto build = [&] { return building.run(to->path(), options); };
      made = store ? store->built(building.key(layers), to->path(), build, is_stored) : build();
      folder = std::move(to);
      open_to_others(folder->path());
    }
    if (form->builds_as_it_comes()) {
      program.what = with_mark(program.what, "{program}", made.program);
    }
    if (store) {
      options.answers = store->answers(answers_key(building.key(layers), program, options.limits));
    }
    options.folder = folder->path();
    found.program = program;
    found.build_words = std::move(made.words);
    found.notes = std::move(made.notes);
    const bool is_compiled = program.kind == CandidateKind::kSource;
    External external = is_compiled
                            ? compiled_external(program, folder->path() / made.program, options)
                            : find_external(program, options);
    found.build_seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    // The rubric says in which format it is judged, whatever it declares.
    external.precision = scene::Precision::kDouble;
    RunnableSubmission runnable{std::move(external), std::move(found), is_stored};
    // The program's folder lasts as long as it; a library has one of its own.
    if (!runnable.external.folder) runnable.external.folder = std::move(folder);
    if (runnable.external.renderer) ask_in_its_form(runnable, rubric, control);
    return runnable;
  } catch (const CandidateError& error) {
    throw SubmissionError({error.why(), error.said()}, found);
  }
} catch (const SubmissionError&) {
  throw;
} catch (const fs::filesystem_error& error) {
  if (is_of_the_machine(error.code())) throw;
  refuse("its files: " + error.code().message());
} catch (const std::invalid_argument& error) {
  refuse(error.what());
}

}  // namespace raycheck::tools
