// t_min, t_max, interval, t_unit and culling in scene files.

#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "scene/files/scene_file.h"
#include "scene/validate.h"

namespace raycheck::scene {
namespace {

const std::string kOneRay = "[[ray]]\norigin = [0, 0, 0]\ndirection = [1, 0, 0]\n";

Scene with_conventions(const std::string& conventions) {
  return read_toml("[conventions]\n" + conventions + kOneRay, "scene.toml").scene;
}

std::string why_not(const std::string& conventions) {
  try {
    with_conventions(conventions);
  } catch (const std::exception& error) {
    return error.what();
  }
  return "";
}

TEST(ValidRootsFile, SaysWhichRootsCount) {
  const ValidRoots valid =
      with_conventions(
          "t_min = 0x1p-10\nt_max = 3\ninterval = \"(t_min, t_max]\"\nt_unit = \"radius\"\n"
          "culling = \"front-faces\"\n")
          .conventions.valid;
  EXPECT_EQ(valid.t_min, 0x1p-10);
  EXPECT_EQ(valid.t_max, 3);
  EXPECT_EQ(valid.ends, Ends::kOpenMin);
  EXPECT_FALSE(valid.includes_min());
  EXPECT_TRUE(valid.includes_max());
  EXPECT_EQ(valid.unit, TUnit::kRadius);
  EXPECT_EQ(valid.culling, Culling::kFrontFaces);
  EXPECT_TRUE(with_conventions("").conventions.valid.is_usual());
}

TEST(ValidRootsFile, ReadsBackWhatIsWritten) {
  for (const char* ends :
       {"[t_min, t_max]", "[t_min, t_max)", "(t_min, t_max]", "(t_min, t_max)"}) {
    Scene scene = with_conventions("t_min = 0.1\nculling = \"back-faces\"\ninterval = \"" +
                                   std::string(ends) + "\"\n");
    EXPECT_EQ(scene.conventions.valid.t_max, std::numeric_limits<double>::infinity());
    EXPECT_TRUE(read_toml(write_toml(scene), "again").scene == scene) << write_toml(scene);
    scene.conventions.valid.t_max = 0x1.123456789abcdp+7;
    EXPECT_TRUE(read_toml(write_toml(scene), "again").scene == scene) << write_toml(scene);
  }
}

TEST(ValidRootsFile, IsRefusedWhereItMakesNoSense) {
  const auto refuses = [](const std::string& conventions, const std::string& words) {
    EXPECT_NE(why_not(conventions).find(words), std::string::npos) << why_not(conventions);
  };
  refuses("t_min = -1\n", "t_min = -1: must be 0 or more, and finite");
  refuses("t_min = 2\nt_max = 1\n", "t_max = 1: is below t_min");
  refuses("interval = \"[0, 1]\"\n", "interval = \"[0, 1]\": must be one of");
  refuses("t_unit = \"metres\"\n", "t_unit = \"metres\": must be one of absolute, radius");
  refuses("culling = \"front-faces\"\nroot = \"smaller\"\n", "leaves nothing of root = smaller");
  refuses("t_min = inf\n", "must be 0 or more, and finite");
}

}  // namespace
}  // namespace raycheck::scene
