// What every command prints under --format json, against docs/json.md and against itself.

#include <gtest/gtest.h>

#include <cctype>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "properties/quantile_sketch.h"
#include "tests/tools/program.h"

namespace raycheck::tests {
namespace {

using nlohmann::json;

/// A command's reports, which between them have every key that it can print.
struct Reports {
  std::string command;
  std::vector<std::string> arguments;
};

std::string scene(const std::string& name) { return " scene/examples/" + name + ".toml"; }

const std::string kRenderer =
    " --candidate \"renderer:python3 tests/candidates/rt.py upside-down {scene} {image}\"";
const std::string kAnswers = " python3 tests/candidates/answers.py ";

const std::vector<Reports>& all_reports() {
  static const std::vector<Reports> reports = {
      {"check",
       {"check" + scene("ten-spheres"), "check" + scene("far-sphere") + " --intersect quadratic",
        "check" + scene("probe") + " --rays single --intersect single-quadratic",
        "check" + scene("probe") + kRenderer}},
      {"properties",
       {"properties --cases 5",
        "properties --filter class --source distance --intersect quadratic --cases 100 "
        "--level demanding --frontier",
        "properties --filter class --cases 100 --candidate "
        "'command:python3 tests/candidates/right.py'"}},
      {"explain",
       {"explain" + scene("ten-spheres") + " --pixel 8,8",
        "explain --ray 1,1,3,4,3,0 --sphere 5,5,5,3"}},
      {"stress",
       {"stress --family distance,tangency --method quadratic,rays/lecture --cases 20 "
        "--severity 0..6"}},
      {"tradeoff",
       {"tradeoff --methods quadratic,direct --cases 50",
        "tradeoff" + scene("far-sphere") + " --methods quadratic,cross,direct"}},
      {"worst", {"worst --method intersect/quadratic --family rays --cases 50 --steps 20"}},
      {"image",
       {"image" + scene("ten-spheres") + " --what error --out OUT.png",
        "image" + scene("ten-spheres") + " --what depth --out OUT.png"}},
      {"view",
       {"view" + scene("optical-axis") + " --method quadratic", "view" + scene("lecture-examples"),
        "view --family distance --method quadratic --cases 20"}},
      {"plan", {"plan" + scene("ten-spheres")}},
      {"verify",
       {"generate --family tangency@2 --cases 20 |" + kAnswers +
        "all-hits | '" RAYCHECK_BINARY "' verify --family tangency@2 --cases 20"}},
      {"grade",
       {"grade lecture7.toml tests/submissions/rays.py --out OUT",
        "grade lecture7.toml tests/submissions/class/ella tests/submissions/rays.py --probe"}},
      {"list", {"list"}}};
  return reports;
}

/// Runs each command once for all tests.
const std::vector<json>& printed(const Reports& reports) {
  static std::map<std::string, std::vector<json>> known;
  std::vector<json>& found = known[reports.command];
  for (std::size_t k = found.size(); k < reports.arguments.size(); ++k) {
    std::string arguments = reports.arguments[k] + " --format json";
    const std::string out = temporary_file("report", "") + ".d";
    std::filesystem::create_directories(out);
    if (const std::size_t at = arguments.find("OUT"); at != std::string::npos) {
      arguments.replace(at, 3, out + "/out");
    }
    const Outcome outcome = run(arguments);
    EXPECT_TRUE(outcome.exit_code == 0 || outcome.exit_code == 1) << arguments << outcome.err;
    found.push_back(json::parse(outcome.out, nullptr, false));
    EXPECT_TRUE(found.back().is_object()) << arguments;
    std::filesystem::remove_all(out);
  }
  return found;
}

/// Calls `visit` with every object in a report, and the report itself.
void walk(const json& report, const std::function<void(const json&)>& visit) {
  if (report.is_object()) visit(report);
  if (!report.is_structured()) return;
  for (const json& part : report) walk(part, visit);
}

/// What is between backquotes on the page, by sections: under a command's name where the heading
/// has it, under "" where it holds for all.
std::map<std::string, std::vector<std::string>> documented() {
  std::map<std::string, std::vector<std::string>> spans;
  std::ifstream page(std::string(RAYCHECK_SOURCE_DIR) + "/docs/json.md");
  std::string section;
  for (std::string line; std::getline(page, line);) {
    if (line.rfind("## ", 0) == 0) {
      const bool of_command = line.rfind("## `", 0) == 0;
      section = of_command ? line.substr(4, line.find_first_of(" `", 4) - 4) : "";
    }
    for (std::size_t at = line.find('`'); at != std::string::npos; at = line.find('`', at + 1)) {
      const std::size_t end = line.find('`', at + 1);
      if (end == std::string::npos) break;
      spans[section].push_back(line.substr(at + 1, end - at - 1));
      at = end;
    }
  }
  return spans;
}

/// Whether a key stands in a span, not as a part of another word.
bool names_key(const std::string& span, const std::string& key) {
  const auto is_letter = [&](std::size_t at) {
    return at < span.size() &&
           (std::isalnum(static_cast<unsigned char>(span[at])) || span[at] == '_');
  };
  for (std::size_t at = span.find(key); at != std::string::npos; at = span.find(key, at + 1)) {
    if ((at == 0 || !is_letter(at - 1)) && !is_letter(at + key.size())) return true;
  }
  return false;
}

/// The commands that offer it, by their own help.
std::set<std::string> commands_with_json() {
  std::set<std::string> names;
  std::istringstream help(run("--help").out);
  std::string line;
  while (std::getline(help, line) && line != "Subcommands:") continue;
  while (std::getline(help, line)) {
    std::istringstream words(line);
    std::string name;
    if (!(words >> name) || line.find_first_not_of(' ') != 2) continue;
    const std::string formats = run(name + " --help").out;
    const std::size_t at = formats.find("--format TEXT:{");
    if (at == std::string::npos) continue;
    const std::string choices = formats.substr(at, formats.find('}', at) - at);
    if (choices.find("json") != std::string::npos) names.insert(name);
  }
  return names;
}

TEST(Json, is_looked_at_of_every_command_that_prints_it) {
  std::set<std::string> names;
  for (const Reports& reports : all_reports()) names.insert(reports.command);
  EXPECT_EQ(names, commands_with_json());
}

void expect_every_key_on_the_page() {
  auto spans = documented();
  std::size_t keys = 0;
  for (const Reports& reports : all_reports()) {
    ASSERT_TRUE(spans.contains(reports.command)) << reports.command << " has no section";
    std::set<std::string> printed_keys;
    for (const json& report : printed(reports)) {
      walk(report, [&](const json& object) {
        for (const auto& [key, value] : object.items()) printed_keys.insert(key);
      });
    }
    for (const std::string& key : printed_keys) {
      bool found = false;
      for (const std::string& section : {std::string(), reports.command}) {
        for (const std::string& span : spans[section]) found = found || names_key(span, key);
      }
      EXPECT_TRUE(found) << reports.command << " prints an undocumented \"" << key << "\"";
      ++keys;
    }
  }
  EXPECT_GE(keys, 200u);
}

TEST(Json, is_documented_with_the_resolution_of_its_quantiles) {
  const std::string within = "2^-" + std::to_string(properties::kSketchBits - 1) + " of it";
  EXPECT_EQ(properties::kSketchResolution, std::ldexp(1, 1 - properties::kSketchBits));
  for (const char* page : {"/docs/json.md", "/docs/problem.md"}) {
    const std::string text = contents(RAYCHECK_SOURCE_DIR + std::string(page));
    EXPECT_NE(text.find(within), std::string::npos) << page;
  }
}

void expect_reports_begin_alike() {
  std::set<json> versions;
  for (const Reports& reports : all_reports()) {
    for (const json& report : printed(reports)) {
      EXPECT_EQ(report.at("program"), "raycheck");
      EXPECT_EQ(report.at("command"), reports.command);
      EXPECT_TRUE(report.at("schema_version").is_number_integer());
      versions.insert(report["schema_version"]);
    }
  }
  EXPECT_EQ(versions.size(), 1u);
}

bool is_tally(const json& object) { return object.contains("wrong_by_kind"); }

std::uint64_t sum(const json& counts) {
  std::uint64_t total = 0;
  for (const json& count : counts) total += count.get<std::uint64_t>();
  return total;
}

void expect_parts_of_tallies_add_up() {
  std::size_t tallies = 0, wrong = 0, weighed = 0;
  for (const Reports& reports : all_reports()) {
    for (const json& report : printed(reports)) {
      walk(report, [&](const json& tally) {
        if (!is_tally(tally)) return;
        const std::string where = reports.command + ": " + tally.dump();
        EXPECT_EQ(tally["wrong_by_kind"].size(), 7u) << where;
        EXPECT_EQ(sum(tally["wrong_by_kind"]), tally["wrong"]) << where;
        const auto number = [&](const char* key) { return tally[key].get<std::uint64_t>(); };
        EXPECT_EQ(number("right") + number("wrong") + number("measured"), number("cases")) << where;
        EXPECT_EQ(sum(tally["wrong_by_standing"]), tally["wrong"]) << where;
        for (const json& answers : tally["answered"]) {
          EXPECT_LE(answers["right"], answers["asked"]) << where;
        }
        EXPECT_LE(number("ill_conditioned"), number("measured")) << where;
        EXPECT_EQ(tally["max"].is_null(), number("measured") == 0) << where;
        if (tally["max"].is_number()) {
          EXPECT_LE(tally["median"], tally["p999"]) << where;
          EXPECT_LE(tally["p999"], tally["max"]) << where;
        }
        if (!tally["outcomes"].is_null()) {
          EXPECT_EQ(sum(tally["outcomes"]), tally["cases"]) << where;
          weighed += number("measured") > 0 ? 1 : 0;
        }
        wrong += number("wrong") > 0 ? 1 : 0;
        ++tallies;
      });
    }
  }
  EXPECT_GE(tallies, 100u);
  EXPECT_GE(wrong, 5u);
  EXPECT_GE(weighed, 20u);
}

void expect_the_same_tally_everywhere() {
  std::map<std::string, std::set<std::string>> keys;  // of tallies, by command
  for (const Reports& reports : all_reports()) {
    for (const json& report : printed(reports)) {
      walk(report, [&](const json& tally) {
        if (!is_tally(tally)) return;
        std::string all;
        for (const auto& [key, value] : tally.items()) all += key + " ";
        keys[reports.command].insert(all);
      });
    }
  }
  for (const char* command : {"check", "properties", "stress", "tradeoff", "verify"}) {
    EXPECT_EQ(keys[command].size(), 1u) << command;
    EXPECT_EQ(keys[command], keys["check"]) << command;
  }
}

TEST(Json, of_every_command_is_as_its_page_says) {
  expect_every_key_on_the_page();
  expect_reports_begin_alike();
  expect_parts_of_tallies_add_up();
  expect_the_same_tally_everywhere();
}

TEST(Json, says_which_change_excused_an_answer) {
  std::map<std::string, std::set<double>> amounts;
  const auto look = [&](const std::string& arguments) {
    walk(json::parse(run(arguments + " --top 1000 --format json").out), [&](const json& found) {
      if (!found.contains("excuse") || found["excuse"].is_null()) return;
      const json& excuse = found["excuse"];
      EXPECT_FALSE(excuse.at("sentence").get<std::string>().empty());
      EXPECT_EQ(excuse["kind"] == "witness", !excuse["witness"].is_null());
      for (const json& input : excuse["witness"]) {
        const double share = std::strtod(input["share"].get<std::string>().c_str(), nullptr);
        EXPECT_NE(share, 0);
        EXPECT_LE(std::abs(share), excuse["amount"]);
      }
      if (excuse["amount"].is_number())
        amounts[excuse["kind"]].insert(excuse["amount"].get<double>());
    });
  };
  look("check" + scene("tangent-and-neighbours") + " --intersect quadratic");
  EXPECT_EQ(amounts["witness"], std::set<double>{0x1p-49});
  amounts.clear();
  look("check" + scene("tangent-and-neighbours") + " --intersect single-quadratic");
  EXPECT_EQ(amounts["witness"], std::set<double>{0x1p-20});
  amounts.clear();
  look("check" + scene("probe") +
       " --t-threshold 0.5 --candidate \"renderer:python3 "
       "tests/candidates/rt.py threshold {scene} {image}\"");
  EXPECT_EQ(amounts["threshold"], std::set<double>{0.5});
}

}  // namespace
}  // namespace raycheck::tests
