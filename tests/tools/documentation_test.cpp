// Every command that the documentation shows is run, and prints what is shown.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "tests/tools/program.h"
#include "tests/tools/report/picture.h"

namespace raycheck::tests {
namespace {

/// A command in a fenced block, and the lines shown below it.
struct Shown {
  std::string where;
  bool is_python;  ///< `python3 ARGUMENTS`, not `./run ARGUMENTS`.
  std::string arguments;
  std::vector<std::string> lines;
};

/// A line of a fenced block, and where it is.
struct Line {
  std::string where;
  std::string text;
};

/// The lines of a page's blocks of one language.
std::vector<Line> blocks(const std::filesystem::path& path, const std::string& language) {
  std::vector<Line> lines;
  std::ifstream file(path);
  bool inside = false;
  int number = 0;
  for (std::string line; std::getline(file, line);) {
    ++number;
    if (line.rfind("```", 0) == 0) {
      inside = line == "```" + language;
    } else if (inside) {
      lines.push_back({path.filename().string() + ":" + std::to_string(number), line});
    }
  }
  return lines;
}

std::vector<Shown> shown_in(const std::filesystem::path& path) {
  std::vector<Shown> result;
  for (const auto& [where, line] : blocks(path, "console")) {
    if (line.rfind("$ ./run ", 0) == 0) {
      result.push_back({where, false, line.substr(8), {}});
    } else if (line.rfind("$ python3 ", 0) == 0) {
      result.push_back({where, true, line.substr(10), {}});
    } else if (!result.empty()) {
      result.back().lines.push_back(line);
    }
  }
  return result;
}

const std::string kNextStage = "| ./run ";  ///< Of a pipe.
const std::string kPictures = "docs/images/";

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  for (std::size_t at = text.find(what); at != std::string::npos;
       at = text.find(what, at + by.size())) {
    text.replace(at, what.size(), by);
  }
  return text;
}

/// A page that a command makes.
const std::regex kPage(R"( --(out|view) (\S+\.html)\b)");

/// Runs a command that makes a page, elsewhere.
Outcome run_page(const Shown& shown, const std::smatch& page) {
  const std::string path = temporary_file(page[2], "");
  Outcome result = run(std::string(page.prefix()) + " --" + page[1].str() + " '" + path + "'" +
                       page.suffix().str());
  result.out = replaced(result.out, path, page[2]);
  EXPECT_TRUE(contents(path).starts_with("<!doctype html>")) << shown.where;
  std::filesystem::remove(path);
  return result;
}

/// Runs a command; a picture that it writes goes to a folder of its own, and is what the
/// documentation shows.
Outcome run_shown(const Shown& shown) {
  std::smatch page;
  if (std::regex_search(shown.arguments, page, kPage)) return run_page(shown, page);
  if (shown.is_python) return run_python(shown.arguments);
  if (shown.arguments.find(kNextStage) != std::string::npos) {
    return run(replaced(shown.arguments, kNextStage, "| '" RAYCHECK_BINARY "' "));
  }
  const std::string option = " --out " + kPictures;
  if (shown.arguments.find(option) == std::string::npos) return run(shown.arguments);
  const std::string folder = temporary_file("pictures", "") + ".d/";
  std::filesystem::create_directory(folder);
  Outcome result = run(replaced(shown.arguments, option, " --out " + folder));
  result.out = replaced(result.out, folder, kPictures);
  int pictures = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    EXPECT_TRUE(read_picture(entry.path().string()) ==
                read_picture(std::string(RAYCHECK_SOURCE_DIR) + "/" + kPictures + name))
        << shown.where << ": " << name;
    ++pictures;
  }
  EXPECT_EQ(pictures, 1) << shown.where;
  std::filesystem::remove_all(folder);
  std::filesystem::remove(folder.substr(0, folder.size() - 3));
  return result;
}

/// Times differ from run to run, the number of threads and what keeps a candidate from machine to
/// machine.
std::string without_times(std::string line) {
  static const std::pair<std::regex, const char*> kTimes[] = {
      {std::regex(R"([0-9.]+ ns per ray.*$)"), "T ns per ray"},
      {std::regex(R"(^[-0-9.e]+ ms to plan, [-0-9.e]+ ms the image)"),
       "T ms to plan, T ms the image"},
      {std::regex(R"( +[-0-9.e]+ +~?[-0-9.e]+ +-?[0-9]+%  )"), " T  "},  // an item of a plan
      {std::regex(" +- +- +-  "), "  -  -  -  "},                        // one that is not timed
      {std::regex(" +ms with +ms without"), " ms with  ms without"},     // above them
      {std::regex(R"( +[0-9.]+ s(?=  ))"), " T s"},                      // of a dry run
      {std::regex("isolated by: .*$"), "isolated"},
      {std::regex(R"(built in [0-9.]+ s(, [0-9]+ from the store)?, judged in [0-9.]+ s)"),
       "built and judged in T s"},
      {std::regex(R"(in [-0-9.e]+ s by [0-9]+ threads?$)"), "in T s"}};
  for (const auto& [time, stands_for] : kTimes) line = std::regex_replace(line, time, stands_for);
  return line;
}

/// On a terminal this is one line that goes, and documents show what stays there.
const std::regex kProgress("^submissions: [0-9]+ of [0-9]+ (tried|graded): .*");

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    const std::string line = text.substr(at, end - at);
    if (!std::regex_match(line, kProgress)) lines.push_back(without_times(line));
    at = end + 1;
  }
  return lines;
}

/// The shown lines occur in order; "..." stands for any lines.
void expect_shown(const Shown& shown, const std::vector<std::string>& printed) {
  std::size_t at = 0;
  bool may_skip = false;
  for (const std::string& raw : shown.lines) {
    if (raw == "...") {
      may_skip = true;
      continue;
    }
    const std::string line = without_times(raw);
    while (may_skip && at < printed.size() && printed[at] != line) ++at;
    ASSERT_LT(at, printed.size()) << shown.where << ": not printed: " << raw;
    ASSERT_EQ(printed[at], line) << shown.where;
    ++at;
    may_skip = false;
  }
}

/// README.md, CONTRIBUTING.md and the documents in docs/ and its folders.
std::vector<std::filesystem::path> documents() {
  const std::filesystem::path root = RAYCHECK_SOURCE_DIR;
  std::vector<std::filesystem::path> paths = {root / "README.md", root / "CONTRIBUTING.md"};
  for (const auto& entry : std::filesystem::recursive_directory_iterator(root / "docs")) {
    if (entry.path().extension() == ".md") paths.push_back(entry.path());
  }
  return paths;
}

TEST(LongDocumentation, shows_what_the_program_prints) {
  int commands = 0;
  std::map<std::string, std::vector<std::string>> printed;  // of a command, wherever it is shown
  for (const auto& page : documents()) {
    for (const Shown& shown : shown_in(page)) {
      if (shown.arguments == "test" || shown.arguments.rfind("bench", 0) == 0) continue;
      const auto [its, is_new] = printed.emplace(shown.arguments, std::vector<std::string>());
      if (is_new) {
        const Outcome result = run_shown(shown);
        EXPECT_TRUE(result.exit_code == 0 || result.exit_code == 1)
            << shown.where << ": " << result.err;
        its->second = lines_of(result.out);
      }
      expect_shown(shown, its->second);
      ++commands;
    }
  }
  EXPECT_GE(commands, 6);
}

constexpr std::size_t kMostPictureBytes = 100'000;  ///< Of a page; a clone has them all.

/// The pictures of pages, as docs/pictures.py finds them: of pages that a command of the same
/// document makes.
TEST(Documentation, shows_pictures_of_pages_that_its_commands_make) {
  static const std::regex kPicture(R"(<!-- picture (\{.*?\}) -->\s*!\[[^\]]+\]\(([^)]+)\))");
  std::set<std::filesystem::path> shown_pictures;
  for (const auto& document : documents()) {
    std::set<std::string> pages;
    for (const Shown& shown : shown_in(document)) {
      std::smatch page;
      if (std::regex_search(shown.arguments, page, kPage)) pages.insert(page[2]);
    }
    const std::string text = contents(document);
    for (std::sregex_iterator at(text.begin(), text.end(), kPicture), end; at != end; ++at) {
      const auto wanted = nlohmann::json::parse((*at)[1].str());
      EXPECT_TRUE(pages.contains(wanted.at("page"))) << document << ": " << wanted;
      const auto path = document.parent_path() / (*at)[2].str();
      const std::string picture = contents(path);
      EXPECT_TRUE(picture.starts_with("RIFF") && picture.substr(8, 4) == "WEBP") << path;
      EXPECT_LE(picture.size(), kMostPictureBytes) << path;
      shown_pictures.insert(path.lexically_normal());
    }
  }
  EXPECT_GE(shown_pictures.size(), 20u);
  const std::string gallery = contents(RAYCHECK_SOURCE_DIR "/docs/gallery/README.md");
  for (const auto& entry :
       std::filesystem::recursive_directory_iterator(RAYCHECK_SOURCE_DIR "/docs")) {
    if (entry.path().extension() == ".webp") {
      EXPECT_TRUE(shown_pictures.contains(entry.path().lexically_normal())) << entry.path();
    }
    if (entry.path().extension() == ".toml") {
      EXPECT_NE(gallery.find("docs/gallery/" + entry.path().filename().string()), std::string::npos)
          << entry.path();
    }
  }
}

TEST(Documentation, lists_the_laws_and_the_packages_there_are) {
  const Outcome outcome = run_python("docs/generate.py --lists --check '" RAYCHECK_BINARY "'");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
}

/// The names of tests, "Suite.Test", by suite, in all of tests/.
std::map<std::string, std::set<std::string>> tests_by_suite() {
  static const std::regex kTest(R"(TEST(_F|_P)?\(\s*(\w+),\s*(\w+)\))");
  std::map<std::string, std::set<std::string>> suites;
  for (const auto& entry :
       std::filesystem::recursive_directory_iterator(RAYCHECK_SOURCE_DIR "/tests")) {
    if (!entry.path().string().ends_with("_test.cpp")) continue;
    const std::string text = contents(entry.path());
    for (std::sregex_iterator at(text.begin(), text.end(), kTest), end; at != end; ++at) {
      suites[(*at)[2]].insert((*at)[2].str() + "." + (*at)[3].str());
    }
  }
  return suites;
}

TEST(Documentation, of_security_names_tests_that_there_are_and_every_hostile_suite) {
  const std::string page = contents(RAYCHECK_SOURCE_DIR "/SECURITY.md");
  const auto suites = tests_by_suite();
  static const std::regex kName(R"(`((\w+)\.\w+)`)");
  std::set<std::string> named;
  const std::size_t table = page.find("## What was tried");
  ASSERT_NE(table, std::string::npos);
  for (std::sregex_iterator
           at(page.begin() + static_cast<std::ptrdiff_t>(table), page.end(), kName),
       end;
       at != end; ++at) {
    const auto suite = suites.find((*at)[2]);
    named.insert((*at)[2]);
    ASSERT_NE(suite, suites.end()) << (*at)[1];
    EXPECT_TRUE(suite->second.contains((*at)[1])) << (*at)[1];
  }
  EXPECT_GT(named.size(), 20u);
  for (const auto& [suite, tests] : suites) {
    if (suite.starts_with("Hostile") || suite.starts_with("LongHostile")) {
      EXPECT_TRUE(named.contains(suite)) << suite;
    }
  }
}

/// The session blocks of a page: commands with what they print, run one after the other by one
/// shell in a folder that is empty at first.
std::vector<Shown> session_of(const std::filesystem::path& path) {
  std::vector<Shown> result;
  for (const auto& [where, line] : blocks(path, "session")) {
    if (line.rfind("$ ", 0) == 0) {
      result.push_back({where, false, line.substr(2), {}});
    } else if (line.rfind("> ", 0) == 0 || line == ">") {
      result.back().arguments += "\n" + line.substr(std::min<std::size_t>(2, line.size()));
    } else {
      result.back().lines.push_back(line);
    }
  }
  return result;
}

void expect_session(const std::filesystem::path& page, std::size_t fewest) {
  constexpr char kMark = '\1';
  const std::vector<Shown> session = session_of(page);
  EXPECT_GE(session.size(), fewest) << page;
  const std::string tools = std::filesystem::path(RAYCHECK_BINARY).parent_path().string();
  const std::string folder = temporary_file(page.stem().string(), "") + ".d";
  std::filesystem::create_directory(folder);
  std::string script = "exec 2>&1\ncd '" + folder +
                       "'\nexport RAYCHECK='" RAYCHECK_SOURCE_DIR "' PATH='" + tools + "':$PATH\n";
  for (const Shown& shown : session) {
    script += std::string("printf '") + kMark + "'\n" + shown.arguments + "\n";
  }
  const Outcome result = run_bash(temporary_file("session.sh", script));
  std::size_t at = result.out.find(kMark);
  for (const Shown& shown : session) {
    ASSERT_NE(at, std::string::npos) << shown.where << ": not run";
    const std::size_t end = std::min(result.out.find(kMark, at + 1), result.out.size());
    const std::string printed = result.out.substr(at + 1, end - at - 1);
    if (shown.lines.empty()) {
      EXPECT_EQ(printed, "") << shown.where;
    }
    expect_shown(shown, lines_of(printed));
    at = end;
  }
  std::filesystem::remove_all(folder);
}

TEST(LongDocumentation, instructors_get_from_an_empty_folder_to_a_graded_class) {
  if (!is_installed("node")) GTEST_SKIP() << "Node is not installed, which runs ella";
  expect_session(std::filesystem::path(RAYCHECK_SOURCE_DIR) / "docs/grading.md", 8);
}

TEST(LongDocumentation, students_check_three_functions_by_one_command) {
  expect_session(std::filesystem::path(RAYCHECK_SOURCE_DIR) / "docs/students.md", 4);
}

}  // namespace
}  // namespace raycheck::tests
