#include "scene/files/format.h"

#include <cmath>
#include <random>

#include "scene/fields.h"
#include "tests/names.h"
#include "tests/testing.h"

namespace raycheck::scene {
namespace {

/// A line that would be an error, and the message.
struct Wrong {
  std::string text, says;
};

constexpr const char* kFree = R"(title = "A free form"
separators = "{};,<>"
comments = "//"
lines = false
template = '''
Film { pixels {width} {height}; }

Camera { at {eye}; to {view}; up {up}; half {fovx_half_radians}; {_:1} }

Thing { kind ball; {*:red;} middle <{centre}>; across {diameter}; }
'''
ignored = { Lamp = "lamp" }
)";

constexpr const char* kBalls = R"(// a scene
Film { pixels 8 4; }
Lamp { 1 2 3 }
Camera { at 0 0 4; to 0 0 -2; up 0 1 0; half 0.5; deep }
Thing { kind plane; 1 2 3 }
Thing { kind ball; shiny; blue 2; middle <1,2,3>; across 3; }
Thing { kind ball; middle < 1 , 2 , -3 > across 1e1 }
)";

constexpr const char* kWindow = R"(title = "A window"
template = '''
NEAR {distance}
LEFT {left}
RIGHT {right}
BOTTOM {bottom}
TOP {top}
RES {width} {height}
SPHERE {name} {centre} {scale} {colour} {_:1}
'''
[fixed]
eye = [0, 0, 0]
view = [0, 0, -1]
up = [0, 1, 0]
[conventions]
samples = "corners"
)";

LoadedScene read(const char* format, const std::string& text) {
  return read_formatted(read_format(format, "the-format.toml"), text, "f.x");
}
std::string error_of(const char* format, const std::string& text) {
  return thrown_by<SceneFileError>([&] { read(format, text); });
}

TEST(ReadFormatted, TakesStatementsOverLinesWithOtherWordsBetween) {
  const LoadedScene loaded = read(kFree, kBalls);
  const double right = std::tan(0.5);
  const Camera camera{{0, 0, 4}, {0, 0, 2},  {0, 1, 0}, -1, {}, -right,
                      right,     -right / 2, right / 2, 8,  4};
  EXPECT_EQ(loaded.scene.camera, camera);
  EXPECT_EQ(loaded.scene.spheres, (std::vector<Sphere>{{{1, 2, 3}, 1.5}, {{1, 2, -3}, 5}}));
  EXPECT_EQ(loaded.not_needed, std::vector<std::string>{"lamp"});
}

const std::string kSides =
    "NEAR 1\nLEFT -2\nRIGHT 3\nBOTTOM -1\nTOP 1\nRES 8 4\nSPHERE s 0 0 -5 2 2 2 1 0 0 9\n";

TEST(ReadFormatted, TakesWindowsAndWhatAFormatFixes) {
  const LoadedScene loaded = read(kWindow, kSides);
  const Camera camera{{0, 0, 0}, {0, 0, -1}, {0, 1, 0}, -1, {}, -2, 3, -1, 1, 8, 4};
  EXPECT_EQ(loaded.scene.camera, camera);
  EXPECT_EQ(loaded.scene.conventions.samples, Samples::kCorners);
  EXPECT_EQ(read(kWindow, kSides + "SPHERE e 0 0 -5 2 1 2 1 0 0 9\n").not_needed,
            std::vector<std::string>{"ellipsoid"});
}

TEST(ReadFormatted, NamesLineAndKeywordOfWhatIsWrong) {
  for (const auto& [text, says] :
       {Wrong{replaced(kSides, "RIGHT", "RIHGT"),
              "f.x:3: RIHGT: unknown keyword; RIGHT is missing, which the format the-format needs"},
        {replaced(kSides, "TOP 1\n", ""),
         "f.x:1: TOP: is missing, which the format the-format needs"},
        {replaced(kSides, "TOP 1", "TOP x"), "f.x:5: TOP[0] = x: is not a number"},
        {replaced(kSides, "-5 2 2", "-5"),
         "f.x:7: SPHERE = s 0 0 -5 2 1 0 0 9: needs 9 numbers, has 8"},
        {replaced(kSides, "RES 8", "RES 8.5"), "f.x:6: RES[0] = 8.5: is not a whole number"},
        {replaced(kSides, "LEFT -2", "LEFT 3"), "f.x:3: camera.right = 3: "},
        {replaced(kSides, "2 2 2", "-2 -2 -2"), "f.x:7: sphere[0].radius = -2: "},
        {kSides + "TOP 2\n", "f.x:8: TOP = 2: is given twice, first on line 5"}}) {
    EXPECT_TRUE(has(error_of(kWindow, text), says));
  }
  const std::string free = replaced(kBalls, "half 0.5;", "");
  EXPECT_TRUE(has(error_of(kFree, free), "f.x:4: Camera: is not followed by what the format"));
  EXPECT_TRUE(has(error_of(kFree, "a picture, not a scene"), "f.x:1: first word = a: nothing in"));
  EXPECT_TRUE(has(read(kWindow, kSides + "WALL 1\nWALL 2\n").warnings.at(0),
                  "f.x:8: WALL: unknown keyword, ignored (first on line 8)"));
}

TEST(ReadFormatted, RefusesWhatWouldBeAnotherScene) {
  const std::string balls = "from 0 0 5\nat 0 0 0\nup 0 1 0\nangle 45\nresolution 8 8\ns 0 0 0 1\n";
  for (const char* const angle : {"0", "-45", "180", "360", "nan"}) {
    EXPECT_TRUE(has(thrown_by<SceneFileError>([&] {
                      read_any_format(replaced(balls, "angle 45", std::string("angle ") + angle),
                                      "f.x");
                    }),
                    std::string("f.x:4: angle = ") + angle + ": must be an angle of view"));
  }
  const std::string pbrt =
      "LookAt 0 0 5  0 0 0  0 1 0\nCamera \"perspective\" \"float fov\" [ 45 ]\n"
      "AttributeBegin\nTranslate 0 0 0\nShape \"sphere\" \"float radius\" [ 1 ]\nAttributeEnd\n";
  EXPECT_TRUE(has(thrown_by<SceneFileError>([&] { read_any_format(pbrt, "f.pbrt"); }),
                  "f.pbrt:5: Shape: cannot be read: only spheres that are area lights"));
  // A file is said to be of another format only if that reads it.
  const std::string nearly = replaced(balls, "up 0 1 0", "up 0 1");
  const std::string error =
      thrown_by<SceneFileError>([&] { read_any_format(nearly, "f.x", format_named("cse167")); });
  EXPECT_EQ(error.find("the file is of the format"), std::string::npos) << error;
  EXPECT_TRUE(
      has(thrown_by<SceneFileError>([&] { read_any_format(balls, "f.x", format_named("cse167")); }),
          "; the file is of the format nff"));
}

TEST(ReadFormat, RefusesWrongTemplates) {
  for (const auto& [text, says] :
       {Wrong{replaced(kWindow, "{left}", "{lef}"), "the-format.toml:2: template = "},
        {replaced(kWindow, "{left}", "{lef}"), "{lef} is not a slot"},
        {replaced(kWindow, "{left}", "{left:unit}"), "{left:unit} is not a slot"},
        {replaced(kWindow, "{left}", "1"), "has neither a window, {left} to {top}, nor an angle"},
        {replaced(kWindow, "{centre}", "1 2 3"), "has no {centre}: no spheres can be read"},
        {replaced(kWindow, "eye =", "eyes ="), "fixed.eyes = [0, 0, 0]: is not the name of a slot"},
        {replaced(kWindow, "eye = [0, 0, 0]", "eye = [0]"), "fixed.eye = [0]: must have 3 numbers"},
        {replaced(kWindow, "{scale}", "1 1 1"), "has a {centre} without {radius}, {diameter} or"},
        {replaced(kWindow, "LEFT {left}", "{left}"), "begins with a slot, not with a word"},
        {replaced(kWindow, "title", "digits = 1.5\ntitle"), "digits = 1.5: "},
        {replaced(kWindow, "title", "titel"),
         "the-format.toml:1: titel = \"A window\": unknown key"}}) {
    const std::string error =
        thrown_by<SceneFileError>([&, &its = text] { read_format(its, "the-format.toml"); });
    EXPECT_TRUE(has(error, says));
  }
}

/// Looks along x from (1, 2, 3); U = (0, -1, 0), V = (0, 0, 1).
const Scene kAlongX = {Camera{{1, 2, 3}, {4, 2, 3}, {0, 0, 2}, -1, -9, -1, 1, -1, 1, 4, 4},
                       {},
                       {{{6, 1, 3.5}, 2}},
                       {}};

TEST(WriteFormatted, MovesScenesToAFixedCamera) {
  EXPECT_TRUE(has(write_formatted(read_format(kWindow, "w.toml"), kAlongX),
                  "SPHERE sphere0 1 0.5 -5 2 2 2 1 1 1 1"));
  const std::string fixed = std::string(kFree) + "[fixed]\nup = [0, 1, 0]\n";
  const FileFormat format =
      read_format(replaced(replaced(fixed, "up {up}; ", ""), "{view}", "{view:unit}"), "f.toml");
  const std::string text = write_formatted(format, kAlongX);
  EXPECT_TRUE(has(text, "at 1 2 3; to 1 0 0;")) << text;
  EXPECT_TRUE(has(text, "middle <6 2.5 4>")) << text;
  Scene up = kAlongX;
  up.camera->look_at = {1, 5, 3};
  EXPECT_TRUE(has(why_not_expressed(format, up), "a fixed up vector, along which the camera"));
}

/// A random scene that a format expresses.
Scene random_scene(std::mt19937_64& random, const FileFormat& format) {
  const auto number = [&] { return std::uniform_real_distribution<double>(-9, 9)(random); };
  const auto positive = [&] { return std::uniform_real_distribution<double>(0.1, 2)(random); };
  Scene scene;
  Camera& camera = scene.camera.emplace();
  camera.eye = {number(), number(), number()};
  camera.look_at = {number(), number(), number()};
  camera.up = {number(), number(), number()};
  camera.width = std::uniform_int_distribution<int>(2, 99)(random);
  camera.height =
      format.has("size") ? camera.width : std::uniform_int_distribution<int>(2, 99)(random);
  const auto fixed_count = [&](const char* slot, std::int64_t& count) {
    for (const auto* fixed : {&format.fixed, &format.defaults}) {
      const auto found = fixed->find(slot);
      if (found != fixed->end() && !format.has(slot)) {
        count = static_cast<std::int64_t>(found->second[0]);
      }
    }
  };
  fixed_count("width", camera.width);
  fixed_count("height", camera.height);
  const double ratio = static_cast<double>(camera.height) / static_cast<double>(camera.width);
  camera.near = format.has_angle() ? -1 : -positive();
  camera.right = positive();
  for (const auto& [slot, numbers] : format.fixed) {
    const auto angle = angle_slot(slot);
    if (!angle) continue;
    const double half = std::tan(numbers[0] * angle->half);
    camera.right = angle->is_vertical(camera) ? half / ratio : half;
  }
  camera.top = format.has_angle() ? camera.right * ratio : positive();
  camera.left = format.has_angle() ? -camera.right : -positive();
  camera.bottom = format.has_angle() ? -camera.top : -positive();
  for (int k = 0; k < 3; ++k) {
    scene.spheres.push_back({{number(), number(), number()}, positive()});
  }
  const auto fixed = [&](const char* slot, auto& triple) {
    const auto found = format.fixed.find(slot);
    if (found == format.fixed.end()) return;
    triple = {found->second[0], found->second[1], found->second[2]};
  };
  fixed("eye", camera.eye);
  fixed("up", camera.up);
  fixed("look_at", camera.look_at);
  Vector3 view = camera.look_at - camera.eye;
  fixed("view", view);
  const auto make_unit = [&](const char* slot, Vector3& vector) {
    for (const FormatStatement& statement : format.statements) {
      for (const FormatPart& part : statement.parts) {
        if (part.slot != slot || part.written != kUnit) continue;
        const double length = std::hypot(vector.x, vector.y, vector.z);
        vector = {vector.x / length, vector.y / length, vector.z / length};
      }
    }
  };
  make_unit("view", view);
  make_unit("up", camera.up);
  camera.look_at = {camera.eye.x + view.x, camera.eye.y + view.y, camera.eye.z + view.z};
  if (format.up_widens) {  // files have up vectors of length 1 at right angles to the view
    const double along = (view.x * camera.up.x + view.y * camera.up.y + view.z * camera.up.z) /
                         (view.x * view.x + view.y * view.y + view.z * view.z);
    Vector3& up = camera.up;
    up = {up.x - along * view.x, up.y - along * view.y, up.z - along * view.z};
    const double length = std::hypot(up.x, up.y, up.z);
    up = {up.x / length, up.y / length, up.z / length};
  }
  return scene;
}

void expect_near(const Scene& got, const Scene& expected, double tolerance) {
  std::vector<double> a, b;
  Scene copies[] = {got, expected};
  for_each_number(copies[0], [&](double& x) { a.push_back(x); });
  for_each_number(copies[1], [&](double& x) { b.push_back(x); });
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t k = 0; k < a.size(); ++k) EXPECT_NEAR(a[k], b[k], tolerance) << k;
}

class EachFormat : public testing::TestWithParam<std::string> {};

TEST_P(EachFormat, ReadsWhatItWrites) {
  const FileFormat& format = formats().find(GetParam())->second;
  std::mt19937_64 random(7);
  for (int k = 0; k < 100; ++k) {
    const Scene scene = random_scene(random, format);
    ASSERT_EQ(why_not_expressed(format, scene), "");
    const std::string text = write_formatted(format, scene);
    const LoadedScene loaded = read_formatted(format, text, "written");
    EXPECT_EQ(loaded.warnings, std::vector<std::string>{}) << text;
    expect_near(loaded.scene, scene, format.digits == 0 ? 1e-12 : 1e-5);
    if (HasFailure()) FAIL() << text;
  }
}

TEST_P(EachFormat, SaysWhatItCannotExpress) {
  const FileFormat& format = formats().find(GetParam())->second;
  std::mt19937_64 random(7);
  Scene scene = random_scene(random, format);
  scene.camera->right *= 2;
  EXPECT_EQ(why_not_expressed(format, scene).empty(), !format.has_angle());
}

INSTANTIATE_TEST_SUITE_P(Formats, EachFormat, testing::ValuesIn([] {
                           std::vector<std::string> names;
                           for (const auto& [name, format] : formats()) names.push_back(name);
                           return names;
                         }()),
                         [](const auto& the_test) { return identifier(the_test.param); });

}  // namespace
}  // namespace raycheck::scene
