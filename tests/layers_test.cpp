// The rooms of the house, their arrows, and what may not leave a room: read from the #include lines
// and the CMake files of every folder.

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

fs::path root() { return RAYCHECK_SOURCE_DIR; }

using Rooms = std::set<std::string>;

/// Every room but those of commands, and the rooms that its files may include. A folder inside a
/// room (kInside) is part of it. The commands, tools/*/..._command.cpp, are of the edge, which is
/// `tools`; their rooms say in their CMake files what they see (sees()).
const std::map<std::string, Rooms> kSees = {
    {"scene", {}},
    {"scene/files", {"scene"}},
    {"scene/plan", {"scene"}},
    {"reference", {"scene"}},
    {"reference/account", {"scene", "reference"}},
    {"reference/visibility", {"scene", "scene/plan", "reference"}},
    {"fast", {"scene", "scene/plan"}},
    {"proofs", {"scene/plan", "reference", "reference/visibility", "fast"}},
    {"properties",
     {"scene", "scene/plan", "reference", "reference/account", "reference/visibility"}},
    {"properties/laws",
     {"scene", "scene/plan", "reference", "reference/account", "reference/visibility",
      "properties"}},
    {"properties/cases", {"scene", "scene/files", "properties"}},
    {"properties/candidates", {"scene", "reference", "fast", "properties"}},
    {"properties/mistakes",
     {"scene", "scene/plan", "reference/visibility", "fast", "properties",
      "properties/candidates"}},
    {"properties/search", {"scene", "properties", "properties/laws", "properties/cases"}},
    {"library",
     {"scene", "scene/files", "reference", "reference/account", "fast", "properties",
      "properties/laws", "properties/cases", "properties/candidates", "properties/mistakes",
      "properties/search", "tools/report"}},
    {"tools/run", {"scene", "scene/plan", "properties"}},
    {"tools/report",
     {"scene", "scene/files", "reference", "reference/account", "reference/visibility",
      "properties", "properties/laws", "properties/mistakes"}},
    {"tools/shards", {"properties", "tools/run", "tools/report"}},
    {"tools/gates", {"scene", "properties", "tools/report"}},
    {"tools/implementations", {"scene/files", "fast", "properties", "properties/candidates"}},
    {"tools/external",
     {"scene", "scene/files", "properties", "properties/cases", "properties/mistakes",
      "tools/implementations", "tools/report"}},
    {"tools/explain",
     {"scene", "reference", "reference/account", "fast", "properties", "properties/laws",
      "tools/implementations", "tools/report"}},
    {"tools/image",
     {"scene", "scene/files", "reference/visibility", "properties", "tools/run", "tools/report",
      "tools/implementations"}},
    {"tools/view",
     {"scene", "scene/files", "reference", "reference/visibility", "properties", "properties/laws",
      "tools/explain", "tools/image", "tools/implementations", "tools/report", "tools/run"}},
    {"tools/grade/rubric",
     {"scene/files", "properties/laws", "properties/cases", "tools/report", "tools/implementations",
      "tools/external"}},
    {"tools/grade/results",
     {"scene", "scene/files", "properties", "tools/report", "tools/external",
      "tools/grade/rubric"}},
    {"tools/grade/store", {"tools/report", "tools/external", "tools/grade/rubric"}},
    {"tools/grade/intake",
     {"properties", "tools/report", "tools/external", "tools/grade/rubric", "tools/grade/results",
      "tools/grade/store"}},
    {"tools/grade/judging",
     {"scene", "properties", "properties/laws", "properties/cases", "properties/mistakes",
      "properties/search", "tools/implementations", "tools/external", "tools/grade/rubric",
      "tools/grade/results"}},
    {"tools/grade/pages",
     {"scene", "scene/files", "properties/laws", "properties/cases", "tools/implementations",
      "tools/report", "tools/external", "tools/view", "tools/grade/rubric",
      "tools/grade/results"}}};

/// Folders that are part of the room around them: `internal` ones are for that room's .cpp files
/// and for each other; of `reference` one room more may look inside.
const std::map<std::string, std::string> kInside = {
    {"reference/internal", "reference"},
    {"reference/account/internal", "reference/account"},
    {"fast/internal", "fast"},
    {"fast/methods", "fast"},
    {"tools/external/sandbox", "tools/external"},
    {"tools/external/protocol", "tools/external"},
    {"tools/external/pictures", "tools/external"},
    {"tools/view/chart", "tools/view"},
    {"tools/view/figure", "tools/view"},
    {"tools/view/page", "tools/view"},
    {"tools/view/panel", "tools/view"},
    {"tools/view/pictures", "tools/view"}};

/// What every program may link of tools/: what judges one scene.
const Rooms kJudgesOneScene = {
    "tools/run",      "tools/report",  "tools/shards", "tools/gates", "tools/implementations",
    "tools/external", "tools/explain", "tools/image",  "tools/view",  "tools/check",
    "tools/show"};

/// What else each program may, by the name that the table of commands has for it.
const std::map<std::string, Rooms> kMayLink = {
    {"check", {}},
    {"study",
     {"tools/properties", "tools/stress", "tools/tradeoff", "tools/worst", "tools/plan",
      "tools/list"}},
    {"grade",
     {"tools/grade", "tools/grade/rubric", "tools/grade/results", "tools/grade/store",
      "tools/grade/intake", "tools/grade/judging", "tools/grade/pages", "tools/rubric"}}};

/// Programs of their own, which may see whatever they measure.
const Rooms kPrograms = {"tools/bench"};

const std::string kEdge = "tools";

/// What implementations include as <raycheck/...>.
const std::string kPublic = "include";

bool is_source(const fs::path& path) {
  return path.extension() == ".h" || path.extension() == ".hpp" || path.extension() == ".cpp";
}

bool is_header(const std::string& file) { return !file.ends_with(".cpp"); }

std::string text_of(const fs::path& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::string folder_of(const std::string& file) { return file.substr(0, file.rfind('/')); }

/// The room of a file, by its path.
std::string room_of(const std::string& file) {
  if (file.ends_with("_command.cpp")) return kEdge;
  if (fs::exists(root() / kPublic / file)) return kPublic + "/raycheck";
  std::string folder = folder_of(file);
  while (kInside.contains(folder)) folder = kInside.at(folder);
  return folder;
}

/// Every file below the product's folders.
std::vector<fs::path> files() {
  std::vector<fs::path> result;
  for (const char* top :
       {"scene", "reference", "fast", "properties", "proofs", "tools", "library"}) {
    const fs::recursive_directory_iterator below(root() / top);
    result.insert(result.end(), begin(below), end(below));
  }
  return result;
}

/// Every source below them.
const std::vector<std::string>& sources() {
  static const std::vector<std::string> all = [] {
    std::vector<std::string> result;
    for (const fs::path& path : files()) {
      if (is_source(path)) result.push_back(fs::relative(path, root()).generic_string());
    }
    std::sort(result.begin(), result.end());
    return result;
  }();
  return all;
}

/// The rooms after SEES in each raycheck_room(...) of the CMake files.
const std::map<std::string, Rooms>& linked_rooms() {
  static const std::map<std::string, Rooms> all = [] {
    std::map<std::string, Rooms> result;
    for (const fs::path& path : files()) {
      if (path.filename() != "CMakeLists.txt") continue;
      const std::string text = text_of(path), call = "raycheck_room(";
      for (std::size_t at = 0; (at = text.find(call, at)) != std::string::npos;) {
        at += call.size();
        std::istringstream words(text.substr(at, text.find(')', at) - at));
        std::string room, keyword;
        words >> room;
        Rooms& seen = result[room];
        for (std::string word; words >> word;) {
          if (std::isupper(static_cast<unsigned char>(word[0])) != 0) keyword = word;
          if (keyword == "SEES" && word != keyword) seen.insert(word);
        }
      }
    }
    return result;
  }();
  return all;
}

/// The rooms of commands.
const Rooms& commands() {
  static const Rooms all = [] {
    Rooms result;
    for (const std::string& file : sources()) {
      if (file.ends_with("_command.cpp")) result.insert(folder_of(file));
    }
    return result;
  }();
  return all;
}

/// Every room, and the rooms that its files may include.
const std::map<std::string, Rooms>& sees() {
  static const std::map<std::string, Rooms> all = [] {
    std::map<std::string, Rooms> result = kSees;
    const auto& linked = linked_rooms();
    for (const std::string& room : commands()) {
      const auto found = linked.find(room);
      result[room] = found == linked.end() ? Rooms() : found->second;
    }
    return result;
  }();
  return all;
}

struct Include {
  std::string from;    ///< "reference/exact_ray.h"
  std::string target;  ///< What stands between the quotes or brackets.
  bool quoted = false;
};

const std::vector<Include>& includes() {
  static const std::vector<Include> all = [] {
    std::vector<Include> result;
    for (const std::string& file : sources()) {
      std::istringstream lines(text_of(root() / file));
      for (std::string line; std::getline(lines, line);) {
        const std::size_t at = line.find_first_not_of(" \t");
        if (at == std::string::npos || line.compare(at, 8, "#include") != 0) continue;
        const std::size_t begin = line.find_first_of("\"<", at);
        const std::size_t end = line.find_first_of("\">", begin + 1);
        result.push_back({file, line.substr(begin + 1, end - begin - 1), line[begin] == '"'});
      }
    }
    return result;
  }();
  return all;
}

TEST(Rooms, AreAllKnown) {
  EXPECT_GT(sources().size(), 250u);
  for (const std::string& file : sources()) {
    const std::string room = room_of(file);
    EXPECT_TRUE(sees().contains(room) || kPrograms.contains(room) || room == kEdge)
        << file << " lies in no known room";
  }
  for (const auto& [room, seen] : sees()) {
    EXPECT_TRUE(fs::is_directory(root() / room)) << room;
    for (const std::string& other : seen) EXPECT_TRUE(sees().contains(other)) << other;
  }
}

/// An include that does not say the room, as that of a neighbour or by "..", is of none.
TEST(Rooms, HaveArrowsOneWay) {
  std::map<std::string, Rooms> used;
  for (const Include& include : includes()) {
    if (!include.quoted) continue;
    const std::string from = room_of(include.from);
    const std::string to = room_of(include.target);
    if (from == to || kPrograms.contains(from) || from == kEdge) continue;
    used[from].insert(to);
    EXPECT_TRUE(sees().at(from).contains(to)) << include.from << " includes " << include.target;
  }
  for (const auto& [room, seen] : sees()) {
    for (const std::string& other : seen) {
      EXPECT_TRUE(used[room].contains(other)) << room << " never includes " << other;
    }
  }
}

TEST(Rooms, OfCommandsSeeNoOtherCommand) {
  EXPECT_GT(commands().size(), 5u);
  for (const std::string& room : commands()) {
    EXPECT_TRUE(linked_rooms().contains(room)) << room << " has no CMakeLists.txt that says so";
    for (const std::string& other : sees().at(room)) {
      EXPECT_FALSE(commands().contains(other)) << room << " sees " << other;
    }
  }
}

TEST(Rooms, SeeNoRoomThatSeesThem) {
  Rooms placed;  // in an order in which each sees earlier ones only
  for (std::size_t before = 1; before != placed.size();) {
    before = placed.size();
    for (const auto& [room, seen] : sees()) {
      if (std::includes(placed.begin(), placed.end(), seen.begin(), seen.end())) {
        placed.insert(room);
      }
    }
  }
  EXPECT_EQ(placed.size(), sees().size()) << "rooms see each other in a circle";
}

TEST(Rooms, LinkWhatTheySeeAndNoMore) {
  const auto& linked = linked_rooms();
  for (const auto& [room, seen] : sees()) {
    ASSERT_TRUE(linked.contains(room)) << room;
    EXPECT_EQ(linked.at(room), seen) << room;
  }
}

/// The rooms that files of the edge include, and all that these see.
Rooms needed_by(const std::set<std::string>& files) {
  Rooms needed;
  std::vector<std::string> found;
  for (const Include& include : includes()) {
    const std::string room = room_of(include.target);
    if (include.quoted && files.contains(include.from) && room != kEdge) found.push_back(room);
  }
  while (!found.empty()) {
    const std::string room = found.back();
    found.pop_back();
    if (!needed.insert(room).second || !sees().contains(room)) continue;
    found.insert(found.end(), sees().at(room).begin(), sees().at(room).end());
  }
  return needed;
}

TEST(Programs, NeedWhatTheyMayLinkAndNoMore) {
  std::map<std::string, std::set<std::string>> files;  // of each program
  const std::string table = text_of(root() / "tools/commands.h");
  const std::regex row("\n  ROW\\((\\w+), (\\w+),");
  for (std::sregex_iterator at(table.begin(), table.end(), row), end; at != end; ++at) {
    files[(*at)[2]].insert((*at)[1].str() + "_command.cpp");
  }
  EXPECT_EQ(files.size(), kMayLink.size());
  for (auto& [program, of_program] : files) {
    std::set<std::string> edge;
    for (const std::string& file : sources()) {
      const bool is_shared = folder_of(file) == kEdge;
      if (is_shared || of_program.contains(file.substr(file.rfind('/') + 1))) edge.insert(file);
    }
    ASSERT_TRUE(kMayLink.contains(program)) << program;
    Rooms of_tools;
    for (const std::string& room : needed_by(edge)) {
      if (room.starts_with("tools/") && !kJudgesOneScene.contains(room)) of_tools.insert(room);
    }
    EXPECT_EQ(of_tools, kMayLink.at(program)) << program;
  }
}

TEST(Rooms, ShowNoInternalHeader) {
  for (const Include& include : includes()) {
    const std::string folder = folder_of(include.target);
    if (!include.quoted || !folder.ends_with("/internal")) continue;
    const bool is_account_of_it = room_of(include.from) == room_of(include.target) + "/account";
    // Which prove their formulas' bounds.
    const bool is_proof = room_of(include.from) == "proofs";
    EXPECT_TRUE(room_of(include.from) == room_of(include.target) || is_account_of_it || is_proof)
        << include.from << " includes " << include.target;
  }
}

/// Headers of reference/internal that show no CGAL, so that others may show them.
const std::set<std::string> kPlainInternalHeaders = {"reference/internal/double_double.h",
                                                     "reference/internal/kept.h",
                                                     "reference/internal/triple.h"};

/// A library, the rooms that may include it, and the folders whose headers may show it.
struct Kept {
  const char* library;
  Rooms rooms;
  std::string shown_in;
};

TEST(Rooms, KeepLibrariesInside) {
  for (const auto& [library, rooms, shown_in] :
       {Kept{"CGAL/", {"reference", "reference/account"}, "/internal"},
        Kept{"Eigen/", {"fast"}, ""}, Kept{"rapidcheck", {"properties/search"}, "none"},
        Kept{"CLI/", {kEdge}, ""}}) {
    std::size_t found = 0;
    for (const Include& include : includes()) {
      if (!include.target.starts_with(library)) continue;
      ++found;
      EXPECT_TRUE(rooms.contains(room_of(include.from))) << include.from << " " << library;
      EXPECT_TRUE(!is_header(include.from) || folder_of(include.from).ends_with(shown_in))
          << include.from << " shows " << library;
    }
    EXPECT_GT(found, 0u) << library;
  }
  for (const Include& include : includes()) {
    if (folder_of(include.target) != "reference/internal") continue;
    const bool shown =
        is_header(include.from) && (!folder_of(include.from).ends_with("/internal") ||
                                    kPlainInternalHeaders.contains(include.from));
    EXPECT_TRUE(!shown || kPlainInternalHeaders.contains(include.target))
        << include.from << " shows " << include.target;
  }
}

/// What others include shows them the standard library, itself, and the framework that it is for.
TEST(PublicHeaders, ShowNothingOfOthers) {
  const std::map<std::string, std::string> frameworks = {{"gtest.h", "gtest/"},
                                                         {"catch2.h", "catch2/"},
                                                         {"doctest.h", "doctest/"},
                                                         {"rapidcheck.h", "rapidcheck"}};
  const std::regex line("(?:^|\\n)#include ([<\"])([^>\"]*)");
  std::size_t found = 0;
  for (const auto& entry : fs::directory_iterator(root() / kPublic / "raycheck")) {
    const std::string text = text_of(entry.path()), name = entry.path().filename();
    const auto framework = frameworks.find(name);
    for (std::sregex_iterator at(text.begin(), text.end(), line), end; at != end; ++at, ++found) {
      const std::string target = (*at)[2];
      const bool is_of_framework =
          framework != frameworks.end() && target.starts_with(framework->second);
      EXPECT_TRUE((*at)[1] == "<" &&
                  (target.find('.') == std::string::npos || target.starts_with("std") ||
                   is_of_framework || target.starts_with("raycheck/")))
          << name << " includes " << target;
    }
  }
  EXPECT_GT(found, 30u);
}

/// Sources of programs that speak to raycheck through their standard output.
const std::set<std::string> kSpeakThroughTheirOutput = {"tools/external/sandbox/jail.cpp",
                                                        "tools/external/protocol/worker.cpp",
                                                        "tools/external/protocol/last_frames.cpp"};

TEST(Rooms, LetTheEdgeAlonePrint) {
  for (const std::string& file : sources()) {
    const std::string room = room_of(file);
    if (room == kEdge || kPrograms.contains(room) || kSpeakThroughTheirOutput.contains(file))
      continue;
    const std::string text = text_of(root() / file);
    for (const char* way : {"std::cout", "std::cerr", "std::clog", "printf(", "puts(", "fmt::print",
                            ", stdout", ", stderr", "perror(", "std::exit", "std::abort",
                            "std::quick_exit", "std::signal", "sigaction("}) {
      const std::size_t at = text.find(way);
      EXPECT_TRUE(at == std::string::npos || text.compare(at - 2, 2, "sn") == 0)
          << file << " uses " << way;
    }
  }
}

/// What writes command lines of other programs, and of the package that runs raycheck itself.
const std::set<std::string> kWriteCommandLines = {"tools/external/sandbox/launch.cpp",
                                                  "tools/external/compile.cpp",
                                                  "tools/external/implementation_of.cpp",
                                                  "tools/implementations/implementation.cpp",
                                                  "tools/view/scene_view.cpp",
                                                  "tools/view/panel/panel.cpp",
                                                  "tools/grade/package.cpp",
                                                  "tools/grade/pages/figures.cpp"};

TEST(Rooms, LetTheEdgeAndViewsForPeopleAloneNameOptions) {
  static const std::regex literal(R"re("((?:[^"\\]|\\.)*)")re"), option("(^|[^-])--[a-z]");
  std::size_t named_by_views = 0;
  for (const std::string& file : sources()) {
    const std::string room = room_of(file);
    if (room == kEdge || kPrograms.contains(room) || kWriteCommandLines.contains(file)) continue;
    // Which may say how more is shown.
    const bool is_view_for_people = file.ends_with("_text.cpp") || file.ends_with("_page.cpp");
    std::istringstream lines(text_of(root() / file));
    for (std::string line; std::getline(lines, line);) {
      if (line.find_first_not_of(' ') == line.find("//")) continue;
      for (std::sregex_iterator at(line.begin(), line.end(), literal), end; at != end; ++at) {
        const std::string text = (*at)[1];
        if (!std::regex_search(text, option)) continue;
        EXPECT_TRUE(is_view_for_people && !text.starts_with("--")) << file << ": " << text;
        ++named_by_views;
      }
    }
  }
  EXPECT_GT(named_by_views, 0u);
}

TEST(Rooms, AreMirroredByTheTests) {
  // What is wrong on purpose or by bad luck, and what comes of it.
  const Rooms of_tests_alone = {"mutants", "dull", "caught", "faults", "fuzz", "properties/oracle"};
  for (const auto& entry : fs::recursive_directory_iterator(root() / "tests")) {
    if (!entry.path().filename().string().ends_with("_test.cpp")) continue;
    const std::string folder =
        fs::relative(entry.path(), root() / "tests").parent_path().generic_string();
    if (folder.empty() || of_tests_alone.contains(folder)) continue;
    EXPECT_TRUE(fs::is_directory(root() / folder)) << entry.path() << " mirrors no room";
  }
}

}  // namespace
