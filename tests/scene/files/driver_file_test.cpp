#include <sys/stat.h>
#include <unistd.h>

#include "scene/files/file_text.h"
#include "scene/files/format.h"
#include "scene/files/scene_file.h"
#include "scene/plan/plan.h"
#include "tests/testing.h"

namespace raycheck::scene {
namespace {

namespace fs = std::filesystem;

const std::string kView = "eye 0 0 4\nlook 0 0 0\nup 0 1 0\n";
const std::string kA = kView + "d 2\nbounds -1 -2 3 4\nres 16 9\n";
const std::string kB = kView + "d -2\nbounds -1 3 -2 4\nres 16 9\n";
const std::string kC = "camera 0 0 4 0 0 0 0 1 0 -2\nbounds -1 3 -2 4\nres 16 9\n";

LoadedScene read(const std::string& text, const std::string& dialect = "") {
  return read_any_format(text, "f.txt", format_named(dialect));
}

std::string error_of(const std::string& text, const std::string& dialect = "") {
  return thrown_by<SceneFileError>([&] { read(text, dialect); });
}

Scene expected_scene() {
  Scene scene;
  scene.camera = Camera{{0, 0, 4}, {0, 0, 0}, {0, 1, 0}, -2, {}, -1, 3, -2, 4, 16, 9};
  scene.conventions = {Rows::kTopFirst, Samples::kEdges, Origin::kPixel, Root::kNearest,
                       Tangent::kHit};
  return scene;
}

TEST(ReadDriverFile, ReadsEachDialectAlike) {
  for (const auto& [text, dialect] : {std::pair(kA, "A"), {kB, "B"}, {kC, "C"}}) {
    const LoadedScene loaded = read(text);
    EXPECT_EQ(loaded.scene, expected_scene()) << text;
    EXPECT_TRUE(loaded.warnings.empty()) << text;
    EXPECT_EQ(loaded.format, dialect) << text;
    EXPECT_EQ(read(text, dialect).scene, expected_scene()) << text;
  }
}

TEST(ReadDriverFile, TakesLinesInAnyOrderAndLayout) {
  EXPECT_EQ(
      read("\xEF\xBB\xBF# driver\r\nres\t16 9 # pixels\r\n\r\nbounds -1 -2 3 4#b\r\n  d 2.\r\n"
           "up 0 +1 0\r\n\t \r\nlook 0 0 0x0p0\r\neye 0 0 4e0")
          .scene,
      expected_scene());
}

TEST(ReadDriverFile, ReadsSpheresInOrder) {
  const LoadedScene loaded = read("sphere 1 2 3 .75\n" + kB + "sphere -1 0x1p-1 1e300 0\n");
  EXPECT_EQ(loaded.scene.spheres, (std::vector<Sphere>{{{1, 2, 3}, 0.75}, {{-1, 0.5, 1e300}, 0}}));
  EXPECT_TRUE(loaded.warnings.empty());
}

TEST(ReadDriverFile, ListsEntriesThatOnlyShadingNeeds) {
  const std::string sphere = "sphere 0 0 -9 1";
  std::string text = kB + "ambient .1 .1 .1\nlight 1 1 1\nrecursionLevel 3\nlight 2 2 2\n" +
                     "model 0 1 0 45 2 0 0 0 cube.obj\nrecursionlevel 2\n";
  for (const int more : {9, 12, 13, 14, 15, 16, 17}) {
    text += sphere;
    for (int k = 0; k < more; ++k) text += " .5";
    text += "\n";
  }
  const LoadedScene loaded = read(text);
  EXPECT_TRUE(loaded.warnings.empty());
  EXPECT_EQ(loaded.not_needed,
            (std::vector<std::string>{"ambient", "2 lights", "recursionLevel", "model",
                                      "recursionlevel", "numbers after a sphere's first 4"}));
  EXPECT_EQ(loaded.scene.spheres.size(), 7u);
  EXPECT_TRUE(read(kB + sphere + "\n").not_needed.empty());
}

TEST(ReadDriverFile, WarnsOnceAboutEachOddity) {
  std::string text = replaced(kB, "d -2", "d -2 7") + "fog 1 1 1\nfog 2 2 2\nAmbient .1 .1 .1\n";
  for (int i = 0; i < 10; ++i) text += "sphere 0 0 -9 1 .1 .1 .1 red\n";
  const std::vector<std::string> warnings = read(text).warnings;
  EXPECT_EQ(warnings,
            (std::vector<std::string>{
                "f.txt:4: d: numbers after the first are ignored (first on line 4)",
                "f.txt:7: fog: unknown keyword, ignored (first on line 7)",
                "f.txt:9: Ambient: unknown keyword, ignored (first on line 9)",
                "f.txt:10: sphere: numbers after the first 4 are ignored (first on line 10)"}));
  EXPECT_EQ(read(text).scene.spheres.size(), 10u);
}

TEST(ReadDriverFile, RefusesADialectThatTheFileContradicts) {
  EXPECT_EQ(error_of(kB, "A"),
            "f.txt:4: d = -2: must be above 0 in the format A, or below 0 in B; the file is of the "
            "format B");
  EXPECT_EQ(error_of(kA, "B"),
            "f.txt:4: d = 2: must be below 0 in the format B, or above 0 in A; the file is of the "
            "format A");
  EXPECT_EQ(error_of(kA, "C"),
            "f.txt:1: eye: cannot be read: the camera line gives it; the file is of the format A");
  for (const std::string dialect : {"A", "B"}) {
    EXPECT_EQ(error_of(kC, dialect),
              "f.txt:1: camera: cannot be read: a camera line is of dialect C; the file is of the "
              "format C");
  }
}

TEST(ReadDriverFile, NamesFileLineFieldAndValueOfErrors) {
  constexpr const char* kNoSign = ": must be above 0 in the format A, or below 0 in B";
  constexpr const char* kNeeded = " is missing, which the format A needs";
  const std::pair<std::string, std::string> errors[] = {
      {replaced(kA, "d 2\n", ""), "f.txt:1: d:" + std::string(kNeeded)},
      {replaced(kA, "d 2", "D 2"), "f.txt:4: D: unknown keyword; d" + std::string(kNeeded)},
      {replaced(kA, "up 0", "upp 0"), "f.txt:3: upp: unknown keyword; up" + std::string(kNeeded)},
      {"fog 1\n" + replaced(kA, "res 16 9\n", ""),
       "f.txt:1: fog: unknown keyword; res" + std::string(kNeeded)},
      {replaced(kA, "d 2", "d -0"), "f.txt:4: d = -0" + std::string(kNoSign)},
      {replaced(kA, "d 2", "d nan"), "f.txt:4: d = nan" + std::string(kNoSign)},
      {replaced(kC, "-2", "2"), "f.txt:1: near = 2: must be below 0 in the format C"},
      {replaced(kA, "d 2", "d 1e400"), "f.txt:4: camera.near = -inf: is not finite"},
      {kC + "look 1 2 3\n", "f.txt:4: look: cannot be read: the camera line gives it"},
      {"d 2\n" + kC, "f.txt:1: d: cannot be read: the camera line gives it"},
      {kA + "\nup 1 0 0\n", "f.txt:8: up = 1 0 0: is given twice, first on line 3"},
      {kC + "res 16 9\n", "f.txt:4: res = 16 9: is given twice, first on line 3"},
      {replaced(kA, "eye 0 0 4", "eye 0 zero 4"), "f.txt:1: eye[1] = zero: is not a number"},
      {replaced(kA, "eye 0 0 4", "eye 0 \x01 4"), "f.txt:1: eye[1] = \\x01: is not a number"},
      {kA + "sphere 1 2 3\n", "f.txt:7: sphere = 1 2 3: needs 4 numbers, has 3"},
      {kA + "sphere 1 2 3 r\n", "f.txt:7: sphere[3] = r: is not a number"},
      {replaced(kA, "d 2", "d"), "f.txt:4: d = : needs 1 number, has 0"},
      {replaced(kC, " -2", ""), "f.txt:1: camera = 0 0 4 0 0 0 0 1 0: needs 10 numbers, has 9"},
      {replaced(kA, "res 16 9", "res 16 9223372036854775807"),
       "f.txt:6: res[1] = 9223372036854775807: is not a whole number of pixels"},
      {replaced(kA, "res 16 9", "res 16.0 9"),
       "f.txt:6: res[0] = 16.0: is not a whole number of pixels"}};
  for (const auto& [text, error] : errors) EXPECT_EQ(error_of(text), error);
}

TEST(ReadDriverFile, SaysWhenTheOtherBoundsOrderWouldHaveAnArea) {
  EXPECT_EQ(
      error_of(kView + "d -2\nbounds -1 -1 1 1\nres 2 2\n"),
      "f.txt:5: bounds = -1 -1 1 1: have no area in the order of the format B (left right bottom "
      "top), but have one in that of A (left bottom right top): reorder the numbers");
  EXPECT_EQ(
      error_of(kView + "d 2\nbounds -1 1 -1 1\nres 2 2\n"),
      "f.txt:5: bounds = -1 1 -1 1: have no area in the order of the format A (left bottom right "
      "top), but have one in that of B (left right bottom top): reorder the numbers");
  EXPECT_EQ(error_of(kView + "d 2\nbounds 1 1 1 1\nres 2 2\n"),
            "f.txt:5: camera.right = 1: equals left, so the image has no width\n"
            "f.txt:5: camera.top = 1: equals bottom, so the image has no height");
}

TEST(ReadDriverFile, NamesMissingKeywords) {
  for (const char* const keyword : {"eye", "look", "up", "d", "bounds", "res"}) {
    std::string text = "\n" + kA;
    const std::size_t at = text.find(std::string("\n") + keyword + " ") + 1;
    text.erase(at, text.find('\n', at) + 1 - at);
    EXPECT_EQ(error_of(text).substr(0, 9 + std::string(keyword).size() + 12),
              std::string("f.txt:1: ") + keyword + ": is missing");
  }
  EXPECT_EQ(error_of(replaced(kC, "bounds", "bound")),
            "f.txt:2: bound: unknown keyword; bounds is missing, which the format C needs");
}

TEST(ReadDriverFile, RefusesOtherKindsOfFiles) {
  const std::string kOther =
      ": not a scene file of a known format; `raycheck list` shows them, and the name of a TOML "
      "file must end in .toml";
  EXPECT_EQ(error_of("b 0 0 0\nv\nfrom 0 0 5\nat 0 0 0\nup 0 1 0\nres 2 2\n"),
            "f.txt:6: res: unknown keyword; resolution is missing, which the format nff needs");
  EXPECT_EQ(error_of("b 0 0 0\nv\nfrom 0 0 5\n"), "f.txt:1: first words = b, v, from" + kOther);
  EXPECT_EQ(error_of(""), "f.txt:1: first words = " + kOther);
  EXPECT_EQ(error_of("\x7f"
                     "ELF"),
            "f.txt:1: first words = \\x7fELF" + kOther);
  EXPECT_EQ(error_of("sphere 0 0 0 1\n"), "f.txt:1: first words = sphere" + kOther);
}

TEST(ReadDriverFile, LocatesEveryValidationProblem) {
  EXPECT_EQ(error_of("sphere 0 0 0 -1\neye 0 0 4\nlook 0 0 4\nup 1 0 0\nd -2\nbounds 1 2 3 4\n"
                     "res 0 1\nsphere 0 0 inf 1\n"),
            "f.txt:3: camera.look_at = [0, 0, 4]: is the same point as eye\n"
            "f.txt:7: camera.width = 0: is below 1 pixel\n"
            "f.txt:7: camera.height = 1: is too few; samples = edges "
            "divides by this number less 1: give 2 or more\n"
            "f.txt:1: sphere[0].radius = -1: is negative\n"
            "f.txt:8: sphere[1].centre = [0, 0, inf]: is not finite");
  EXPECT_EQ(error_of(replaced(kC, "0 1 0", "0 0 5")),
            "f.txt:1: camera.up = [0, 0, 5]: is exactly parallel to eye - look_at");
}

// A reader that needs quadratic time would not finish this test.
TEST(HostileDriverFile, of_a_million_spheres_is_read) {
  constexpr std::size_t kSpheres = 1000000;
  std::string text = "eye 0 0 10\nlook 0 0 0\nup 0 1 0\nd -5\nbounds -1 1 -1 1\nres 4 4\n";
  for (std::size_t k = 0; k < kSpheres; ++k) text += "sphere 1 2 3 4 .1 .1 .1\n";
  const LoadedScene loaded = read(text);
  EXPECT_EQ(loaded.scene.spheres.size(), kSpheres);
  EXPECT_TRUE(loaded.warnings.empty());
  EXPECT_EQ(error_of(text + "sphere 1 2 3 -4"),
            "f.txt:1000007: sphere[1000000].radius = -4: is negative");
}

TEST(HostileDriverFile, of_other_words_has_few_warnings) {
  std::string text = "camera 0 0 10 0 0 0 0 1 0 -5\nbounds -1 1 -1 1\nres 4 4\n";
  for (int k = 0; k < 5000; ++k) text += "\x1b[31mword" + std::to_string(k) + "\n";
  const LoadedScene loaded = read(text);
  EXPECT_EQ(loaded.warnings.size(), 20u);
  EXPECT_EQ(loaded.warnings.front(),
            "f.txt:4: \\x1b[31mword0: unknown keyword, ignored (first on line 4)");
}

TEST(HostileDriverFile, has_few_of_its_many_errors_listed) {
  std::string text = "camera 0 0 10 0 0 0 0 1 0 -5\nbounds -1 1 -1 1\nres 4 4\n";
  for (int k = 0; k < 5000; ++k) text += "sphere 1 2 3 -4\n";
  const std::string error = error_of(text);
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
    return thrown_by<SceneFileError>([&] { file_text(path, 100); });
  }

  fs::path folder_;
};

TEST_F(HostileFile, that_is_a_pipe_a_device_or_a_folder_is_refused) {
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
  const std::string why = ": cannot be read: it has more than 100 bytes, which is the limit";
  EXPECT_EQ(refusal(file), file.string() + why);
  fs::resize_file(file, std::uintmax_t{1} << 40);  // a sparse file, which needs no disk space
  EXPECT_EQ(
      thrown_by<SceneFileError>([&] { load_scene(file); }),
      file.string() + ": cannot be read: it has more than 268435456 bytes, which is the limit");
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

TEST(LoadScene, NamesTheFileAndTheReason) {
  for (const char* const file : {"raycheck-no-such-file.toml", "raycheck-no-such-file"}) {
    const fs::path path = fs::temp_directory_path() / file;
    EXPECT_EQ(thrown_by<SceneFileError>([&] { load_scene(path); }),
              path.string() + ": cannot be read: No such file or directory");
  }
}

TEST_F(HostileFile, of_toml_warns_that_it_has_no_dialect) {
  const fs::path path = folder_ / "dialect.toml";
  std::ofstream(path) << "[[ray]]\norigin = [0, 0, 0]\ndirection = [1, 0, 0]\n";
  EXPECT_TRUE(load_scene(path).warnings.empty());
  EXPECT_EQ(load_scene(path, format_named("A")).warnings,
            (std::vector<std::string>{path.string() +
                                      ": a dialect was given, but only driver files have one"}));
}

TEST(Examples, EachLoadsSaysWhatItShowsAndShowsSomething) {
  std::size_t scenes = 0, images = 0;
  for (const auto& entry : fs::directory_iterator(RAYCHECK_SOURCE_DIR "/scene/examples")) {
    SCOPED_TRACE(entry.path().string());
    std::string first_line;
    std::ifstream file(entry.path());
    ASSERT_TRUE(std::getline(file, first_line));
    EXPECT_TRUE(first_line.starts_with("# ") || first_line.starts_with("<!-- "));
    EXPECT_GT(first_line.size(), 30u);
    const LoadedScene loaded = load_scene(entry.path());
    const Scene& scene = loaded.scene;
    EXPECT_FALSE(scene.spheres.empty());
    EXPECT_TRUE(loaded.warnings.empty());
    EXPECT_EQ(loaded.not_needed.empty(), entry.path().extension() == ".toml");
    EXPECT_EQ(read_toml(write_toml(scene), "again").scene, scene);
    ++scenes;
    if (!scene.camera || entry.path().stem() == "sphere-behind-eye") continue;
    // Rays start at the eye, so that hits in front of the image plane count.
    Conventions conventions = scene.conventions;
    conventions.origin = Origin::kFocal;
    const auto spheres = plan_scene(scene, conventions, Wanted::kNearest).spheres;
    EXPECT_TRUE(std::any_of(spheres.begin(), spheres.end(),
                            [](const SpherePlan& sphere) { return !sphere.pixels.empty(); }));
    ++images;
  }
  EXPECT_EQ(scenes, 30u);
  EXPECT_EQ(images, 24u);
}

}  // namespace
}  // namespace raycheck::scene
