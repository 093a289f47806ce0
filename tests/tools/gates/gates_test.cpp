// Formats for continuous integration (JUnit, Markdown, GitHub's commands, GitLab's code quality),
// and the example files for pipelines, whose commands run unchanged.

#include "tests/tools/program.h"
#include "tools/gates/gate.h"

namespace raycheck::tests {
namespace {

using tools::Gate;
using tools::GateCheck;
using tools::GateOutcome;

/// Output of a candidate that tries to break a file or to inject a command.
const std::string kHostile =
    "]]></failure></testcase><testcase name=\"x\"/>&amp;\n::error::mine\n  ::warning::mine\n"
    "##[error]mine\n```\n</details><script>\n| a | b |\n\x1b[31m\x01\xff \uFFFE %0A::error::mine\n";

Gate gate_of(std::size_t failures, const std::string& text, const std::string& candidate) {
  Gate gate;
  gate.command = "properties";
  gate.about = text;
  for (std::size_t k = 0; k < failures; ++k) {
    const tools::Identity one = {"class", "rays", "class: missed", std::to_string(k), candidate};
    gate.checks.push_back(
        {candidate, "class/" + std::to_string(k), GateOutcome::kFailed, text, text, {one}});
  }
  gate.checks.push_back({candidate, "root/rays", GateOutcome::kPassed, {}, {}, {}});
  gate.checks.push_back({candidate, "hit-point/rays", GateOutcome::kLeftOut, text, {}, {}});
  gate.checks.push_back({candidate, "parameter/rays", GateOutcome::kInconclusive, text, {}, {}});
  tools::complete(gate, false);
  return gate;
}

std::string written(std::string_view format, const Gate& gate) {
  for (const tools::GateFormat& one : tools::gate_formats()) {
    if (one.name == format) return one.write(gate);
  }
  return {};
}

/// The counts of a JUnit file, read by Python's XML parser: tests, failures, errors, skipped.
std::string read_by_python(const std::string& path) {
  const std::string script = temporary_file("junit.py",
                                            "import sys, xml.etree.ElementTree as tree\n"
                                            "root = tree.parse(sys.argv[1]).getroot()\n"
                                            "count = lambda kind: len(list(root.iter(kind)))\n"
                                            "print(*map(count, ('testcase', 'failure', 'error', "
                                            "'skipped')))\n");
  const Outcome read = run_python(script + " " + path);
  return read.exit_code == 0 ? read.out : read.err;
}

/// Whether a file is valid by junit.xsd. If xmllint is not installed, prints a message and returns
/// true.
bool suits_schema(const std::string& path) {
  if (!is_installed("xmllint")) {
    std::printf("xmllint is not installed: the schema is not tried\n");
    return true;
  }
  const std::string schema = RAYCHECK_SOURCE_DIR "/tests/tools/gates/junit.xsd";
  return std::system(("xmllint --noout --huge --schema " + schema + " " + path).c_str()) == 0;
}

/// Lines that the log of a GitHub workflow executes.
std::size_t commands_in(const std::string& log) {
  std::size_t count = 0;
  for (const std::string& line : lines_of(log)) {
    const std::size_t begin = line.find_first_not_of(" \t");
    const bool obeyed = begin != std::string::npos && line.compare(begin, 2, "::") == 0;
    count += obeyed || line.find("##[") != std::string::npos ? 1 : 0;
  }
  return count;
}

TEST(HostileJunit, HasEachCheckOnceForAnyText) {
  const std::string path =
      temporary_file("hostile.xml", written("junit", gate_of(3, kHostile, kHostile)));
  EXPECT_EQ(read_by_python(path), "6 3 1 1\n");
  EXPECT_TRUE(suits_schema(path));
  EXPECT_FALSE(has(contents(path), "##["));
}

TEST(HostileJunit, OfAHundredThousandFailuresStaysBelowGitLabsLimit) {
  const std::string text = written("junit", gate_of(100'000, std::string(60, '&'), "mine"));
  EXPECT_LT(text.size(), std::size_t{30'000'000});
  EXPECT_GT(text.size(), std::size_t{10'000'000});
  const std::string path = temporary_file("large.xml", text);
  EXPECT_EQ(read_by_python(path), "100003 100000 1 1\n");
}

TEST(HostileMarkdown, StaysBelowGitHubsLimitAndCountsTheRest) {
  const std::string text = written("markdown", gate_of(100'000, "why it failed", "mine"));
  EXPECT_LE(text.size(), tools::kMostMarkdownBytes);
  expect_parts(text, {" more: see the JSON report", "| mine | 1 | 100000 | 0 | 1 | 1 |"});
}

TEST(HostileMarkdown, FencesTextsAndKeepsThemInTheirCells) {
  const std::string text = written("markdown", gate_of(1, kHostile, kHostile));
  EXPECT_TRUE(has(text, "````text\n"));
  std::size_t rows = 0;
  bool inside = false;
  for (const std::string& line : lines_of(text)) {
    if (line.starts_with("````")) inside = !inside;
    if (inside) continue;
    rows += line.starts_with("|") ? 1 : 0;
    EXPECT_FALSE(has(line, "<script>"));
  }
  EXPECT_FALSE(inside);
  EXPECT_EQ(rows, 3u);
}

TEST(HostileAnnotations, AreAtMostTenAndNotInjectedByTexts) {
  for (const std::size_t failures : {1, 9, 10, 100}) {
    const std::string text = written("github", gate_of(failures, kHostile, kHostile));
    EXPECT_EQ(commands_in(text), std::min<std::size_t>(failures + 1, 10)) << text;
  }
}

TEST(GitlabCodequality, HasTheFieldsThatGitLabRequiresForEachNewDefect) {
  Gate gate = gate_of(3, "why", "mine");
  gate.sources = {{"mine", "src/tracer.cpp"}};
  gate.ratchet.emplace();
  gate.ratchet->known = gate.checks[1].defects;
  const json list = json::parse(written("gitlab-codequality", gate));
  ASSERT_EQ(list.size(), 2u);
  std::set<std::string> fingerprints;
  for (const json& one : list) {
    EXPECT_FALSE(one.at("description").get<std::string>().empty());
    expect_values(one, {{"check_name", "raycheck/class"},
                        {"severity", "major"},
                        {"location/path", "src/tracer.cpp"},
                        {"location/lines/begin", 1}});
    fingerprints.insert(one.at("fingerprint"));
  }
  EXPECT_EQ(fingerprints.size(), 2u);
}

TEST(Annotations, PointToTheLineOfTheCrashOrElseToTheSource) {
  Gate gate = gate_of(2, "why", "mine");
  EXPECT_TRUE(has(written("github", gate), "::error title="));
  gate.sources = {{"mine", "src/tracer.cpp"}};
  gate.checks[1].line = {"src/sphere.h", 42};
  const std::string text = written("github", gate);
  expect_parts(text, {"::error file=src/tracer.cpp,line=1,title=raycheck%3A class/0::",
                      "::error file=src/sphere.h,line=42,title=raycheck%3A class/1::"});
  const json location = json::parse(written("gitlab-codequality", gate))[1]["location"];
  EXPECT_EQ(location, (json{{"path", "src/sphere.h"}, {"lines", {{"begin", 42}}}}));
}

TEST(GateOfARun, WritesEveryReportBesidesThePrintedOne) {
  const std::string folder = temporary_folder("gate");
  const auto file = [&](const std::string& name) { return folder + "/" + name; };
  std::string options = " --cases 60 --source rays";
  for (const char* kind : {"json", "junit", "markdown", "github", "gitlab-codequality", "text"}) {
    options += std::string(" --report ") + kind + "=" + file(kind);
  }
  const Outcome outcome =
      run("properties --candidate library:" + built_submission("rays.cpp", "far_root", folder) +
              options,
          1);
  EXPECT_EQ(outcome.out, contents(file("text")));
  const json report = json::parse(contents(file("json")));
  std::size_t broken = 0;
  const std::string junit = contents(file("junit"));
  for (const json& campaign : report["campaigns"]) {
    if (campaign["finding"] != "broken") continue;
    ++broken;
    const std::string name = campaign["law"].get<std::string>() + "/rays";
    EXPECT_TRUE(has(junit, "name=\"" + name + "\">\n      <failure")) << name;
    EXPECT_TRUE(has(contents(file("markdown")), campaign["law"].get<std::string>()));
  }
  EXPECT_GT(broken, 0u);
  EXPECT_TRUE(has(junit, "failures=\"" + std::to_string(broken) + "\""));
  EXPECT_TRUE(suits_schema(file("junit")));
  EXPECT_TRUE(has(junit, "replay: raycheck properties --candidate"));
  EXPECT_EQ(commands_in(contents(file("github"))), std::min<std::size_t>(broken, 10));
  EXPECT_GE(json::parse(contents(file("gitlab-codequality"))).size(), broken);
}

TEST(HostileLog, OfGitHubExecutesNoCommandsOfCandidates) {
  const std::string program =
      temporary_file("prints.py",
                     "import raycheck_candidate as rc\n"
                     "def intersect(ray, sphere, conventions):\n"
                     "    raise ValueError('::error::mine\\n::warning::mine ##[error]mine')\n"
                     "rc.run('mine', intersect=intersect)\n");
  const std::string arguments =
      "check scene/examples/lecture-examples.toml --candidate 'command:python3 " + program + "'";
  setenv("GITHUB_ACTIONS", "true", 1);
  const Outcome text = run(arguments);
  const Outcome as_json = run(arguments + " --format json");
  const Outcome annotated = run(arguments + " --format github");
  unsetenv("GITHUB_ACTIONS");
  EXPECT_EQ(text.exit_code, 1);
  EXPECT_TRUE(has(text.out, "mine"));
  EXPECT_EQ(commands_in(text.out + text.err), 0u) << text.out;
  EXPECT_EQ(commands_in(as_json.out), 0u);
  EXPECT_TRUE(json::accept(as_json.out));
  const std::size_t annotations = commands_in(annotated.out);
  EXPECT_GT(annotations, 0u);
  for (const std::string& line : lines_of(annotated.out)) {
    EXPECT_TRUE(!line.starts_with("::") || line.starts_with("::error ")) << line;
  }
}

/// The raycheck commands in a file: lines that begin with "raycheck" after removal of the markup.
std::vector<std::string> commands_of(const std::string& file) {
  static const std::regex command(" *(?:- |entry: |run: )*(raycheck prope.*)");
  std::vector<std::string> commands;
  for (const std::string& line : lines_of(contents(RAYCHECK_SOURCE_DIR "/" + file))) {
    std::smatch found;
    if (std::regex_match(line, found, command)) commands.push_back(found[1]);
  }
  return commands;
}

class LongReadyFile : public testing::TestWithParam<const char*> {};

TEST_P(LongReadyFile, PassesACorrectProjectAndFailsAWrongOne) {
  const auto commands = commands_of(GetParam());
  ASSERT_EQ(commands.size(), 1u);
  const fs::path folder = temporary_folder("ready");
  fs::create_directory(folder / "src");
  std::ofstream(folder / "raycheck.baseline").flush();
  for (const char* name : {"none", "far_root"}) {
    const std::string built = built_submission("rays.cpp", name, folder / "src");
    // The hook takes its candidate as an argument, the others from the environment.
    const bool is_hook = std::string(GetParam()).ends_with("hooks.yaml");
    run_bash("set -e\ncd " + folder.string() + "\nmkdir -p raycheck-reports\nPATH=" +
                 fs::path(RAYCHECK_BINARY).parent_path().string() +
                 ":$PATH\nexport CANDIDATE=library:" + built +
                 " BASELINE=raycheck.baseline CASES=300 GITHUB_STEP_SUMMARY=summary.md\n" +
                 commands.front() + (is_hook ? " --candidate \"$CANDIDATE\"" : "") + "\n",
             std::string(name) == "none" ? 0 : 1);
  }
  const bool is_github = std::string(GetParam()).find("github/") != std::string::npos;
  EXPECT_EQ(fs::exists(folder / "summary.md"), is_github);
}

INSTANTIATE_TEST_SUITE_P(Files, LongReadyFile,
                         testing::Values("examples/ci/github/workflow.yml",
                                         "examples/ci/github/action.yml",
                                         "examples/ci/gitlab/raycheck.gitlab-ci.yml",
                                         ".pre-commit-hooks.yaml"));

TEST(ReadyFiles, NameTheirIsolation) {
  for (const char* file : {"examples/ci/github/workflow.yml", "examples/ci/github/action.yml",
                           "examples/ci/gitlab/raycheck.gitlab-ci.yml",
                           "examples/ci/container/Containerfile", ".pre-commit-hooks.yaml"}) {
    const std::string text = contents(RAYCHECK_SOURCE_DIR "/" + std::string(file));
    EXPECT_TRUE(has(text, "solation")) << file;
  }
  const std::string container =
      contents(RAYCHECK_SOURCE_DIR "/examples/ci/container/Containerfile");
  EXPECT_TRUE(has(container, "\nUSER raycheck\n"));
}

}  // namespace
}  // namespace raycheck::tests
