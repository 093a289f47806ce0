// Every option of every command accepts valid values, and refuses all others with a clear message.

#include <CLI/CLI.hpp>
#include <cstdio>
#include <iomanip>

#include "tests/tools/program.h"
#include "tools/commands.h"

namespace raycheck::tests {
namespace {

/// The commands of all programs.
constexpr tools::LinkedCommand kAllCommands[] = {
#define RAYCHECK_LINKED(name, program, sentence) {#name, tools::add_##name},
    RAYCHECK_COMMANDS(RAYCHECK_LINKED)
#undef RAYCHECK_LINKED
};

/// The commands of the program, without running them.
struct Program {
  CLI::App app;
  std::vector<tools::Command> commands = tools::make_program(app, kAllCommands);
};

bool takes_a_number(const CLI::Option& option) {
  const std::string type = option.get_type_name();
  return type.find("INT") != std::string::npos || type.find("FLOAT") != std::string::npos;
}

/// Like expect_refused(), for a line whose words may be in single quotes. Commands that need
/// neither a candidate nor files beside the program run in a fork of this process, which is faster.
void expect_refused_here(const std::string& line, const std::string& why) {
  const std::string command = line.substr(0, line.find(' '));
  const bool needs_files_beside_it = command == "grade" || command == "merge" || command == "try";
  if (needs_files_beside_it || has(line, "--candidate")) return expect_refused(line, why);
  std::vector<std::string> words = {"raycheck"};
  std::istringstream in(line);
  for (std::string word; in >> std::quoted(word, '\'');) words.push_back(word);
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  const std::string out = temporary_file("here.out", ""), err = temporary_file("here.err", "");
  const pid_t child = fork();
  if (child == 0) {
    const bool is_ready = std::freopen("/dev/null", "r", stdin) != nullptr &&
                          std::freopen(out.c_str(), "w", stdout) != nullptr &&
                          std::freopen(err.c_str(), "w", stderr) != nullptr &&
                          chdir(RAYCHECK_SOURCE_DIR) == 0;
    const int code = is_ready ? tools::run_command_line(static_cast<int>(arguments.size()),
                                                        arguments.data(), kAllCommands)
                              : 127;
    std::fflush(nullptr);
    _exit(code);
  }
  int status = 0;
  waitpid(child, &status, 0);
  EXPECT_EQ(WIFEXITED(status) ? WEXITSTATUS(status) : -1, 2) << line;
  EXPECT_TRUE(has(contents(err), why)) << line;
  EXPECT_EQ(contents(out), "") << line;
}

/// The message with which an option refuses a value; empty if it accepts the value.
std::string refusal(CLI::Option& option, const std::string& value) {
  option.clear();
  try {
    option.add_result(value);
    option.run_callback();
  } catch (const CLI::Error& error) {
    return error.what();
  }
  return "";
}

TEST(HostileOptions, of_numbers_accept_only_numbers) {
  Program program;
  int numbers = 0;
  for (const tools::Command& command : program.commands) {
    for (CLI::Option* const option : command.app->get_options()) {
      if (!takes_a_number(*option)) continue;
      ++numbers;
      for (const std::string value :
           {"-1", "-0.5", "18446744073709551616", "1e300000", "nan", "-nan", "inf", "-inf", "", " ",
            "all", "1,all", "1x", "0x", "1 2", "1\x1b", "\xff", "--1"}) {
        // Bounds on errors accept the largest integers, too.
        if (value == "18446744073709551616" && option->get_type_name().find("FLOAT") == 0 &&
            refusal(*option, "1e300").empty()) {
          continue;
        }
        const std::string said = refusal(*option, value);
        const std::string where = command.app->get_name() + " " + option->get_name();
        EXPECT_TRUE(has(said, option->get_name())) << where << ": " << value;
        EXPECT_TRUE(has(said, "give a ")) << where << ": " << value;
        EXPECT_TRUE(has(said, "'" + value + "'")) << where << ": ";
      }
      EXPECT_EQ(refusal(*option, "1"), "") << command.app->get_name() << option->get_name();
    }
  }
  EXPECT_GE(numbers, 25);
}

const std::string kTenSpheres = "scene/examples/ten-spheres.toml";
const std::string kOfGivenRays = " scene/examples/lecture-examples.toml";

/// The arguments without which a command does not check its options.
const std::map<std::string, std::string> kNeeded = {
    {"check", kTenSpheres},
    {"explain", kTenSpheres + " --pixel 3,3"},
    {"grade", "lecture7.toml"},
    {"image", kTenSpheres + " --what error --out /proc/x.png"},
    {"list", ""},
    {"new", "mine"},
    {"plan", kTenSpheres},
    {"properties", "--cases 1"},
    {"rubric", "lecture7.toml"},
    {"stress", "--cases 1"},
    {"tradeoff", "--family distance --cases 1"},
    {"try", "lecture7.toml README.md"},
    {"view", kTenSpheres + " --format json"},
    {"worst", "--method intersect/cross --family rays --cases 1 --steps 1"}};

/// The arguments without an option and its value.
std::string without(const std::string& option, std::string arguments) {
  const std::size_t at = arguments.find(option + " ");
  if (at == std::string::npos) return arguments;
  return arguments.erase(at, arguments.find(' ', at + option.size() + 1) - at);
}

/// A name that does not exist, and a file that cannot be written.
TEST(HostileOptions, have_the_same_names_in_errors_as_on_the_command_line) {
  Program program;
  const std::string units = temporary_folder("options") + "/units";
  run("properties --filter frame --rays direct --cases 1 --out " + units, 0);
  int texts = 0;
  for (const tools::Command& command : program.commands) {
    for (const CLI::Option* const option : command.app->get_options()) {
      const std::string name = option->get_name();
      if (option->get_items_expected_max() == 0 || option->get_positional() ||
          takes_a_number(*option)) {
        continue;
      }
      ++texts;
      std::string needed = command.app->get_name() == "merge"
                               ? units
                               : without(name, kNeeded.at(command.app->get_name()));
      for (const CLI::Option* const with : option->get_needs()) {
        if (with->get_name() != "--candidate") continue;
        needed = without("--method", needed) +
                 " --candidate 'command:python3 tests/candidates/right.py'";
      }
      expect_refused_here(command.app->get_name() + " " + needed + " " + name + " '/proc/x y'",
                          name);
    }
  }
  EXPECT_GE(texts, 60);
}

TEST(HostileOptions, that_are_hidden_are_not_shown_by_help) {
  Program program;
  for (const tools::Command& command : program.commands) {
    const std::string help = command.app->help();
    for (const char* part : {"Excludes: ", "Excludes:\n"}) {
      for (std::size_t at = 0; (at = help.find(part, at)) != std::string::npos; ++at) {
        EXPECT_TRUE(has(help.substr(at, 13), "Excludes: -") ||
                    has(help.substr(at, 13), "Excludes: S"))
            << command.app->get_name() << ": " << help.substr(at, 40);
      }
    }
  }
}

TEST(HostileOptions, that_are_unused_are_refused) {
  for (const char* option : {"--timeout 1", "--read .", "--include .", "--bounds cross",
                             "--image-change 0", "--t-threshold 0", "--sandbox none"}) {
    const std::string name = std::string(option).substr(0, std::string(option).find(' '));
    expect_refused_here("check" + kOfGivenRays + " " + option, name + " requires --candidate");
    expect_refused_here(std::string("properties ") + option, name + " requires --candidate");
  }
}

/// Command lines and their messages. FAR stands for a scene, OUT for an option with a file.
const std::pair<const char*, const char*> kRefused[] = {
    {"", "give a command: check, properties"},
    {"check FAR --topp 3", "--topp: there is no such option; did you mean --top?"},
    {"check FAR --topp=3", "--topp=3: there is no such option; did you mean --top?"},
    {"check FAR --nothing", "--nothing: there is no such option\n"},
    {"check FAR more", "more: is one argument too many"},
    {"check FAR --format xml", "--format xml: give one of text, json"},
    {"check FAR --max-ulp x", "--max-ulp x: give a finite number >= 0"},
    {"check FAR --candidate a:b --read nowhere", "--read nowhere: there is no such folder"},
    {"chekc", "there is no command 'chekc'"},
    // Scenes.
    {"check", "SCENE"},
    {"plan", "SCENE"},
    {"check nowhere.toml", "nowhere.toml"},
    {"image nowhere.toml OUT", "nowhere.toml"},
    {"plan nowhere.toml", "nowhere.toml"},
    {"tradeoff nowhere.toml", "nowhere.toml"},
    {"tradeoff FAR --all-families", "SCENE"},
    {"tradeoff --shard 1/2", "--shard"},
    {"plan FAR --shard 1/2", "--shard"},
    {"view --format json", "give a scene, or --source"},
    {"view FAR --family distance", "give a scene, or --source"},
    {"view --family distance --pixel 1,1 --format json", "--source"},
    {"view FAR", "--out FILE.html"},
    {"image FAR", "--out"},
    {"image FAR --ot OUT", "--ot: there is no such option; did you mean --out?"},
    {"--vrsion", "--vrsion: there is no such option; did you mean --version?"},
    {"image scene/examples/lecture-examples.toml OUT", "has given rays and no camera"},
    {"explain scene/examples/lecture-examples.toml --pixel 0,0", "no camera"},
    // Methods, laws, families, quantities.
    {"check FAR --rays fast", "--rays fast: no such method"},
    {"check FAR --intersect best", "--intersect best: no such method"},
    {"check FAR --all --rays direct", "--all"},
    {"image FAR OUT --rays direct", "--rays direct: only --what error"},
    {"image FAR OUT --intersect cross", "--intersect cross: only --what error"},
    {"stress --method magic", "--method magic: no such method"},
    {"stress --methods magic", "--methods magic: no such method"},
    {"worst --method lecture --family rays", "rays/lecture or intersect/lecture"},
    {"worst --method direct --family rays", "has no camera"},
    {"worst --method cross", "--source"},
    {"worst --method cross --family rays --quantity hue", "quantity hue: no such quantity"},
    {"tradeoff --cases 1 --method all,cross", "--method all: already means every method; leave"},
    {"properties --filter nothing", "filter nothing: no law"},
    {"properties --source moon", "source moon: no source"},
    {"properties --replay class:direct/cross:distance:1 --level extreme", "--level"},
    {"properties --replay class:direct/cross:distance", "LAW:"},
    {"properties --replay klass:direct/cross:distance:1", "klass"},
    {"properties --replay class:direct/none:distance:1", "direct/none"},
    {"stress --family moon", "no such source with severities; there are far-camera"},
    // Severities must be in the range of the source.
    {"properties --source distance@16", "severities of 'distance' are 0 to 15"},
    {"worst --method cross --family distance@77", "0 to 15"},
    {"stress --severity 5..2", "--severity 5..2"},
    {"stress --cases 1 --family distance --severity 9999", "--severity 9999..9999: the severities"},
    {"stress --family distance --severity 4294967296",
     "--severity 4294967296: give a severity, or a range"},
    {"stress --family distance --severity -1", "--severity -1: give a severity, or a range"},
    // Candidates.
    {"worst --family distance", "give --method or --candidate"},
    {"worst --family distance --candidate a:b --candidate c:d", "worst takes only one"},
    {"worst --family distance --method cross --candidate a:b", "excludes"},
    {"stress --family distance --candidate 'renderer:sh {scene} {image}'",
     "it only draws pictures; this command judges single answers"},
    {"image FAR OUT --candidate a:b", "only --what error shows a candidate or method"},
    {"check FAR --candidate mine", "candidate mine: give library:PATH.so, source:PATH, command:"},
    {"check FAR --candidate elsewhere:mine", "candidate elsewhere:mine: unknown kind 'elsewhere'"},
    {"check FAR --candidate library:", "give library:PATH.so"},
    {"check FAR --candidate library:nowhere.so", "there is no such file or folder\n"},
    {"check FAR --candidate library:README.md", "README.md"},
    {"check FAR --candidate library:tests",
     "--candidate library:tests: it is not a file; give a shared library"},
    {"check FAR --candidate source:nowhere.cpp", "there is no such file or folder\n"},
    {"check FAR --candidate source:docs", "it contains no .cpp file"},
    {"check FAR --candidate 'command:nosuchprogram --fast'",
     "there is no program 'nosuchprogram' in /usr/local/bin:/usr/bin:/bin"},
    {"check FAR --candidate command:./nosuchprogram", "there is no program './nosuchprogram'"},
    {"check FAR --candidate 'renderer:nosuchprogram {scene} {image}'",
     "there is no program 'nosuchprogram'"},
    {"check FAR --candidate 'renderer:./rt {image}'", "{scene} is missing"},
    {"check FAR --candidate command:true",
     "it exited with 0 before it printed 'raycheck 1 NAME'; a program that uses "
     "raycheck_candidate must end with a call of run()"},
    {"check FAR --candidate 'command:echo hello'",
     "its first line is 'hello', not 'raycheck 1 NAME'; print only replies to standard output"},
    {"check FAR --candidate 'command:python3 tests/candidates/hostile.py early'",
     "wrote more after its reply"},
    // Rubrics and submissions.
    {"grade", "RUBRIC"},
    {"grade nowhere.toml README.md --out nowhere", "nowhere.toml: there is no such rubric"},
    {"grade lecture7.toml README.md", "--out: give a folder for the results"},
    {"grade lecture7.toml nowhere", "nowhere: there is no such file or folder"},
    {"grade lecture7.toml nowhere --out nowhere", "nowhere: there is no such file or folder"},
    {"grade lecture7.toml README.md README.md --out nowhere", "README.md: is given twice"},
    {"grade lecture7.toml README.md --package x.png", "SUBMISSION excludes --package"},
    {"grade lecture7.toml README.md --out nowhere --secret-file no", "--secret-file no: cannot be"},
    {"grade lecture7.toml --package nowhere/a.zip", "package nowhere/a.zip: "},
    {"grade lecture7.toml README.md --out nowhere --jobs 0", "--jobs"},
    {"grade lecture7.toml --secret-file README.md", "--secret-file requires SUBMISSION"},
    {"grade lecture7.toml --out nowhere", "--out requires SUBMISSION"},
    {"grade lecture7.toml --probe README.md --secret-file x", "--probe excludes --secret-file"},
    {"grade lecture7.toml --probe", "--probe requires SUBMISSION"},
    {"grade lecture7.toml README.md --probe --format csv", "--format csv"},
    {"grade lecture7.toml README.md --probe --dialect D", "dialect D"},
    {"try lecture7.toml", "SUBMISSION"},
    {"try nowhere.toml README.md",
     "nowhere.toml: there is no such rubric; raycheck comes with lecture7.toml"},
    {"try lecture7.toml nowhere", "nowhere: there is no such file or folder"},
    {"rubric lecture8", "lecture8: there is no such rubric; raycheck comes with lecture7.toml"},
    {"rubric lecture7/frame", "lecture7/frame: there is no such rubric"},
    {"rubric --out somewhere", "--out requires NAME"},
    // Numbers; octal digits are not accepted.
    {"properties --cases 010", "--cases 010: give a whole number from 1 to 1000000000"},
    {"properties --cases 0x10", "--cases 0x10: give a whole number"},
    {"properties --cases 0", "--cases"},
    {"check FAR --pixels 0", "--pixels 0"},
    {"check FAR --pixels some", "--pixels some"},
    {"check FAR --threads 0", "--threads"},
    {"check FAR --top 5000", "--top"},
    // Pixels and sizes: messages give the range.
    {"explain FAR --pixel 16,3", "has 16 x 16 pixels; give a column up to 15 and a row up to 15"},
    {"explain FAR --pixel 0,0 --sphere 9", "the scene has only sphere 0"},
    {"view FAR --format json --pixel 16,0", "pixel"},
    {"view FAR --format json --pixel 1,0 --sphere 1", "sphere 1"},
    {"view FAR --format json --sphere 0", "--sphere: also give --pixel"},
    {"image FAR OUT --size 5", "--size 5"},
    {"image FAR OUT --size 5,0", "--size"},
    {"image FAR OUT --size 1,5", "camera.width"},
    {"image FAR OUT --size 1000001,3", "side 1000001: give a whole number from 1 to 1000000"},
    {"image FAR OUT --size 5,1000001", "--size 5,1000001: side 1000001: give"},
    // Rays and spheres.
    {"explain", "--pixel"},
    {"explain --ray 1,2,3", "--sphere"},
    {"explain --ray 1,2,3 --sphere 0,0,0,1", "6 numbers"},
    {"explain --ray 1,2,3,4,5,x --sphere 0,0,0,1", "'x' is not a number"},
    {"explain --ray 0,0,0,0,0,0 --sphere 0,0,0,1", "direction"},
    {"explain --ray 0,0,0,1,0,0 --sphere 0,0,0,-1", "radius"},
    {"explain --ray 0,0,0,1,0,inf --sphere 0,0,0,1", "direction"},
    // Files.
    {"tradeoff --view nowhere/page.html", "nowhere/page.html"},
    {"stress --view /proc/none/page.html", "/proc/none/page.html"},
    {"view FAR --out FAR", "--out"},
    {"image FAR --out x.gif", "the name of a picture must end in .png or .ppm"},
    {"image FAR --out nowhere/a.png", "--out nowhere/a.png: cannot be written"},
    {"image FAR --out scene/examples", "--out scene/examples: cannot be written"},
    {"check FAR --certificates nowhere/x", "--certificates nowhere/x: cannot be written"},
    {"check FAR --certificates scene", "the path exists and is not a regular file"},
    {"check nowhere.toml --certificates x.png", "nowhere.toml"},
    // Files are opened before the work.
    {"worst --method cross --family rays --cases 1000000000 --save /proc/x.toml",
     "--save /proc/x.toml: cannot be written"},
    {"stress --family distance --method cross --cases 1000000000 --view /proc/x.html",
     "--view /proc/x.html: cannot be written"},
    {"tradeoff --cases 1000000000 --view /proc/x.html", "--view /proc/x.html: cannot be written"},
    // Empty values, as from unset variables of scripts.
    {"check ''", "SCENE: the value is empty; give one, or leave the option out"},
    {"rubric ''", "NAME: the value is empty"},
    {"properties --cases 5 --replay ''", "--replay: the value is empty"},
    {"properties --cases 5 --filter ''", "--filter: the value is empty"},
    {"check FAR --rays ''", "--rays: the value is empty"},
    {"check FAR --candidate ''", "--candidate: the value is empty"},
    {"check FAR --certificates ''", "--certificates: the value is empty"},
    {"image FAR --out ''", "--out: the value is empty"},
    {"grade lecture7.toml --out ''", "--out: the value is empty"}};

TEST(HostileOptions, that_name_missing_things_are_refused_with_the_reason) {
  for (const auto& [line, why] : kRefused) {
    const std::string in_place = std::regex_replace(line, std::regex("OUT"), "--out x.png");
    expect_refused_here(
        std::regex_replace(in_place, std::regex("FAR"), "scene/examples/far-sphere.toml"), why);
  }
  const std::string flat =
      temporary_file("flat.toml", replaced(camera_text(2, 2), "up = [0, 1, 0]", "up = [0, 0, 1]"));
  expect_refused_here("check " + flat, flat + ":4: camera.up");
  const std::string wide =
      temporary_file("wide.txt", "camera 0 0 10 0 0 0 0 1 0 -5\nbounds -1 1 -1 1\nres 2000000 4\n");
  expect_refused_here("image '" + wide + "' --out x.png",
                      wide + ": camera.width = 2000000: exceeds the limit of 1000000 pixels");
  for (const char* left : {"/nowhere", "/x.png", "/x.gif"}) {
    EXPECT_FALSE(fs::exists(RAYCHECK_SOURCE_DIR + std::string(left))) << left;
  }
}

}  // namespace
}  // namespace raycheck::tests
