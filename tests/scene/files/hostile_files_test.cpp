#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>

#include "scene/files/file_text.h"
#include "scene/files/scene_file.h"
#include "scene/files/toml_fields.h"

namespace raycheck::scene {
namespace {

namespace fs = std::filesystem;

std::string repeated(const std::string& text, std::size_t times) {
  std::string all;
  for (std::size_t k = 0; k < times; ++k) all += text;
  return all;
}

template <class Call>
std::string error_of(const Call& call) {
  try {
    call();
  } catch (const SceneFileError& error) {
    return error.what();
  }
  return "no error";
}

std::string toml_error(const std::string& text) {
  return error_of([&] { read_toml(text, "f.toml"); });
}

TEST(HostileToml, has_a_limit_of_parts_of_a_key) {
  const std::string refused = ": nesting: more than 32 parts of a key; at most 32 are read";
  for (const std::size_t parts : {std::size_t{33}, std::size_t{40000}, std::size_t{1000000}}) {
    EXPECT_EQ(toml_error("\n" + repeated("a.", parts - 1) + "a = 1\n"), "f.toml:2" + refused);
    EXPECT_EQ(toml_error("[" + repeated("a.", parts - 1) + "a]\n"), "f.toml:1" + refused);
    EXPECT_EQ(toml_error("[[" + repeated("a . ", parts - 1) + "a]]\n"), "f.toml:1" + refused);
    EXPECT_EQ(toml_error("x = {" + repeated("\"a\".", parts - 1) + "a = 1}\n"),
              "f.toml:1" + refused);
  }
  const std::string most = repeated("a.", kMostNested - 1) + "a";
  EXPECT_EQ(toml_error("[" + most + "]\n" + most + " = {" + most + " = 1}\n").substr(0, 24),
            "f.toml:1: a = (a table):");
}

TEST(HostileToml, has_a_limit_of_what_is_inside_each_other) {
  for (const std::size_t depth : {std::size_t{33}, std::size_t{100000}}) {
    EXPECT_EQ(toml_error("x = " + repeated("[", depth)),
              "f.toml:1: nesting: more than 32 lists and tables inside each other; at most 32 are "
              "read");
    EXPECT_NE(toml_error("\n\nx = " + repeated("{a=", depth)).find("f.toml:3: nesting: "),
              std::string::npos);
    EXPECT_NE(toml_error("x = [\n" + repeated("[\n", depth)).find(": nesting: "),
              std::string::npos);
  }
  EXPECT_EQ(
      toml_error("x = " + repeated("[", kMostNested) + repeated("]", kMostNested)).substr(0, 13),
      "f.toml:1: x =");
}

TEST(HostileToml, counts_no_dots_of_numbers_strings_and_comments) {
  std::string text = "x = [" + repeated("1.5, -0.25e3, 0x1.8p0, ", 1000) + "1.0]\n";
  text += "y = \"" + repeated(".", 1000) + "\"\nz = '''" + repeated(".\n.", 1000) + "'''\n";
  text += "# " + repeated("a.", 1000) + "\n";
  EXPECT_EQ(toml_error(text).find("nesting"), std::string::npos);
}

// A reader that takes quadratic time does not come to an end here.
TEST(HostileDriverFile, of_a_million_spheres_is_read) {
  constexpr std::size_t kSpheres = 1000000;
  std::string text = "eye 0 0 10\nlook 0 0 0\nup 0 1 0\nd -5\nbounds -1 1 -1 1\nres 4 4\n";
  for (std::size_t k = 0; k < kSpheres; ++k) text += "sphere 1 2 3 4 .1 .1 .1\n";
  const LoadedScene loaded = read_driver_file(text, "f.txt");
  EXPECT_EQ(loaded.scene.spheres.size(), kSpheres);
  EXPECT_TRUE(loaded.warnings.empty());
  EXPECT_EQ(error_of([&] { read_driver_file(text + "sphere 1 2 3 -4", "f.txt"); }),
            "f.txt:1000007: sphere[1000000].radius = -4: is negative");
}

TEST(HostileDriverFile, of_other_words_has_few_warnings) {
  std::string text = "camera 0 0 10 0 0 0 0 1 0 -5\nbounds -1 1 -1 1\nres 4 4\n";
  for (int k = 0; k < 5000; ++k) text += "\x1b[31mword" + std::to_string(k) + "\n";
  const LoadedScene loaded = read_driver_file(text, "f.txt");
  EXPECT_EQ(loaded.warnings.size(), 20u);
  EXPECT_EQ(loaded.warnings.front(),
            "f.txt:4: \\x1b[31mword0: unknown keyword, ignored (first on line 4)");
}

TEST(HostileDriverFile, has_few_of_its_many_errors_listed) {
  std::string text = "camera 0 0 10 0 0 0 0 1 0 -5\nbounds -1 1 -1 1\nres 4 4\n";
  for (int k = 0; k < 5000; ++k) text += "sphere 1 2 3 -4\n";
  const std::string error = error_of([&] { read_driver_file(text, "f.txt"); });
  EXPECT_EQ(std::count(error.begin(), error.end(), '\n'), 20);
  EXPECT_TRUE(error.ends_with("\nand 4980 more problems")) << error;
}

class HostileFile : public testing::Test {
 protected:
  HostileFile() : folder_(testing::TempDir() + "raycheck_files_" + std::to_string(getpid())) {
    fs::create_directories(folder_);
  }
  ~HostileFile() override { fs::remove_all(folder_); }

  static std::string refusal(const fs::path& path) {
    return error_of([&] { file_text(path, 100); });
  }

  fs::path folder_;
};

TEST_F(HostileFile, that_is_none_is_refused) {
  const fs::path pipe = folder_ / "pipe", link = folder_ / "link";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  fs::create_symlink(pipe, link);
  const std::string named = ": cannot be read: it is a named pipe; give a file, or /dev/stdin";
  EXPECT_EQ(refusal(pipe), pipe.string() + named);
  EXPECT_EQ(refusal(link), link.string() + named);
  for (const char* device : {"/dev/zero", "/dev/null", "/dev/urandom"}) {
    EXPECT_EQ(refusal(device),
              std::string(device) + ": cannot be read: it is a device; give a file");
  }
  EXPECT_EQ(refusal(folder_), folder_.string() + ": cannot be read: it is a folder; give a file");
}

TEST_F(HostileFile, of_more_than_the_limit_is_refused) {
  const fs::path file = folder_ / "large";
  std::ofstream(file) << std::string(100, 'x');
  EXPECT_EQ(file_text(file, 100).size(), 100u);
  fs::resize_file(file, 101);
  const std::string why = ": cannot be read: it has more than 100 bytes, the most that are read";
  EXPECT_EQ(refusal(file), file.string() + why);
  fs::resize_file(file, std::uintmax_t{1} << 40);  // without taking room
  EXPECT_EQ(
      error_of([&] { load_scene(file); }),
      file.string() + ": cannot be read: it has more than 268435456 bytes, the most that are read");
}

TEST_F(HostileFile, that_is_a_pipe_of_a_shell_is_read) {
  int ends[2] = {};
  ASSERT_EQ(pipe(ends), 0);
  const std::string name = "/dev/fd/" + std::to_string(ends[0]);
  ASSERT_EQ(write(ends[1], "hello", 5), 5);
  ASSERT_EQ(close(ends[1]), 0);
  EXPECT_EQ(file_text(name, 5), "hello");
  close(ends[0]);
}

}  // namespace
}  // namespace raycheck::scene
