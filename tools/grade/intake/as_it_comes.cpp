#include "tools/grade/intake/as_it_comes.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <set>
#include <tuple>
#include <vector>

#include "tools/external/compile.h"
#include "tools/external/sandbox/file_tree.h"
#include "tools/grade/intake/build_plan.h"
#include "tools/grade/intake/quoting.h"
#include "tools/grade/intake/sources.h"

namespace raycheck::tools {
namespace {

namespace fs = std::filesystem;

/// Of more programs that a build made the others are not tried.
constexpr std::size_t kMostPrograms = 8;

/// The first bytes of a file, enough to tell what kind of program it is.
std::string head_of(const fs::path& path) {
  constexpr std::size_t kFirstBytes = 64;
  return file_bytes(path, kFirstBytes);
}

bool is_executable(const fs::path& path) {
  return (fs::status(path).permissions() & fs::perms::owner_exec) != fs::perms::none &&
         path.filename().string().find(".so") == std::string::npos &&
         is_program_here(head_of(path));
}

/// The programs that a build made, those in its folder: tests last, names that the recipe has in
/// its order, likelier names, newer ones.
std::vector<std::string> made_programs(const fs::path& folder,
                                       const std::vector<std::string>& likely) {
  std::set<std::tuple<bool, std::ptrdiff_t, int, fs::file_time_type::duration, std::string>> found;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (!entry.is_regular_file() || !is_executable(entry.path())) continue;
    const std::string name = entry.path().filename().string();
    const std::string path = fs::relative(entry.path(), folder).string();
    const int rank = likelihood_rank(name);
    found.emplace(rank == kHardlyARenderer || is_aside(path),
                  std::find(likely.begin(), likely.end(), name) - likely.begin(), rank,
                  -entry.last_write_time().time_since_epoch(), path);
  }
  std::vector<std::string> programs;
  for (const auto& one : found) {
    if (programs.size() < kMostPrograms) programs.push_back(std::get<std::string>(one));
  }
  return programs;
}

/// One way; the words that start what it made, likelier ones first.
std::vector<std::string> tried(const BuildAttempt& attempt, const fs::path& folder,
                               const fs::path& to, const RunOptions& options) {
  if (attempt.words.empty()) {
    fs::copy(folder, to, fs::copy_options::recursive);
    return {attempt.program};
  }
  const bool makes_program = attempt.program == kMade;
  BuildWords words{attempt.words, attempt.shown};
  if (makes_program) {
    // Programs, and libraries of theirs; not what compilers leave on the way.
    words.keeps = [](const fs::path& file) {
      return is_elf(head_of(file)) && file.extension() != ".o" &&
             file.string().find("/CMakeFiles/") == std::string::npos;
    };
  }
  build(folder, words, to, options);
  if (!makes_program) return {attempt.program};
  std::vector<std::string> made = made_programs(to, attempt.made);
  if (made.empty()) throw CandidateError(fmt::format("'{}' makes no program", attempt.shown));
  for (std::string& program : made) program = candidate_word("./" + program);
  return made;
}

}  // namespace

Built build_as_it_comes(const fs::path& folder, const HandedInFiles& files, const fs::path& to,
                        const RunOptions& options) {
  const BuildPlan plan = build_plan(files);
  if (plan.attempts.empty()) throw CandidateError(plan.why_none);
  std::vector<std::string> failed;
  std::string why, said;
  for (const BuildAttempt& attempt : plan.attempts) {
    // Each has all of it, so that what is said of one does not depend on how long others took.
    if (options.build_spent->seconds() >= options.build_seconds) break;
    try {
      Built built{tried(attempt, folder, to, options), attempt.words, {}};
      for (const std::string& what : failed) {
        built.notes.push_back(fmt::format("{} failed; built from {}", what, attempt.what));
      }
      built.notes.insert(built.notes.end(), attempt.notes.begin(), attempt.notes.end());
      return built;
    } catch (const CandidateError& error) {
      if (why.empty()) {
        why = error.why();
        said = error.said();
      } else {
        said += fmt::format("{}{}{}{}", said.empty() ? "" : "\n\n", error.why(),
                            error.said().empty() ? "" : ":\n", error.said());
      }
      if (failed.empty() || failed.back() != attempt.what) failed.push_back(attempt.what);
      empty_folder(to);
    }
  }
  throw CandidateError(why, said);
}

}  // namespace raycheck::tools
