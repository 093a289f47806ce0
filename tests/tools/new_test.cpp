// `new`: adapters that compile at once, and report missing functions when they are judged.

#include "tests/tools/external/judged.h"

namespace raycheck::tests {
namespace {

TEST(New, writes_an_adapter_that_compiles_and_reports_missing_functions) {
  const std::string folder = temporary_folder("new");
  for (const auto& [language, candidate] : {std::pair("cpp", "source:" + folder + "/mine.cpp"),
                                            {"c", "source:" + folder + "/mine.c"},
                                            {"java", "command:java -cp " + folder + " mine"},
                                            {"python", "command:python3 " + folder + "/mine.py"},
                                            {"node", "command:node " + folder + "/mine.mjs"}}) {
    const std::string words = std::string("new mine --language ") + language + " --out " + folder;
    expect_parts(run(words, 0).out, {"mine", "raycheck properties --candidate"});
    expect_parts(run(words, 2).err, {"already exists; give another NAME"});
    if (std::string(language) == "node" && !is_installed("node")) continue;
    if (std::string(language) == "java") {
      if (!is_installed("javac")) continue;
      ASSERT_EQ(std::system(("cd " + folder + " && javac *.java").c_str()), 0);
    }
    const Outcome judged =
        run("check scene/examples/lecture-examples.toml --candidate '" + candidate + "'");
    EXPECT_EQ(judged.exit_code, 1) << candidate << judged.out << judged.err;
    expect_parts(judged.out, {"mine: calls nothing yet"});
  }
}

TEST(New, refuses_invalid_names_in_every_language) {
  for (const char* name : {"1st", "a-b", "../up", "''"}) {
    run(std::string("new ") + name, 2);
  }
  const std::string java = " --language java --out " + temporary_folder("reserved");
  for (const char* name : {"int", "true", "record", "RaycheckCandidate"}) {
    expect_refused("new " + (name + java),
                   std::string("NAME ") + name + ": is a reserved word of java");
  }
  run("new integer" + java, 0);
}

}  // namespace
}  // namespace raycheck::tests
