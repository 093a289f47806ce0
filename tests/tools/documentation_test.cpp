// Runs every command in the documentation and compares its output with the output shown there.

#include "tests/tools/program.h"
#include "tests/tools/report/picture.h"

namespace raycheck::tests {
namespace {

/// A command in a fenced block, and the lines shown below it.
struct Shown {
  std::string where;
  std::string program;  ///< "./run" or "python3"; empty in a session.
  std::string arguments;
  std::vector<std::string> lines;
};

/// The commands in a page's blocks of a language. Lines that begin with "> " continue a command.
std::vector<Shown> shown_in(const fs::path& path, const std::string& language) {
  static const std::regex of_console("\\$ (\\./run|python3) (.*)"), of_session("\\$ ()(.*)");
  std::vector<Shown> result;
  bool inside = false;
  int number = 0;
  for (const std::string& line : lines_of(contents(path))) {
    ++number;
    std::smatch command;
    if (line.starts_with("```")) {
      inside = line == "```" + language;
    } else if (!inside) {
      continue;
    } else if (std::regex_match(line, command, language == "console" ? of_console : of_session)) {
      const std::string where = path.filename().string() + ":" + std::to_string(number);
      result.push_back({where, command[1], command[2], {}});
    } else if (language == "session" && (line.starts_with("> ") || line == ">")) {
      result.back().arguments += "\n" + line.substr(std::min<std::size_t>(2, line.size()));
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

/// Runs a command. Its pages and pictures are written elsewhere; pictures are compared with those
/// in the documentation.
Outcome run_shown(const Shown& shown) {
  const std::string folder = temporary_folder("shown") + "/", option = " --out " + kPictures;
  std::smatch page;
  if (shown.program == "python3") return run_python(shown.arguments);
  if (std::regex_search(shown.arguments, page, kPage)) {
    Outcome result = run(std::string(page.prefix()) + " --" + page[1].str() + " " + folder +
                         page[2].str() + page.suffix().str());
    EXPECT_TRUE(contents(folder + page[2].str()).starts_with("<!doctype html>")) << shown.where;
    result.out = replaced(result.out, folder, "");
    return result;
  }
  Outcome result = run(replaced(replaced(shown.arguments, kNextStage, "| '" RAYCHECK_BINARY "' "),
                                option, " --out " + folder));
  result.out = replaced(result.out, folder, kPictures);
  const std::vector<std::string> pictures = names_in(folder);
  EXPECT_EQ(pictures.size(), has(shown.arguments, option) ? 1u : 0u) << shown.where;
  for (const std::string& name : pictures) {
    EXPECT_TRUE(read_picture(folder + name) ==
                read_picture(RAYCHECK_SOURCE_DIR "/" + kPictures + name))
        << shown.where << ": " << name;
  }
  return result;
}

/// Replaces values that differ between runs (times) or machines (threads, isolation).
std::string without_times(std::string line) {
  static const std::pair<std::regex, const char*> kTimes[] = {
      {std::regex(R"(^[-0-9.e]+ ms to plan, [-0-9.e]+ ms for the image)"),
       "T ms to plan, T ms for the image"},
      {std::regex(R"( +[-0-9.e]+ +~?[-0-9.e]+ +-?[0-9]+%  )"), " T  "},  // an item of a plan
      {std::regex(" +- +- +-  "), "  -  -  -  "},                        // one that is not timed
      {std::regex(" +ms if skipped +ms if done"), " ms if skipped  ms if done"},  // above them
      {std::regex(R"( +[0-9.]+ s(?=  ))"), " T s"},                               // of a dry run
      {std::regex("isolated by: .*$"), "isolated"},
      {std::regex(R"(built in [0-9.]+ s(, [0-9]+ from the store)?, judged in [0-9.]+ s)"),
       "built and judged in T s"},
      {std::regex(R"(in [-0-9.e]+ s with [0-9]+ threads?$)"), "in T s"}};
  for (const auto& [time, stands_for] : kTimes) line = std::regex_replace(line, time, stands_for);
  return line;
}

/// On a terminal this is one transient line, which documents do not show.
const std::regex kProgress("^submissions: [0-9]+ of [0-9]+ done: .*");

std::vector<std::string> lasting_lines_of(const std::string& text) {
  std::vector<std::string> lines;
  for (const std::string& line : lines_of(text)) {
    if (!std::regex_match(line, kProgress)) lines.push_back(without_times(line));
  }
  return lines;
}

/// Expects the shown lines, in order; "..." stands for any lines.
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
std::vector<fs::path> documents() {
  const fs::path root = RAYCHECK_SOURCE_DIR;
  std::vector<fs::path> paths = {root / "README.md", root / "CONTRIBUTING.md"};
  for (const auto& entry : fs::recursive_directory_iterator(root / "docs")) {
    if (entry.path().extension() == ".md") paths.push_back(entry.path());
  }
  return paths;
}

/// Runs the commands of pages for which `is_looked_at` is true, each once even if it is shown more
/// often.
void expect_prints_what_is_shown(bool (*is_looked_at)(const std::string& path), int fewest) {
  int commands = 0;
  std::map<std::string, std::vector<std::string>> printed;
  for (const auto& page : documents()) {
    if (!is_looked_at(page.string())) continue;
    for (const Shown& shown : shown_in(page, "console")) {
      if (shown.arguments == "test" || shown.arguments.rfind("bench", 0) == 0) continue;
      const auto [its, is_new] = printed.emplace(shown.arguments, std::vector<std::string>());
      if (is_new) {
        const Outcome result = run_shown(shown);
        EXPECT_TRUE(result.exit_code == 0 || result.exit_code == 1)
            << shown.where << ": " << result.err;
        its->second = lasting_lines_of(result.out);
      }
      expect_shown(shown, its->second);
      ++commands;
    }
  }
  EXPECT_GE(commands, fewest);
}

bool is_of_the_gallery(const std::string& path) { return has(path, "/docs/gallery/"); }

// The documents are split into separate suites, which run in parallel.
TEST(LongDocumentation, shows_what_the_program_prints) {
  expect_prints_what_is_shown([](const std::string& path) { return !is_of_the_gallery(path); }, 6);
}

TEST(LongGallery, shows_what_the_program_prints) {
  expect_prints_what_is_shown(is_of_the_gallery, 1);
}

constexpr std::size_t kMostPictureBytes = 100'000;  ///< Of a page: every clone contains them.

/// The pictures of pages, as docs/pictures.py finds them. Each page must be made by a command of
/// the same document.
TEST(Documentation, shows_pictures_of_pages_that_its_commands_make) {
  static const std::regex kPicture(R"(<!-- picture (\{.*?\}) -->\s*!\[[^\]]+\]\(([^)]+)\))");
  std::set<fs::path> shown_pictures;
  for (const auto& document : documents()) {
    std::set<std::string> pages;
    for (const Shown& shown : shown_in(document, "console")) {
      std::smatch page;
      if (std::regex_search(shown.arguments, page, kPage)) pages.insert(page[2]);
    }
    const std::string text = contents(document);
    // Commands within a line of text count, too.
    static const std::regex kView(R"(--view (\w+\.html))");
    for (std::sregex_iterator at(text.begin(), text.end(), kView), end; at != end; ++at) {
      pages.insert((*at)[1]);
    }
    for (std::sregex_iterator at(text.begin(), text.end(), kPicture), end; at != end; ++at) {
      const auto wanted = json::parse((*at)[1].str());
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
  for (const auto& entry : fs::recursive_directory_iterator(RAYCHECK_SOURCE_DIR "/docs")) {
    if (entry.path().extension() == ".webp") {
      EXPECT_TRUE(shown_pictures.contains(entry.path().lexically_normal())) << entry.path();
    }
    if (entry.path().extension() == ".toml") {
      EXPECT_TRUE(has(gallery, "docs/gallery/" + entry.path().filename().string())) << entry.path();
    }
  }
}

TEST(Documentation, lists_all_laws_and_packages) {
  const Outcome outcome = run_python("docs/generate.py --lists --check '" RAYCHECK_BINARY "'");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
}

TEST(Documentation, shows_newcomers_an_existing_candidate) {
  const std::string shown = contents(RAYCHECK_SOURCE_DIR "/examples/first/candidate.cpp");
  EXPECT_TRUE(has(contents(RAYCHECK_SOURCE_DIR "/README.md"), "```cpp\n" + shown + "```"));
}

/// README.md links every page, and the targets of all links exist.
TEST(Documentation, links_every_page_in_the_readme_and_has_no_dead_links) {
  const fs::path root = RAYCHECK_SOURCE_DIR;
  const std::string readme = contents(root / "README.md");
  for (const auto& entry : fs::directory_iterator(root / "docs")) {
    const std::string name = entry.path().filename().string();
    if (!name.ends_with(".md") || name.ends_with(".in.md")) continue;
    EXPECT_TRUE(has(readme, "(docs/" + name + ")")) << name;
  }
  static const std::regex kLink(R"(\]\(([^)\s#:]+)(#[^)\s]*)?\))");
  std::vector<fs::path> pages = documents();
  pages.push_back(root / "SECURITY.md");
  for (const auto& page : pages) {
    const std::string text = contents(page);
    for (std::sregex_iterator at(text.begin(), text.end(), kLink), end; at != end; ++at) {
      EXPECT_TRUE(fs::exists(page.parent_path() / (*at)[1].str())) << page << ": " << (*at)[0];
    }
  }
}

/// Files are named by their paths or the ends of these, folders with a trailing slash.
TEST(Documentation, of_contributors_names_existing_files_and_folders) {
  const fs::path root = RAYCHECK_SOURCE_DIR;
  std::vector<std::string> all;
  for (const char* room : {"docs", "examples", "fast", "library", "packaging", "properties",
                           "reference", "scene", "tests", "tools"}) {
    for (const auto& entry : fs::recursive_directory_iterator(root / room)) {
      const std::string path = entry.path().lexically_relative(root).string();
      all.push_back("/" + path + (entry.is_directory() ? "/" : ""));
    }
    all.push_back("/" + std::string(room) + "/");
  }
  const std::string page = contents(root / "CONTRIBUTING.md");
  static const std::regex kPath(R"(`([a-z0-9_/]+(/|\.cpp|\.h|\.py|\.toml|\.json|\.md))`)");
  std::size_t named = 0;
  for (std::sregex_iterator at(page.begin(), page.end(), kPath), end; at != end; ++at, ++named) {
    const std::string path = "/" + (*at)[1].str();
    EXPECT_TRUE(std::any_of(all.begin(), all.end(), [&](const std::string& one) {
      return one.ends_with(path);
    })) << path;
  }
  EXPECT_GT(named, 50u);
}

/// The names of tests, "Suite.Test", by suite, in all of tests/.
std::map<std::string, std::set<std::string>> tests_by_suite() {
  static const std::regex kTest(R"(TEST(_F|_P)?\(\s*(\w+),\s*(\w+)\))");
  std::map<std::string, std::set<std::string>> suites;
  for (const auto& entry : fs::recursive_directory_iterator(RAYCHECK_SOURCE_DIR "/tests")) {
    if (!entry.path().string().ends_with("_test.cpp")) continue;
    const std::string text = contents(entry.path());
    for (std::sregex_iterator at(text.begin(), text.end(), kTest), end; at != end; ++at) {
      suites[(*at)[2]].insert((*at)[2].str() + "." + (*at)[3].str());
    }
  }
  return suites;
}

TEST(Documentation, of_security_names_existing_tests_and_every_hostile_suite) {
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

/// Checks the session blocks of a page: one shell runs the commands one after the other, in a
/// folder that is empty at first.
void expect_session(const fs::path& page, std::size_t fewest) {
  constexpr char kMark = '\1';
  const std::vector<Shown> session = shown_in(page, "session");
  EXPECT_GE(session.size(), fewest) << page;
  const std::string tools = fs::path(RAYCHECK_BINARY).parent_path().string();
  std::string script = "exec 2>&1\ncd '" + temporary_folder("session") +
                       "'\nexport RAYCHECK='" RAYCHECK_SOURCE_DIR "' PATH='" + tools + "':$PATH\n";
  for (const Shown& shown : session) {
    script += std::string("printf '") + kMark + "'\n" + shown.arguments + "\n";
  }
  const Outcome result = run_bash(script);
  std::size_t at = result.out.find(kMark);
  for (const Shown& shown : session) {
    ASSERT_NE(at, std::string::npos) << shown.where << ": not run";
    const std::size_t end = std::min(result.out.find(kMark, at + 1), result.out.size());
    const std::string printed = result.out.substr(at + 1, end - at - 1);
    if (shown.lines.empty()) {
      EXPECT_EQ(printed, "") << shown.where;
    }
    expect_shown(shown, lasting_lines_of(printed));
    at = end;
  }
}

TEST(LongGradingSession, instructors_get_from_an_empty_folder_to_a_graded_class) {
  if (!is_installed("node")) GTEST_SKIP() << "Node is not installed, which runs ella";
  expect_session(fs::path(RAYCHECK_SOURCE_DIR) / "docs/grading.md", 8);
}

TEST(LongCampaignsSession, campaigns_are_kept_shared_and_merged) {
  expect_session(fs::path(RAYCHECK_SOURCE_DIR) / "docs/campaigns.md", 11);
}

TEST(LongStudentsSession, students_check_three_functions_by_one_command) {
  expect_session(fs::path(RAYCHECK_SOURCE_DIR) / "docs/students.md", 4);
}

/// A pair [integer, exponent] of a certificate as a hexadecimal float.
double number_of(const json& pair) {
  const double integer =
      pair[0].is_string() ? std::stod(pair[0].get<std::string>()) : pair[0].get<double>();
  return std::ldexp(integer, pair[1].get<int>());
}

TEST(Documentation, certifies_each_of_the_worst_inputs) {
  const std::string folder = RAYCHECK_SOURCE_DIR "/docs/worst-cases/intersect";
  const std::vector<std::string> rows = lines_of(contents(folder + ".csv"));
  const std::vector<std::string> certificates = lines_of(contents(folder + ".jsonl"));
  ASSERT_EQ(rows.size(), certificates.size() + 1);
  for (std::size_t k = 0; k < certificates.size(); ++k) {
    std::vector<std::string> cells;
    std::istringstream row(rows[k + 1]);
    for (std::string cell; std::getline(row, cell, ',');) cells.push_back(cell);
    const json certificate = json::parse(certificates[k]);
    const json& inputs = certificate["inputs"];
    std::size_t at = 7;
    for (const json* triple :
         {&inputs["ray"]["origin"], &inputs["ray"]["direction"], &inputs["spheres"][0]["centre"]}) {
      for (const json& pair : *triple) {
        EXPECT_EQ(std::strtod(cells.at(at++).c_str(), nullptr), number_of(pair)) << rows[k + 1];
      }
    }
    EXPECT_EQ(std::strtod(cells.at(at).c_str(), nullptr),
              number_of(inputs["spheres"][0]["radius"]));
    EXPECT_EQ(cells[1], certificate["precision"].get<std::string>());
  }
}

}  // namespace
}  // namespace raycheck::tests
