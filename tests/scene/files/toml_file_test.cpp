#include "scene/files/scene_file.h"
#include "scene/files/toml_fields.h"
#include "scene/number.h"
#include "tests/testing.h"

namespace raycheck::scene {
namespace {

constexpr const char* kCamera =
    "[camera]\n"                // 1
    "eye = [8, 8, 100]\n"       // 2
    "look_at = [8, 8, 54]\n"    // 3
    "up = [0, 1, 0]\n"          // 4
    "near = -30\n"              // 5
    "far = -75\n"               // 6
    "left = -20\nright = 20\n"  // 7, 8
    "bottom = 20\ntop = -20\n"  // 9, 10
    "width = 3\nheight = 3\n";  // 11, 12
const std::string kRay = "[[ray]]\norigin = [-5, 1, 0]\ndirection = [1, 0, 0]\n";

Scene read_scene(const std::string& text) { return read_toml(text, "f.toml").scene; }

std::string error_of_toml(const std::string& text) {
  return thrown_by<SceneFileError>([&] { read_scene(text); });
}

std::string camera_with(const std::string& from, const std::string& to) {
  return replaced(kCamera, from, to);
}

double radius_read_from(const std::string& number) {
  return read_scene(kRay + "[[sphere]]\ncentre = [0, 0, 0]\nradius = " + number + "\n")
      .spheres.at(0)
      .radius;
}

double origin_read_from(const std::string& number) {
  const std::string text = "[[ray]]\norigin = [" + number + ", 0, 0]\ndirection = [1, 0, 0]\n";
  return read_scene(text).rays.at(0).origin.x;
}

void expect_bits(double value, double expected, const std::string& from) {
  EXPECT_EQ(std::bit_cast<std::uint64_t>(value), std::bit_cast<std::uint64_t>(expected))
      << from << " read as " << hexfloat(value);
}

TEST(ReadToml, ReadsACamera) {
  const Scene scene = read_scene(kCamera);
  ASSERT_TRUE(scene.camera);
  EXPECT_EQ(*scene.camera,
            (Camera{{8, 8, 100}, {8, 8, 54}, {0, 1, 0}, -30, -75, -20, 20, 20, -20, 3, 3}));
  EXPECT_EQ(scene.conventions, Conventions{});
  EXPECT_TRUE(scene.rays.empty());
  EXPECT_TRUE(scene.spheres.empty());
  EXPECT_FALSE(read_scene(camera_with("far = -75\n", "")).camera->far);
}

TEST(ReadToml, ReadsConventionsSpheresAndRays) {
  const Scene scene = read_scene(
      "[conventions]\nrows = 'top-first'\nsamples = \"centres\"\norigin = \"focal\"\n"
      "root = \"smaller\"\ntangent = \"either\"\n"
      "[[sphere]]\ncentre = [0, 1, 2.5]\nradius = 1\n[[sphere]]\ncentre = [3, 4, 5]\nradius = 0\n" +
      kRay);
  EXPECT_EQ(scene.conventions, (Conventions{Rows::kTopFirst, Samples::kCentres, Origin::kFocal,
                                            Root::kSmaller, Tangent::kEither}));
  EXPECT_EQ(scene.spheres, (std::vector<Sphere>{{{0, 1, 2.5}, 1}, {{3, 4, 5}, 0}}));
  EXPECT_EQ(scene.rays, (std::vector<Ray>{{{-5, 1, 0}, {1, 0, 0}}}));
}

TEST(ReadToml, AcceptsEveryLayoutThatTomlAllows) {
  const Scene expected = read_scene(kRay + "[[sphere]]\ncentre = [1, 2, 3]\nradius = 4\n");
  EXPECT_EQ(read_scene(
                "\xEF\xBB\xBFsphere = [{centre = [1, 2, 3], radius = 4}]\r\n"
                "ray = [{origin = [ # = [ \" \n -5,\n +1, 0x0, ], \"direction\" = [1, 0b0, 0o0]}]"),
            expected);
  EXPECT_EQ(read_scene("[[ray]] # '''\n'origin' = [-5, 1_0e-1, 0]\ndirection=[1.0,0e5,-0x0p+9]\n"
                       "[[sphere]]\ncentre=[1,2,3]\nradius=4"),
            expected);
}

TEST(ReadToml, ReadsNumbersExactly) {
  const std::pair<const char*, double> numbers[] = {{"5e-324", 0x1p-1074},
                                                    {".75", 0.75},
                                                    {"1e-400", 0},
                                                    {"9007199254740993", 9007199254740992.0},
                                                    {"9223372036854775807", 0x1p63},
                                                    {"100000000000000000000000", 1e23},
                                                    {"0xff", 255},
                                                    {"0x1.8p+3", 12},
                                                    {"\"0x1.8p+3\"", 12},
                                                    {"'0.1'", 0.1},
                                                    {"0x1.23456789abcdefp0", 0x1.23456789abcdfp0},
                                                    {"0x1_0.8p+0_1", 33},
                                                    {"1_000.000_1", 1000.0001}};
  for (const auto& [text, value] : numbers) {
    expect_bits(radius_read_from(text), value, text);
    expect_bits(origin_read_from(text), value, text);
  }
  for (const char* const text : {"-0.0", "-0", "-0x0p0", "\"-0\"", "-1e-400"}) {
    expect_bits(origin_read_from(text), -0.0, text);
  }
  const std::string halfway =
      "1.00000000000000011102230246251565404236316680908203125" + std::string(200, '0');
  expect_bits(radius_read_from(halfway), 1, halfway);
  expect_bits(radius_read_from(halfway + "1"), 0x1.0000000000001p0, halfway + "1");
}

TEST(ReadToml, RefusesUnknownKeysByNameAndLine) {
  EXPECT_EQ(error_of_toml(camera_with("near = -30\n", "near = -30\nfov = 60\n")),
            "f.toml:6: camera.fov = 60: unknown key; camera accepts eye, look_at, up, near, far, "
            "left, right, bottom, top, width, height");
  EXPECT_EQ(error_of_toml(std::string(kCamera) + "[[sphere]]\ncenter = [0, 0, 0]\nradius = 1\n"),
            "f.toml:14: sphere[0].center = [0, 0, 0]: unknown key; sphere accepts centre, radius");
  EXPECT_EQ(error_of_toml(kRay + "[[spheres]]\nradius = 1\n"),
            "f.toml:4: spheres = (an array of tables): unknown key; scene accepts camera, "
            "conventions, sphere, ray");
  EXPECT_EQ(
      error_of_toml(kRay + "length = 1979-05-27\n"),
      "f.toml:4: ray[0].length = (a date or time): unknown key; ray accepts origin, direction");
  EXPECT_EQ(
      error_of_toml("[conventions]\nroots = \"near\"\n"),
      "f.toml:2: conventions.roots = \"near\": unknown key; conventions accepts rows, samples, "
      "origin, root, tangent, t_min, t_max, interval, t_unit, culling");
}

TEST(ReadToml, NamesMissingKeysAtTheirTable) {
  EXPECT_EQ(error_of_toml("\n" + camera_with("near = -30\n", "")),
            "f.toml:2: camera.near: is missing");
  EXPECT_EQ(error_of_toml(kRay + "\n[[sphere]]\ncentre = [0, 0, 0]\nradius = 1\n"
                                 "[[sphere]]\ncentre = [0, 0, 0]\n"),
            "f.toml:8: sphere[1].radius: is missing");
  for (const char* const key :
       {"eye", "look_at", "up", "near", "left", "right", "bottom", "top", "width", "height"}) {
    std::string text = kCamera;
    const std::size_t at = text.find(std::string("\n") + key) + 1;
    text.erase(at, text.find('\n', at) + 1 - at);
    EXPECT_EQ(error_of_toml(text), std::string("f.toml:1: camera.") + key + ": is missing");
  }
}

TEST(ReadToml, NamesWrongTypes) {
  constexpr const char* kTriple = ": must be 3 numbers, written [x, y, z]";
  const std::pair<std::string, std::string> errors[] = {
      {camera_with("[8, 8, 100]", "8"), "2: camera.eye = 8" + std::string(kTriple)},
      {camera_with("[8, 8, 100]", "[8, 8]"), "2: camera.eye = [8, 8]" + std::string(kTriple)},
      {camera_with("[8, 8, 100]", "[8, \"x\", 100]"), "2: camera.eye[1] = \"x\": must be a number"},
      {camera_with("near = -30", "near = true"), "5: camera.near = true: must be a number"},
      {camera_with("near = -30", "near = \"\\u0001\\n\""),
       "5: camera.near = \"\\x01\\x0a\": must be a number"},
      {"\ncamera = 3\n", "2: camera = 3: must be a table, written [camera]"},
      {"[sphere]\nradius = 3\n", "1: sphere = (a table): must be written [[sphere]]"},
      {"ray = [\n{origin = [0, 0, 0], direction = [1, 0, 0]},\n7]\n",
       "3: ray[1] = 7: must be a table, written [[ray]]"},
      {"[conventions]\nrows = \"top\"\n",
       "2: conventions.rows = \"top\": must be one of bottom-first, top-first"},
      {"[conventions]\ntangent = 1\n",
       "2: conventions.tangent = 1: must be one of hit, miss, either"}};
  for (const auto& [text, error] : errors) EXPECT_EQ(error_of_toml(text), "f.toml:" + error);
}

TEST(ReadToml, NeedsWholePixels) {
  for (const char* const width : {"3.0", "1e1", "3.5", "\"three\"", "true", "0x1p2", "1e400"}) {
    const std::string error =
        error_of_toml(camera_with("width = 3", std::string("width = ") + width));
    EXPECT_EQ(error, std::string("f.toml:11: camera.width = ") + width +
                         ": must be a whole number of pixels, without a point or exponent");
  }
  EXPECT_EQ(read_scene(camera_with("width = 3", "width = +1_024")).camera->width, 1024);
  EXPECT_EQ(read_scene(camera_with("width = 3", "width = 0x10")).camera->width, 16);
}

TEST(ReadToml, ReportsEveryValidationProblemWithItsLine) {
  EXPECT_EQ(
      error_of_toml("[camera]\neye = [1, 2, 3]\nlook_at = [1, 2, 3]\nup = [1, 0, 0]\nnear = 0\n"
                    "left = 1\nright = 1.0\nbottom = -1\ntop = 1e400\nwidth = 1\nheight = 0\n"
                    "[[sphere]]\ncentre = [0, 0, nan]\nradius = -1\n"),
      "f.toml:3: camera.look_at = [1, 2, 3]: is the same point as eye\n"
      "f.toml:5: camera.near = 0: is zero, so the image plane passes through the eye\n"
      "f.toml:7: camera.right = 1: equals left, so the image has no width\n"
      "f.toml:9: camera.top = inf: is not finite\n"
      "f.toml:11: camera.height = 0: is below 1 pixel\n"
      "f.toml:10: camera.width = 1: is too few; samples = edges "
      "divides by this number less 1: give 2 or more\n"
      "f.toml:13: sphere[0].centre = [0, 0, nan]: is not finite\n"
      "f.toml:14: sphere[0].radius = -1: is negative");
  EXPECT_EQ(error_of_toml(kRay + "[[ray]]\norigin = [0, 0, 0]\ndirection = [0, 0, 0]\n"),
            "f.toml:6: ray[1].direction = [0, 0, 0]: is the zero vector");
  EXPECT_EQ(error_of_toml(""), "f.toml:1: scene = (no camera, no rays): needs one of the two");
  EXPECT_EQ(error_of_toml(std::string(kCamera) + kRay),
            "f.toml:13: scene = a camera and 1 ray: needs one of the two, not both");
}

TEST(ReadToml, LocatesSyntaxErrors) {
  for (const char* const line :
       {"near = ", "near = 1 2", "near = 1e", "near = --1", "near = [1", "near = \"a", "near",
        "near = 1__0", "near = 1_", "near = -1\nnear = -2", "[camera", "near = '\xff'",
        "near = 0x1.8p"}) {
    const std::string error =
        error_of_toml(std::string("[camera]\nup = [0, 1, 0]\n") + line + "\n");
    EXPECT_EQ(error.substr(0, 7), "f.toml:") << line;
    EXPECT_TRUE(has(error, ": not valid TOML: ")) << line;
    EXPECT_GE(std::stoi(error.substr(7)), 3) << line << "\n" << error;
  }
  EXPECT_EQ(
      error_of_toml("[camera]\r\n  near = abc\r\nleft = 1"),
      "f.toml:2: not valid TOML: near = abc: the value is neither a number nor true, false or "
      "in quotes");
}

TEST(WriteToml, IsReadable) {
  Scene scene;
  scene.rays = {{{-0.0, 1e300, 5e-324}, {1, 0.1, 1e18}}};
  scene.spheres = {{{1, -2, 3}, 1234567890123456768.0}};
  scene.conventions.tangent = Tangent::kMiss;
  EXPECT_EQ(write_toml(scene, "one\n\ntwo\r"),
            "# one\n#\n# two \n\n[conventions]\ntangent = \"miss\"\n\n"
            "[[sphere]]\ncentre = [1, -2, 3]\nradius = 1234567890123456768.0\n\n"
            "[[ray]]\norigin = [-0.0, 1e+300, 5e-324]\ndirection = [1, 0.1, 1e+18]\n");
  scene.conventions = {};
  EXPECT_EQ(write_toml(scene).find("conventions"), std::string::npos);
}

Scene with_conventions(const std::string& conventions) {
  return read_toml("[conventions]\n" + conventions + kRay, "scene.toml").scene;
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
    EXPECT_EQ(scene.conventions.valid.t_max, kInfinity);
    EXPECT_TRUE(read_toml(write_toml(scene), "again").scene == scene) << write_toml(scene);
    scene.conventions.valid.t_max = 0x1.123456789abcdp+7;
    EXPECT_TRUE(read_toml(write_toml(scene), "again").scene == scene) << write_toml(scene);
  }
}

TEST(ValidRootsFile, IsRefusedIfItMakesNoSense) {
  const std::pair<const char*, const char*> refused[] = {
      {"t_min = -1\n", "t_min = -1: must be finite and at least 0"},
      {"t_min = inf\n", "must be finite and at least 0"},
      {"t_min = 2\nt_max = 1\n", "t_max = 1: is below t_min"},
      {"interval = \"[0, 1]\"\n", "interval = \"[0, 1]\": must be one of"},
      {"t_unit = \"metres\"\n", "t_unit = \"metres\": must be one of absolute, radius"},
      {"culling = \"front-faces\"\nroot = \"smaller\"\n",
       "culls every root that root = smaller accepts"}};
  for (const auto& [conventions, words] : refused) {
    EXPECT_TRUE(has(error_of_toml("[conventions]\n" + std::string(conventions) + kRay), words));
  }
}

TEST(HostileToml, has_a_limit_of_parts_of_a_key) {
  const std::string refused = ": nesting: more than 32 parts of a key; at most 32 are read";
  for (const std::size_t parts : {std::size_t{33}, std::size_t{40000}, std::size_t{1000000}}) {
    EXPECT_EQ(error_of_toml("\n" + repeated("a.", parts - 1) + "a = 1\n"), "f.toml:2" + refused);
    EXPECT_EQ(error_of_toml("[" + repeated("a.", parts - 1) + "a]\n"), "f.toml:1" + refused);
    EXPECT_EQ(error_of_toml("[[" + repeated("a . ", parts - 1) + "a]]\n"), "f.toml:1" + refused);
    EXPECT_EQ(error_of_toml("x = {" + repeated("\"a\".", parts - 1) + "a = 1}\n"),
              "f.toml:1" + refused);
  }
  const std::string most = repeated("a.", kMostNested - 1) + "a";
  EXPECT_EQ(error_of_toml("[" + most + "]\n" + most + " = {" + most + " = 1}\n").substr(0, 24),
            "f.toml:1: [a]: unknown t");
}

TEST(HostileToml, has_a_limit_of_nesting) {
  for (const std::size_t depth : {std::size_t{33}, std::size_t{100000}}) {
    EXPECT_EQ(error_of_toml("x = " + repeated("[", depth)),
              "f.toml:1: nesting: more than 32 nested lists and tables; at most 32 are "
              "read");
    EXPECT_TRUE(has(error_of_toml("\n\nx = " + repeated("{a=", depth)), "f.toml:3: nesting: "));
    EXPECT_TRUE(has(error_of_toml("x = [\n" + repeated("[\n", depth)), ": nesting: "));
  }
  EXPECT_EQ(
      error_of_toml("x = " + repeated("[", kMostNested) + repeated("]", kMostNested)).substr(0, 13),
      "f.toml:1: x =");
}

TEST(HostileToml, counts_no_dots_of_numbers_strings_and_comments) {
  std::string text = "x = [" + repeated("1.5, -0.25e3, 0x1.8p0, ", 1000) + "1.0]\n";
  text += "y = \"" + repeated(".", 1000) + "\"\nz = '''" + repeated(".\n.", 1000) + "'''\n";
  text += "# " + repeated("a.", 1000) + "\n";
  EXPECT_FALSE(has(error_of_toml(text), "nesting"));
}

}  // namespace
}  // namespace raycheck::scene
