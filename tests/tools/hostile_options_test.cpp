// Every option of every command takes what it allows, and says of all else what that is.

#include <gtest/gtest.h>

#include <CLI/CLI.hpp>
#include <map>
#include <string>
#include <vector>

#include "tests/tools/program.h"
#include "tools/all_commands.h"
#include "tools/command_line.h"

namespace raycheck::tests {
namespace {

/// The program's commands, not run.
struct Program {
  CLI::App app;
  std::vector<tools::Command> commands = tools::make_program(app, tools::kAllCommands);
};

bool takes_a_number(const CLI::Option& option) {
  const std::string type = option.get_type_name();
  return type.find("INT") != std::string::npos || type.find("FLOAT") != std::string::npos;
}

/// What an option says of a value; empty where it takes it.
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

TEST(HostileOptions, of_numbers_take_numbers_alone) {
  Program program;
  int numbers = 0;
  for (const tools::Command& command : program.commands) {
    for (CLI::Option* const option : command.app->get_options()) {
      if (!takes_a_number(*option)) continue;
      ++numbers;
      for (const std::string value :
           {"-1", "-0.5", "18446744073709551616", "1e300000", "nan", "-nan", "inf", "-inf", "", " ",
            "all", "1,all", "1x", "0x", "1 2", "1\x1b", "\xff", "--1"}) {
        // The largest integers are whole numbers like others where errors are bounded.
        if (value == "18446744073709551616" && option->get_type_name().find("FLOAT") == 0 &&
            refusal(*option, "1e300").empty()) {
          continue;
        }
        const std::string said = refusal(*option, value);
        const std::string where = command.app->get_name() + " " + option->get_name();
        EXPECT_NE(said.find(option->get_name()), std::string::npos) << where << ": " << value;
        EXPECT_NE(said.find("give a "), std::string::npos) << where << ": " << value << said;
        EXPECT_NE(said.find("'" + value + "'"), std::string::npos) << where << ": " << said;
      }
      EXPECT_EQ(refusal(*option, "1"), "") << command.app->get_name() << option->get_name();
    }
  }
  EXPECT_GE(numbers, 25);
}

void refused(const std::string& arguments, const std::string& why) {
  const Outcome outcome = run(arguments + " </dev/null");
  EXPECT_EQ(outcome.exit_code, 2) << arguments << "\n" << outcome.out;
  EXPECT_NE(outcome.err.find(why), std::string::npos) << arguments << "\n" << outcome.err;
  EXPECT_EQ(outcome.out, "") << arguments;
}

TEST(HostileOptions, of_whole_numbers_take_no_octal_digits) {
  refused("generate --family rays --cases 010",
          "--cases: give a whole number from 1 to 1000000000, not '010'");
  refused("generate --family rays --cases 0x10", "not '0x10'");
}

const std::string kTenSpheres = "scene/examples/ten-spheres.toml";
const std::string kOfGivenRays = " scene/examples/lecture-examples.toml";

TEST(HostileOptions, without_a_value_are_refused) {
  const std::string without = " is given without a value; give one, or leave the option out";
  refused("properties --cases 5 --replay ''", "--replay:" + without);
  refused("properties --cases 5 --filter ''", "--filter:" + without);
  refused("check ''", "SCENE:" + without);
  refused("check" + kOfGivenRays + " --rays ''", "--rays:" + without);
  refused("check" + kOfGivenRays + " --candidate ''", "--candidate:" + without);
  refused("grade lecture7.toml --out ''", "--out:" + without);
  refused("rubric ''", "NAME:" + without);
}

/// What commands need to come to what an option says.
const std::map<std::string, std::string> kNeeded = {
    {"check", kTenSpheres},
    {"explain", kTenSpheres + " --pixel 3,3"},
    {"generate", "--family rays"},
    {"grade", "lecture7.toml"},
    {"image", kTenSpheres + " --what error --out /proc/x.png"},
    {"list", ""},
    {"plan", kTenSpheres},
    {"properties", "--cases 1"},
    {"rubric", "lecture7.toml"},
    {"stress", "--cases 1"},
    {"tradeoff", "--family distance --cases 1"},
    {"try", "lecture7.toml README.md"},
    {"verify", "--family rays"},
    {"view", kTenSpheres + " --format json"},
    {"worst", "--method intersect/cross --family rays --cases 1 --steps 1"}};

/// The arguments without an option and its value.
std::string without(const std::string& option, std::string arguments) {
  const std::size_t at = arguments.find(option + " ");
  if (at == std::string::npos) return arguments;
  return arguments.erase(at, arguments.find(' ', at + option.size() + 1) - at);
}

/// A name of nothing, and a file that nobody can write.
TEST(HostileOptions, are_called_in_errors_as_they_are_given) {
  Program program;
  int texts = 0;
  for (const tools::Command& command : program.commands) {
    for (const CLI::Option* const option : command.app->get_options()) {
      const std::string name = option->get_name();
      if (option->get_items_expected_max() == 0 || option->get_positional() ||
          takes_a_number(*option) || name == "--picture-link") {  // any text
        continue;
      }
      ++texts;
      std::string needed = without(name, kNeeded.at(command.app->get_name()));
      for (const CLI::Option* const with : option->get_needs()) {
        if (with->get_name() != "--candidate") continue;
        needed = without("--method", needed) +
                 " --candidate 'command:python3 tests/candidates/right.py'";
      }
      refused(command.app->get_name() + " " + needed + " " + name + " '/proc/x y'", name);
    }
  }
  EXPECT_GE(texts, 60);
}

TEST(HostileOptions, that_nothing_uses_are_refused) {
  for (const char* option :
       {"--timeout 1", "--bounds cross", "--image-change 0", "--t-threshold 0", "--sandbox none"}) {
    const std::string name = std::string(option).substr(0, std::string(option).find(' '));
    refused("check" + kOfGivenRays + " " + option, name + " requires --candidate");
    refused(std::string("properties ") + option, name + " requires --candidate");
  }
  refused("grade lecture7.toml --secret-file README.md",
          "--secret-file README.md: is for submissions, and none are given");
  refused("grade lecture7.toml --out nowhere", "--out nowhere: is for submissions");
  refused("grade lecture7.toml --against nowhere", "--against nowhere: is for submissions");
  refused("grade lecture7.toml --probe README.md --secret-file x", "--secret-file x: --probe");
}

TEST(HostileOptions, of_methods_take_all_alone) {
  const std::string why = "--method all: is every method; leave out the others";
  refused("stress --family distance --cases 1 --method distance,all", why);
  refused("tradeoff --cases 1 --method all,cross", why);
}

TEST(HostileOptions, of_severities_stay_in_the_range_of_a_family) {
  const std::string family = "stress --method cross --cases 1 --family distance --severity ";
  refused(family + "1..2147483647", "--severity 1..2147483647: the severities of distance are 0..");
  refused(family + "9999", "--severity 9999..9999: the severities of distance are 0..");
  refused(family + "4294967296", "--severity 4294967296: give a whole number from 0 to 2147483647");
  refused(family + "-1", "--severity -1: give a whole number from 0");
}

TEST(HostileOptions, of_pixels_and_sizes_say_what_there_is) {
  refused("explain scene/examples/probe.toml --pixel 40,3",
          "--pixel 40,3: scene/examples/probe.toml has 40 x 26 pixels; give a column up to 39 and "
          "a row up to 25");
  refused("explain scene/examples/probe.toml --pixel 3,26", "--pixel 3,26: ");
  const std::string out = temporary_file("picture.png", "");
  refused("image scene/examples/probe.toml --out '" + out + "' --size 1000001,3",
          "--size 1000001,3: side 1000001: give a whole number from 1 to 1000000");
  const std::string wide =
      temporary_file("wide.txt", "camera 0 0 10 0 0 0 0 1 0 -5\nbounds -1 1 -1 1\nres 2000000 4\n");
  refused("image '" + wide + "' --out '" + out + "'",
          wide + ": camera.width = 2000000: is more than a picture takes, which is 1000000 pixels");
}

TEST(HostileOptions, of_files_are_tried_before_the_work) {
  const std::string cases = " --family rays --cases 1000000000 ";
  refused("worst --method cross" + cases + "--save /proc/x.toml",
          "--save /proc/x.toml: cannot be written");
  refused("stress --family distance --method cross --cases 1000000000 --plot /proc/x.svg",
          "--plot /proc/x.svg: cannot be written");
  refused("tradeoff --cases 1000000000 --plot /proc/x.svg",
          "--plot /proc/x.svg: cannot be written");
}

}  // namespace
}  // namespace raycheck::tests
