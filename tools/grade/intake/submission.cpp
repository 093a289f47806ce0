#include "tools/grade/intake/submission.h"

#include <fmt/core.h>
#include <fnmatch.h>

#include <algorithm>
#include <fstream>
#include <iterator>
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
#include "tools/grade/intake/run_folder.h"
#include "tools/grade/intake/starting.h"
#include "tools/grade/rubric/rubric_files.h"

namespace raycheck::tools {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const std::string& why) { throw SubmissionError({why, ""}, {}); }

IntakeLimits intake_limits(const SubmissionLimits& limits) {
  return {limits.submission_mib, static_cast<std::size_t>(limits.files)};
}

}  // namespace

properties::RunControl until_blamed(const properties::RunControl& control,
                                    const Surroundings& surroundings) {
  properties::RunControl until = control;
  until.interrupted = [&control, &surroundings] {
    return control.interrupted() || !surroundings.cause().empty();
  };
  return until;
}

Refusal outside_refusal(const std::string& cause) {
  return {"the cause lies outside it: " + cause, ""};
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

namespace {

struct CopiedFiles {
  HandedInFiles files;
  std::vector<std::string> folders;
  std::string digest;  ///< Of those that were handed in.
  std::vector<OpaqueFile> opaque;
};

/// Copies a submission to a folder; a Jupyter notebook lies there as a module of Python too.
CopiedFiles copied(const Submission& submission, const SubmissionLimits& limits,
                   const fs::path& folder) {
  HandedInPaths handed_in = paths_of(innermost(submission.path), intake_limits(limits));
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
    return digest_of(paths_of(submission.path, intake_limits(limits)));
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
  std::shared_ptr<const PrivateFolder> folder = std::make_shared<PrivateFolder>();
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
  BuiltSubmission built{rubric, program, std::move(found), options, store};
  built.start = run_folder(files.files, files.folders, folder);
  try {
    const Building building(*form, file, program, copy, files.files, std::move(files.digest));
    if (building.is_needed()) {
      auto to = std::make_shared<PrivateFolder>();
      const auto build = [&] { return building.run(to->path(), options); };
      built.made =
          store ? store->built(building.key(layers), to->path(), build, built.is_stored) : build();
      folder = std::move(to);
      open_to_others(folder->path());
    }
    if (store) built.key = building.key(layers);
  } catch (const CandidateError& error) {
    throw SubmissionError({error.why(), error.said()}, built.found);
  }
  built.seconds = options.build_spent->seconds();
  built.found.build_words = built.made.words;
  const auto& notes = built.made.notes;
  built.found.notes.insert(built.found.notes.end(), notes.begin(), notes.end());
  built.folder = std::move(folder);
  return likeliest(built, control);
} catch (const SubmissionError&) {
  throw;
} catch (const fs::filesystem_error& error) {
  if (is_of_the_machine(error.code())) throw;
  refuse("its files: " + error.code().message());
} catch (const std::invalid_argument& error) {
  refuse(error.what());
}

}  // namespace raycheck::tools
