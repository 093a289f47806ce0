// Compares the output of every command with --format json with docs/json.md, and checks its
// consistency. Tests also texts of others in JSON and CSV.

#include "tools/report/json.h"

#include "properties/quantile_sketch.h"
#include "tests/tools/program.h"
#include "tools/report/spelling.h"

namespace raycheck::tests {
namespace {

/// Reports of a command that together have every key that it can print.
struct Reports {
  std::string command;
  std::vector<std::string> arguments;
};

std::string scene(const std::string& name) { return " scene/examples/" + name + ".toml"; }

const std::string kRenderer =
    " --candidate \"renderer:python3 tests/candidates/rt.py upside-down {scene} {image}\"";

const std::vector<Reports>& all_reports() {
  static const std::vector<Reports> reports = {
      {"check",
       {"check" + scene("ten-spheres"), "check" + scene("far-sphere") + " --intersect quadratic",
        "check" + scene("probe") + " --rays single --intersect single-quadratic",
        "check" + scene("probe") + kRenderer}},
      {"properties",
       {"properties --cases 100",
        "properties --filter class --source distance --intersect quadratic --cases 100 "
        "--level demanding",
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
      {"image", {"image" + scene("ten-spheres") + " --what error --out OUT.png"}},
      {"view",
       {"view" + scene("optical-axis") + " --method quadratic", "view" + scene("lecture-examples"),
        "view --family distance --method quadratic --cases 20"}},
      {"plan", {"plan" + scene("ten-spheres")}},
      {"grade",
       {"grade lecture7.toml tests/submissions/rays.cpp --out OUT",
        "grade lecture7.toml tests/submissions/class/ella tests/submissions/rays.cpp --probe"}},
      {"list", {"list"}}};
  return reports;
}

/// Runs each command once for all tests.
const std::vector<json>& printed(const Reports& reports) {
  static std::map<std::string, std::vector<json>> known;
  std::vector<json>& found = known[reports.command];
  for (std::size_t k = found.size(); k < reports.arguments.size(); ++k) {
    std::string arguments = reports.arguments[k] + " --format json";
    if (has(arguments, "OUT")) {
      arguments = replaced(arguments, "OUT", temporary_folder("report") + "/out");
    }
    const Outcome outcome = run(arguments);
    EXPECT_TRUE(outcome.exit_code == 0 || outcome.exit_code == 1) << arguments << outcome.err;
    found.push_back(json::parse(outcome.out, nullptr, false));
    EXPECT_TRUE(found.back().is_object()) << arguments;
  }
  return found;
}

/// Calls `visit` with every object in a report, and the report itself.
void walk(const json& report, const std::function<void(const json&)>& visit) {
  if (report.is_object()) visit(report);
  if (!report.is_structured()) return;
  for (const json& part : report) walk(part, visit);
}

/// The words of a text, each between spaces.
std::string words_of(const std::string& text) {
  return " " + std::regex_replace(text, std::regex("\\W"), " ") + " ";
}

/// The words between backquotes on the page, by the command in the heading of their section; "" is
/// for all commands.
std::map<std::string, std::string> documented() {
  static const std::regex span("`([^`]*)`"), heading("## `(\\w+).*");
  std::map<std::string, std::string> words;
  std::string section;
  for (const std::string& line : lines_of(contents(RAYCHECK_SOURCE_DIR "/docs/json.md"))) {
    if (line.starts_with("## ")) section = std::regex_replace(line, heading, "$1");
    if (section.starts_with("## ")) section.clear();
    for (std::sregex_iterator at(line.begin(), line.end(), span), end; at != end; ++at) {
      words[section] += words_of((*at)[1]);
    }
  }
  return words;
}

/// The commands with --format json, by their help.
std::set<std::string> commands_with_json() {
  std::set<std::string> names;
  for (const std::string& name : all_commands()) {
    const std::string help = run(name + " --help").out;
    if (std::regex_search(help, std::regex("--format TEXT:\\{[^}]*json"))) names.insert(name);
  }
  return names;
}

TEST(Json, is_tested_for_every_command_that_prints_it) {
  std::set<std::string> names;
  for (const Reports& reports : all_reports()) names.insert(reports.command);
  EXPECT_EQ(names, commands_with_json());
}

void expect_every_key_on_the_page() {
  auto words = documented();
  std::size_t keys = 0;
  for (const Reports& reports : all_reports()) {
    ASSERT_TRUE(words.contains(reports.command)) << reports.command << " has no section";
    std::set<std::string> printed_keys;
    for (const json& report : printed(reports)) {
      walk(report, [&](const json& object) {
        for (const auto& [key, value] : object.items()) printed_keys.insert(key);
      });
    }
    for (const std::string& key : printed_keys) {
      EXPECT_TRUE(has(words[""] + words[reports.command], words_of(key)))
          << reports.command << " prints an undocumented \"" << key << "\"";
    }
    keys += printed_keys.size();
  }
  EXPECT_GE(keys, 200u);
}

TEST(Json, is_documented_with_the_resolution_of_its_quantiles) {
  const std::string within = "2^-" + std::to_string(properties::kSketchBits - 1);
  EXPECT_EQ(properties::kSketchResolution, std::ldexp(1, 1 - properties::kSketchBits));
  for (const char* page : {"/docs/json.md", "/docs/problem.md"}) {
    const std::string text = contents(RAYCHECK_SOURCE_DIR + std::string(page));
    EXPECT_TRUE(has(text, within)) << page;
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

std::uint64_t sum(const json& counts) {
  std::uint64_t total = 0;
  for (const json& count : counts) total += count.get<std::uint64_t>();
  return total;
}

void expect_the_parts_of_a_tally_to_add_up(const json& tally, const std::string& where) {
  const auto number = [&](const char* key) { return tally[key].get<std::uint64_t>(); };
  EXPECT_EQ(tally["wrong_by_kind"].size(), 7u) << where;
  EXPECT_EQ(sum(tally["wrong_by_kind"]), tally["wrong"]) << where;
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
  }
}

void expect_the_same_tally_everywhere() {
  std::map<std::string, std::set<std::set<std::string>>> keys;  // of tallies, by command
  std::size_t tallies = 0, wrong = 0, weighed = 0;
  for (const Reports& reports : all_reports()) {
    for (const json& report : printed(reports)) {
      walk(report, [&](const json& tally) {
        if (!tally.contains("wrong_by_kind")) return;
        expect_the_parts_of_a_tally_to_add_up(tally, reports.command + ": " + tally.dump());
        std::set<std::string> all;
        for (const auto& [key, value] : tally.items()) all.insert(key);
        keys[reports.command].insert(all);
        weighed += !tally["outcomes"].is_null() && tally["measured"] > 0 ? 1 : 0;
        wrong += tally["wrong"] > 0 ? 1 : 0;
        ++tallies;
      });
    }
  }
  EXPECT_GE(tallies, 100u);
  EXPECT_GE(wrong, 5u);
  EXPECT_GE(weighed, 20u);
  for (const char* command : {"check", "properties", "stress", "tradeoff"}) {
    EXPECT_EQ(keys[command].size(), 1u) << command;
    EXPECT_EQ(keys[command], keys["check"]) << command;
  }
}

TEST(Json, of_every_command_matches_its_documentation) {
  expect_every_key_on_the_page();
  expect_reports_begin_alike();
  expect_the_same_tally_everywhere();
}

TEST(Json, names_the_change_that_excused_an_answer) {
  for (const auto& [asked, kind, amount] :
       {std::tuple("tangent-and-neighbours.toml --intersect quadratic", "witness", 0x1p-49),
        {"tangent-and-neighbours.toml --intersect single-quadratic", "witness", 0x1.3cp-17},
        {"probe.toml --t-threshold 0.5 --candidate \"renderer:python3 tests/candidates/rt.py "
         "threshold {scene} {image}\"",
         "threshold", 0.5}}) {
    std::set<double> amounts;
    walk(printed_json("check --top 1000 scene/examples/" + std::string(asked)),
         [&, kind = kind](const json& found) {
           if (!found.contains("excuse") || found["excuse"].is_null()) return;
           const json& excuse = found["excuse"];
           EXPECT_FALSE(excuse.at("sentence").get<std::string>().empty());
           EXPECT_EQ(excuse["kind"] == "witness", !excuse["witness"].is_null());
           for (const json& input : excuse["witness"]) {
             const double share = std::strtod(input["share"].get<std::string>().c_str(), nullptr);
             EXPECT_NE(share, 0);
             EXPECT_LE(std::abs(share), excuse["amount"]);
           }
           if (excuse["kind"] == kind) amounts.insert(excuse["amount"].get<double>());
         });
    ASSERT_EQ(amounts.size(), 1u) << asked;
    EXPECT_NEAR(*amounts.begin(), amount, 0x1p-40 * amount) << asked;
  }
}

TEST(HostileCsv, escapes_formulas_of_spreadsheets) {
  for (const auto& [text, cell] : {
           std::pair("=1+1", "\"'=1+1\""),
           {"+cmd|' /C calc'!A0", "\"'+cmd|' /C calc'!A0\""},
           {"-2+3", "\"'-2+3\""},
           {"@SUM(A1)", "\"'@SUM(A1)\""},
           {"\t=1", "\"'\t=1\""},
           {"\r=1", "\"'\\x0d=1\""},
           {"\n=1", "\"'\n=1\""},
           {"\uFF1D1", "\"'\uFF1D1\""},
           // Characters that would end a cell.
           {"a,b", "\"a,b\""},
           {"a;b", "\"a;b\""},
           {"a\"b", "\"a\"\"b\""},
           {" a", "\" a\""},
           {"\x1b\xff", "\\x1b\uFFFD"},
       }) {
    EXPECT_EQ(tools::csv_cell(text), cell);
  }
  // Numbers and plain text are as they were.
  for (const char* cell :
       {"", "-", "-1.5", "+2", "1e-300", "-0x1p3", "-inf", "ada", "a b", "<1e-9"}) {
    EXPECT_EQ(tools::csv_cell(cell), cell);
  }
}

TEST(HostileJson, accepts_any_bytes) {
  const std::string bytes = "a\xff\x1b\x7f\u009b\u202e\\x7f\"z";
  const std::string text = tools::json_text({{"key", bytes}});
  EXPECT_EQ(text, "{\n  \"key\": \"a\uFFFD\\u001b\\u007f\\u009b\\u202e\\\\x7f\\\"z\"\n}\n");
  EXPECT_EQ(tools::Json::parse(text)["key"], "a\uFFFD\x1b\x7f\u009b\u202e\\x7f\"z");
  EXPECT_EQ(tools::json_line(tools::Json::array({1, "\xff"})), "[1,\"\uFFFD\"]\n");
}

}  // namespace
}  // namespace raycheck::tests
