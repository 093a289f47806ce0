#include "tools/grade/intake/building.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <boost/algorithm/string/replace.hpp>
#include <fstream>
#include <set>
#include <system_error>
#include <tuple>
#include <utility>

#include "tools/external/compile.h"
#include "tools/external/sandbox/file_tree.h"
#include "tools/grade/intake/sources.h"
#include "tools/report/digest.h"
#include "tools/report/words.h"

namespace raycheck::tools {
namespace {

namespace fs = std::filesystem;

/// At most this many programs of a build are tried.
constexpr std::size_t kMostPrograms = 8;

/// What compilers suggest is added in at most this many rounds.
constexpr int kMostHints = 3;

/// A build without errors that makes nothing to run, such as a Makefile for scripts.
struct MadeNoProgram : CandidateError {
  using CandidateError::CandidateError;
};

/// The first bytes of a file, enough to recognise its format.
std::string head_of(const fs::path& path) {
  constexpr std::size_t kFirstBytes = 64;
  return file_bytes(path, kFirstBytes);
}

/// The programs that a build made in its folder, sorted: tests last, then by the recipe's order of
/// names, by likelihood_rank(), and by age.
std::vector<std::string> made_programs(const fs::path& folder,
                                       const std::vector<std::string>& likely) {
  std::set<std::tuple<bool, std::ptrdiff_t, int, fs::file_time_type::duration, std::string>> found;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (!entry.is_regular_file() || name.find(".so") != std::string::npos ||
        !is_executable(entry.path()) || !is_program_here(head_of(entry.path())))
      continue;
    const std::string path = fs::relative(entry.path(), folder).string();
    const int rank = likelihood_rank(name);
    found.emplace(rank == kHardlyARenderer || is_aside(path),
                  std::ranges::find(likely, name) - likely.begin(), rank,
                  -entry.last_write_time().time_since_epoch(), path);
  }
  std::vector<std::string> programs;
  for (const auto& one : found) {
    if (programs.size() == kMostPrograms) break;
    programs.push_back(candidate_word("./" + std::get<std::string>(one)));
  }
  return programs;
}

/// The command line of the main class if the build made classes or jars; otherwise empty.
std::vector<std::string> made_classes(const fs::path& folder, const std::string& main_class,
                                      const HandedInFiles& handed_in) {
  if (main_class.empty()) return {};
  const std::string ending = "/" + boost::replace_all_copy(main_class, ".", "/") + ".class";
  std::string root;
  std::set<std::string> jars;
  bool has_made = false;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const std::string path = fs::relative(entry.path(), folder).string();
    const bool is_class = ("/" + path).ends_with(ending), is_jar = path.ends_with(".jar");
    if (is_jar) jars.insert(path);
    if (is_class) root = "./" + path.substr(0, path.size() - std::min(path.size(), ending.size()));
    has_made = has_made || is_class || (is_jar && !handed_in.contains(path));
  }
  if (!has_made) return {};
  return {java_words(root.empty() ? "." : root, {jars.begin(), jars.end()}, main_class)};
}

/// Builds in one way. Returns the command lines of the programs, the likeliest first; after a
/// failure, `said` is the compiler's output.
std::vector<std::string> made_by(const BuildAttempt& attempt, const Intake& intake,
                                 const fs::path& to, std::string& said) {
  if (attempt.words.empty()) {
    fs::copy(intake.sources.folder->path(), to, fs::copy_options::recursive);
    return {attempt.program};
  }
  const bool makes_program = attempt.program == kMade;
  BuildWords words{attempt.repairs + attempt.words, attempt.shown, {}, &said};
  if (makes_program) {
    // Programs and libraries, without intermediate files of compilers.
    words.keeps = [is_java = !attempt.main_class.empty()](const fs::path& file) {
      const std::string ending = file.extension().string();
      return (is_java && (ending == ".class" || ending == ".jar")) ||
             (is_elf(head_of(file)) && ending != ".o" &&
              file.string().find("/CMakeFiles/") == std::string::npos);
    };
  }
  build(intake.sources.folder->path(), words, to, intake.options);
  if (!makes_program) return {attempt.program};
  std::vector<std::string> made = made_programs(to, attempt.made);
  if (made.empty()) made = made_classes(to, attempt.main_class, intake.sources.files);
  if (made.empty()) throw MadeNoProgram(fmt::format("'{}' did not make a program", attempt.shown));
  return made;
}

/// The first package that javac reports as missing, or empty.
std::string missing_package(const std::string& said) {
  constexpr std::string_view kBefore = "error: package ", kAfter = " does not exist";
  const std::size_t before = said.find(kBefore);
  if (before == std::string::npos) return "";
  const std::size_t begin = before + kBefore.size(), end = said.find(kAfter, begin);
  return end == std::string::npos || said.find('\n', begin) < end ? ""
                                                                  : said.substr(begin, end - begin);
}

/// Builds in one way. If the compiler's output has hints, follows them and tries again.
Built built_by(BuildAttempt attempt, const Intake& intake, const fs::path& to) {
  const bool takes_options = attempt.words.find(kHintedOptions) != std::string::npos;
  for (int rounds = 0;; ++rounds) {
    std::string said;
    try {
      std::vector<std::string> programs = made_by(attempt, intake, to, said);
      return {std::move(programs), attempt.words.empty() ? "" : attempt.repairs + attempt.words,
              std::move(attempt.notes), std::move(attempt.what)};
    } catch (const CandidateError& error) {
      empty_folder(to);
      std::vector<BuildHint> hints = hints_in(said, intake.sources.files, takes_options);
      std::erase_if(hints, [&](const auto& one) { return is_one_of(attempt.notes, one.note); });
      if (hints.empty() || rounds == kMostHints) {
        const std::string package = missing_package(error.output());
        if (package.empty()) throw;
        throw CandidateError(
            fmt::format("{}: the package {} is missing: put its jar beside the sources",
                        error.why(), package),
            error.output());
      }
      for (const BuildHint& one : hints) {
        attempt.repairs += one.words;
        attempt.notes.push_back(one.note);
      }
    }
  }
}

/// The index of the way to try after this one works; 0 if there is none.
std::size_t next_way(const std::vector<BuildAttempt>& plan, std::size_t way) {
  do ++way;
  while (way < plan.size() && plan[way].only_after_failure);
  return way < plan.size() ? way : 0;
}

/// Builds in the first way that works. Each way has the full time limit, so that its outcome does
/// not depend on the time that others took.
Built auto_built(const Intake& intake, std::size_t way, const fs::path& to) {
  const RunOptions& options = intake.options;
  const std::vector<BuildAttempt> plan = build_plan(intake.sources.files);
  const SpentTime::Time before = options.build_spent->so_far();
  std::vector<std::string> failed, empty;  // empty: makes no program
  std::string why, said;
  for (; way < plan.size(); ++way) {
    if (options.build_spent->seconds_since(before) >= options.build_seconds) break;
    const BuildAttempt& attempt = plan[way];
    try {
      Built made = built_by(attempt, intake, to);
      made.next_way = next_way(plan, way);
      std::erase(failed, attempt.what);
      std::erase(empty, attempt.what);
      std::string earlier;
      if (!failed.empty()) earlier = fmt::format("{} failed; ", fmt::join(failed, " and "));
      if (!empty.empty())
        earlier += fmt::format("{} makes no program; ", fmt::join(empty, " and "));
      if (!earlier.empty())
        made.notes.insert(made.notes.begin(), earlier + "built from " + made.what);
      return made;
    } catch (const CandidateError& error) {
      if (why.empty()) {
        why = error.why();
        said = error.output();
      } else {
        said += fmt::format("{}{}{}{}", said.empty() ? "" : "\n\n", error.why(),
                            error.output().empty() ? "" : ":\n", error.output());
      }
      const bool made_none = dynamic_cast<const MadeNoProgram*>(&error) != nullptr;
      std::vector<std::string>& known = made_none ? empty : failed;
      if (!is_one_of(known, attempt.what)) known.push_back(attempt.what);
    }
  }
  throw CandidateError(why, said);
}

std::string words_of(const FittingForm& fitting) {
  return boost::replace_all_copy(fitting.form.build, "{file}", single_quoted(fitting.file));
}

}  // namespace

void lay_adapter(const Form& form, const fs::path& folder) {
  if (!form.adapter) return;
  for (const auto& own : fs::directory_iterator(adapters())) {
    fs::remove_all(folder / own.path().filename());
  }
  fs::remove_all(folder / form.adapter->name);
  std::ofstream(folder / form.adapter->name, std::ios::binary) << form.adapter->text;
  open_to_others(folder / form.adapter->name);
}

Built build_submission(const Intake& intake, std::size_t way, const fs::path& to) {
  const auto& [form, file, program] = intake.fitting;
  if (form.is_built_automatically()) return auto_built(intake, way, to);
  const bool is_source = program.kind == CandidateKind::kSource;
  const std::string words = words_of(intake.fitting);
  const PrivateFolder made;
  fs::path from = intake.sources.folder->path();
  if (!form.build.empty()) {
    const fs::path built = is_source ? made.path() : to;
    build(from, {words, words}, built, intake.options);
    lay_adapter(form, built);
    open_to_others(built);
    from = built;
  }
  if (!is_source) return {{""}, words};
  std::error_code error;
  const fs::path source = fs::canonical(from / program.what, error);
  if (error) throw CandidateError(fmt::format("{}: {}", program.what, error.message()));
  return {{compile(source, to, intake.options).library.filename()}, words};
}

std::string build_key(const Intake& intake, std::size_t way) {
  return digest({toolchain(), intake.options.layers.text(), intake.sources.digest,
                 words_of(intake.fitting), intake.fitting.program.text(), std::to_string(way)});
}

}  // namespace raycheck::tools
