// `new`: adapters that compile at once, and report missing functions when they are judged.

#include "scene/files/file_text.h"
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

constexpr const char* kExample = R"(// A course's own file.
camera 0,0,5 0,0,0 0,1,0 40
Resolution 32,24
fog 1 2 3
light 0 9 9
Ball 0,0,-10 3 255,0,0 16
)";

TEST(NewFormat, reads_the_example_from_which_it_is_drafted) {
  const std::string folder = temporary_folder("format");
  const std::string example = temporary_file("example.txt", kExample);
  const std::string words = "new ours --from " + example + " --out " + folder;
  expect_parts(run(words, 0).out,
               {"reads " + example + " as 32 x 24 pixels and 1 sphere, without fog, light",
                "raycheck check " + example + " --dialect " + folder + "/ours.toml"});
  expect_parts(run(words, 2).err, {"ours.toml already exists; give another NAME"});
  const std::string draft = scene::file_text(folder + "/ours.toml");
  expect_parts(draft, {"# fog: its meaning is not known.", "comments = \"//\"", "joint = \",\"",
                       "camera {eye} {look_at} {up} {fovy}\nResolution {width} {height}\n"
                       "Ball {centre} {radius} {colour255} {*:16}\n"});
  EXPECT_EQ(draft.find("# light"), std::string::npos);
  expect_parts(run("check " + example + " --dialect " + folder + "/ours.toml", 0).out,
               {"(format ours.toml): 32 x 24 pixels, 1 sphere"});
}

TEST(NewFormat, names_what_its_example_does_not_give) {
  const std::string folder = temporary_folder("format");
  const std::string example = temporary_file("half.txt", "eye 0 0 5\nsphere 0 0 0 1\n");
  expect_parts(run("new half --from " + example + " --out " + folder, 0).out,
               {"does not read " + example + " yet: ", "half.toml"});
  expect_parts(scene::file_text(folder + "/half.toml"),
               {"# No line gives the up vector: name its numbers {up}",
                "# No line gives the angle of view or the window: name its numbers {fovy}"});
  expect_parts(run("new other --from no-such-file", 2).err, {"no-such-file: cannot be read"});
  expect_parts(
      run("new other --from scene/examples/balls.yml", 2).err,
      {"--from scene/examples/balls.yml: is nested, and formats are drafted only from files",
       "scene/formats/rtc.toml how to write another"});
  for (const std::string text : {"", "# nothing\n",
                                 "gr\xf6\xdf"
                                 "e 1\n",
                                 "\x7f"
                                 "ELF\x01 2\n"}) {
    const std::string file = temporary_file("no-scene.txt", text);
    expect_parts(run("new other --from " + file, 2).err,
                 {"--from " + file + ": has no statements in UTF-8"});
  }
}

}  // namespace
}  // namespace raycheck::tests
