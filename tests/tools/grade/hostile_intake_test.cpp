// What is handed in is looked through without calling oneself for each letter of it.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "tests/tools/program.h"

namespace raycheck::tests {
namespace {

constexpr std::size_t kMany = 200000;

std::string repeated(const std::string& text) {
  std::string all;
  for (std::size_t k = 0; k < kMany; ++k) all += text;
  return all;
}

/// A file alone is tried: it is no submission, and that is said.
void expect_tried(const std::string& name, const std::string& text) {
  const std::string folder = temporary_file("handed-in", "") + ".d";
  std::filesystem::create_directories(folder);
  std::ofstream(folder + "/" + name, std::ios::binary) << text;
  const Outcome outcome = run("grade lecture7.toml --probe --sandbox available '" + folder + "'");
  EXPECT_EQ(outcome.exit_code, 1) << name << outcome.err;
  expect_parts(outcome.out, {"1 submission tried, 1 could not be judged"});
  std::filesystem::remove_all(folder);
}

TEST(HostileIntake, is_not_ended_by_what_is_nested_deeply) {
  expect_tried("a.ipynb", R"({"cells":[{"cell_type":"code","source":)" + repeated("[") +
                              repeated("]") + "}]}");
  expect_tried("package.json", R"({"bin":)" + repeated(R"({"a":)") + "1" + repeated("}") + "}");
}

TEST(HostileIntake, is_not_ended_by_many_spaces) {
  const std::string spaces = repeated(" ");
  expect_tried("A.java", "public" + spaces + "static" + spaces + "void" + spaces + "x\nclass" +
                             spaces + "{ \n package" + spaces);
  expect_tried("a.cpp", "int" + spaces + "main" + spaces + "(\n#include" + spaces + "<x\n");
}

}  // namespace
}  // namespace raycheck::tests
