#include "tools/grade/intake/prepare.h"

#include <fmt/core.h>
#include <fnmatch.h>

#include <algorithm>
#include <boost/algorithm/string/replace.hpp>
#include <cctype>
#include <fstream>
#include <limits>
#include <set>
#include <system_error>
#include <tuple>

#include "scene/text.h"
#include "tools/grade/intake/building.h"
#include "tools/grade/intake/sources.h"
#include "tools/grade/rubric/rubric.h"
#include "tools/report/digest.h"

namespace raycheck::tools {
namespace {

namespace fs = std::filesystem;

/// If a build shows no spheres, at most this many other ways to build it are tried.
constexpr int kMostFurtherBuilds = 2;

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

/// A submission's copy.
struct CopiedFiles {
  HandedInFiles files;
  std::vector<std::string> folders;
  std::string digest;  ///< The digest of the submitted files.
  std::vector<OpaqueFile> opaque;
};

/// Copies a submission to a folder; adds a Python module for each Jupyter notebook.
CopiedFiles copied(const Submission& submission, const Rubric& rubric, const fs::path& folder) {
  const fs::path top = innermost(submission.path, [&](const std::string& name) {
    return std::ranges::any_of(rubric.forms,
                               [&](const Form& form) { return means_folder(form, name); });
  });
  HandedInPaths handed_in = paths_of(top, rubric.limits);
  HandedInPaths in_copy{{}, std::move(handed_in.folders)};
  auto& copies = in_copy.files;
  for (const auto& [name, path] : handed_in.files) {
    const fs::path to = folder / name;
    fs::create_directories(to.parent_path());
    fs::copy_file(path, to);
    copies.emplace(name, to);
  }
  for (const std::string& name : in_copy.folders) fs::create_directories(folder / name);
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
  std::string digested = digest_of(in_copy);
  return {std::move(files), std::move(in_copy.folders), std::move(digested), std::move(opaque)};
}

std::vector<std::string> top_files(const HandedInFiles& files) {
  std::vector<std::string> names;
  for (const auto& [name, file] : files) {
    if (name.find('/') == std::string::npos) names.push_back(name);
  }
  return names;
}

/// The form that fits, and the file by which it fits.
std::pair<const Form*, std::string> form_of(const fs::path& folder, const Rubric& rubric) {
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) {
    names.insert(entry.path().filename().string());
  }
  if (names.empty()) refuse("it contains no files");
  for (const Form& form : rubric.forms) {
    for (const std::string& name : names) {
      if (fits(form, name)) return {&form, name};
    }
  }
  const std::string asked = scene::joined(rubric.forms, ", ", &Form::has);
  refuse(asked.empty() ? "the rubric has no [[form]]"
                       : fmt::format("it has none of the required files: {}", asked));
}

RunOptions run_options(const Rubric& rubric, const Confinement& confinement) {
  RunOptions options;
  options.layers = confinement.layers;
  options.surroundings = confinement.surroundings;
  options.limits = program_limits(rubric);
  options.build_seconds = rubric.build_seconds;
  options.driver = rubric.driver.form;
  options.build_seconds_name = "build_seconds";
  options.bounds = rubric.bounds;
  options.excused_image_change = rubric.image_change;
  options.image_threshold = rubric.t_threshold;
  return options;
}

/// A digest of everything that a program's answers depend on, except the requests.
std::string answers_key(const std::string& build, const CandidateSpec& program,
                        const Limits& limits) {
  return digest({build, program.text(),
                 fmt::format("{} {} {} {} {} {}", limits.seconds, limits.cpu_seconds, limits.memory,
                             limits.file, limits.files, limits.processes)});
}

/// Turns a copy of a submission's files into a program that can be judged.
class Preparing {
 public:
  Preparing(const Submission& submission, const Rubric& rubric, const Confinement& confinement,
            Store* store)
      : rubric_(rubric),
        store_(store),
        options_(run_options(rubric, confinement)),
        copy_(std::make_shared<PrivateFolder>()),
        copied_(copied(submission, rubric, copy_->path())) {
    std::tie(form_, file_) = form_of(copy_->path(), rubric);
    program_ = form_->program;
    program_.what = boost::replace_all_copy(program_.what, "{file}",
                                            program_.is_words() ? candidate_word(file_) : file_);
    open_to_others(copy_->path());
    found_ = {.program = program_,
              .files = top_files(copied_.files),
              .built_automatically = form_->is_built_automatically(),
              .opaque_files = std::move(copied_.opaque)};
    start_ = run_folder(copied_.files, copied_.folders, copy_);
  }

  /// Searches the ways to build the submission and, for each program, the form that it reads.
  RunnableSubmission best_program(const properties::RunControl& control) {
    for (int builds = 0; builds <= kMostFurtherBuilds; ++builds) {
      try {
        build();
      } catch (const CandidateError& error) {
        take_failure({{error.why(), error.said()}, found_});
        break;
      }
      if (one_works(control) || made_.next_way == 0 || control.interrupted()) break;
    }
    if (!best_) throw SubmissionError(*farthest_);
    return std::move(*best_);
  }

 private:
  /// Builds in the next way.
  void build() {
    const fs::path copy = copy_->path();
    const Unbuilt unbuilt{*form_,        file_,          program_,      copy,
                          copied_.files, copied_.digest, made_.next_way};
    const std::string key = build_key(unbuilt, options_.layers), before = made_.what;
    if (store_ != nullptr) key_ = key;
    if (needs_building(unbuilt)) {
      auto to = std::make_shared<PrivateFolder>();
      const auto make = [&] { return build_submission(unbuilt, to->path(), options_); };
      made_ = store_ != nullptr ? store_->built(key, to->path(), make, is_stored_) : make();
      open_to_others(to->path());
      made_in_ = std::move(to);
    }
    if (!before.empty() && before != made_.what) draws_nothing_.push_back(before);
    build_seconds_ = options_.build_spent->seconds_since({});
    found_.build_words = made_.words;
    found_.notes = made_.notes;
    for (const std::string& other : draws_nothing_) {
      found_.notes.push_back(
          fmt::format("the program built from {} shows no spheres; it was built from {} instead",
                      other, made_.what));
    }
  }

  /// Whether one of the built programs works; it becomes `best_`.
  bool one_works(const properties::RunControl& control) {
    for (const std::string& by : made_.programs) {
      try {
        RunnableSubmission runnable = started(by, control);
        const auto& dry = runnable.found.dry_run;
        const bool works = !dry || dry->shows_a_sphere();
        if (works || !best_) best_.emplace(std::move(runnable));
        if (works) return true;
      } catch (const SubmissionError& error) {
        take_failure(error);
      }
    }
    return false;
  }

  void take_failure(const SubmissionError& error) {
    if (!farthest_ || error.progress() > farthest_->progress()) farthest_ = error;
  }

  const std::shared_ptr<const PrivateFolder>& folder() const { return made_in_ ? made_in_ : copy_; }

  /// Starts one of the programs, given its command line. Errors: SubmissionError.
  RunnableSubmission started(const std::string& by, const properties::RunControl& control) const {
    Preparation found = found_;
    CandidateSpec program = program_;
    if (found.built_automatically)
      program.what = boost::replace_all_copy(program.what, "{program}", by);
    found.program = program;
    if (const std::size_t count = made_.programs.size(); count > 1) {
      found.notes.push_back(fmt::format("{} programs are built; {} is run", count, by));
    }
    RunOptions options = options_;
    if (store_ != nullptr) {
      options.answers = store_->answers(answers_key(key_, program, options.limits));
    }
    options.folder = folder()->path();
    try {
      External external = program.kind == CandidateKind::kSource
                              ? compiled_external(program, options.folder / by, options)
                              : find_external(program, options);
      found.build_seconds = build_seconds_;
      // The rubric sets the precision, whatever the submission declares.
      external.precision = scene::Precision::kDouble;
      RunnableSubmission runnable{std::move(external), std::move(found), is_stored_};
      // The program's folder must outlive it; a library keeps its folder itself.
      if (!runnable.external.folder) runnable.external.folder = folder();
      if (runnable.external.renderer) ask_in_its_form(runnable, control);
      return runnable;
    } catch (const CandidateError& error) {
      throw SubmissionError({error.why(), error.said()}, found);
    }
  }

  /// The same command without any submitted file, which only an instructor's wrapper answers as
  /// before: a submission must not choose its questions.
  Confined without_hand_in(Confined program) const {
    const std::string path = folder()->path();
    const auto is_handed_in = [&](const std::string& word) {
      return word.find(path) != std::string::npos;
    };
    std::ranges::replace_if(program.arguments, is_handed_in, "false");
    std::erase_if(program.readable, is_handed_in);
    program.start = nullptr;
    return program;
  }

  /// Sets up a renderer with the driver form and colours found by the dry run.
  void ask_in_its_form(RunnableSubmission& runnable, const properties::RunControl& control) const {
    Renderer renderer = *runnable.external.renderer;
    renderer.program.start = start_;
    renderer.wrapper = without_hand_in(renderer.program);
    if (!start_->links.empty()) renderer.program.readable.push_back(start_->linked->path());
    const DryRun& found =
        runnable.found.dry_run.emplace(dry_run(renderer, rubric_.driver, control));
    if (found.refusal) throw SubmissionError(*found.refusal, runnable.found);
    renderer.driver = found.driver;
    renderer.colours = found.colours;
    // The rubric's `seconds` limit all requests together.
    renderer.most_timeouts = std::numeric_limits<int>::max();
    External asked = rendering(runnable.external.name, std::move(renderer));
    asked.folder = runnable.external.folder;
    asked.copies = runnable.external.copies;
    asked.bounds = runnable.external.bounds;
    runnable.external = std::move(asked);
  }

  const Rubric& rubric_;
  Store* store_;  ///< Null: nothing is stored.
  RunOptions options_;
  std::shared_ptr<const PrivateFolder> copy_, made_in_;
  CopiedFiles copied_;
  const Form* form_ = nullptr;
  std::string file_;
  CandidateSpec program_;  ///< As in the form, with {file}.
  Preparation found_;
  std::string key_;  ///< The build's key in the store.
  Built made_;
  std::shared_ptr<const StartingFolder> start_;  ///< The folder in which a renderer runs.
  bool is_stored_ = false;
  double build_seconds_ = 0;
  std::vector<std::string> draws_nothing_;  ///< The sources of builds that show no spheres.
  std::optional<RunnableSubmission> best_;
  std::optional<SubmissionError> farthest_;
};

}  // namespace

std::vector<std::string> Preparation::all_notes() const {
  std::vector<std::string> all;
  for (const std::string& note : notes) all.push_back(plain_text(note));
  if (!dry_run) return all;
  for (const std::string& note : dry_run->notes) all.push_back(plain_text(note));
  return all;
}

properties::RunControl until_blamed(const properties::RunControl& control,
                                    const Surroundings& surroundings) {
  properties::RunControl until = control;
  until.interrupted = [&control, &surroundings] {
    return control.interrupted() || !surroundings.cause().empty();
  };
  return until;
}

Refusal outside_refusal(const std::string& cause) {
  return {"for a reason outside the submission: " + cause, ""};
}

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

RunnableSubmission prepare(const Submission& submission, const Rubric& rubric,
                           const Confinement& confinement, const properties::RunControl& control,
                           Store* store) try {
  return Preparing(submission, rubric, confinement, store).best_program(control);
} catch (const SubmissionError&) {
  throw;
} catch (const fs::filesystem_error& error) {
  if (is_of_the_machine(error.code())) throw;
  refuse("its files: " + error.code().message());
} catch (const std::invalid_argument& error) {
  refuse(error.what());
}

}  // namespace raycheck::tools
