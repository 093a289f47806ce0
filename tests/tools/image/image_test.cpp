#include "reference/exact_ray.h"
#include "scene/files/scene_file.h"
#include "tests/tools/external/judged.h"
#include "tests/tools/report/picture.h"
#include "tools/report/picture_file.h"

namespace raycheck::tests {
namespace {

using reference::NearestSphere;

const std::array<std::uint8_t, 3> kBackground = {16, 18, 24};

/// A picture that the program wrote, and its output; the file is removed.
class Written {
 public:
  Written(const std::string& arguments, const std::string& extension, int exit_code = 0) {
    const std::string path = temporary_file("picture" + extension, "");
    fs::remove(path);
    outcome_ = run("image " + arguments + " --out " + path + " --format json");
    EXPECT_EQ(outcome_.exit_code, exit_code) << arguments << "\n" << outcome_.err;
    EXPECT_EQ(outcome_.err, "") << arguments;
    picture_ = read_picture(path);
    fs::remove(path);
  }

  const ReadPicture& picture() const { return picture_; }
  json report() const { return json::parse(outcome_.out); }

 private:
  Outcome outcome_;
  ReadPicture picture_;
};

/// The nearest sphere of a pixel, computed only by the exact ray, and the pixel's place in the
/// picture.
struct Seen {
  std::int64_t column, line;
  std::optional<NearestSphere> sphere;
};

std::vector<Seen> all_seen(const scene::Scene& scene) {
  const scene::Camera& camera = *scene.camera;
  const reference::ExactCamera exact(camera, scene.conventions);
  std::vector<Seen> all;
  for (std::int64_t j = 0; j < camera.height; ++j) {
    const bool top_first = scene.conventions.rows == scene::Rows::kTopFirst;
    for (std::int64_t i = 0; i < camera.width; ++i) {
      const reference::ExactRay ray(exact, {i, j});
      all.push_back({i, top_first ? j : camera.height - 1 - j,
                     ray.nearest(scene.spheres, scene.conventions)});
    }
  }
  return all;
}

std::string example(const std::string& name) {
  return RAYCHECK_SOURCE_DIR "/scene/examples/" + name;
}

/// A scene in which one ray touches a sphere exactly, between a ray that misses it and a ray that
/// meets it.
const std::string kTangent =
    camera_text(65, 33) + sphere_text("1, 0, -5", "1") + sphere_text("1, 0, -5", "0.5");

/// The hue of a colour, in degrees.
double hue(const std::array<std::uint8_t, 3>& colour) {
  const double x = colour[0] - 0.5 * colour[1] - 0.5 * colour[2];
  const double y = std::sqrt(0.75) * (double(colour[1]) - double(colour[2]));
  return std::atan2(y, x) * 180 / std::acos(-1.0);
}

TEST(Image, shows_the_nearest_sphere_of_every_pixel_in_distinct_colours) {
  std::size_t hits = 0, misses = 0;
  std::vector<std::string> paths;
  for (const char* name :
       {"example-6-top-first.toml", "example-6-bottom-first.toml", "sphere-behind-eye.toml",
        "sphere-around-eye.toml", "sphere-between-eye-and-plane.toml", "ten-spheres.toml",
        "far-sphere.toml", "grid-64.toml"}) {
    paths.push_back(example(name));
  }
  const std::string miss = "[conventions]\ntangent = \"miss\"\n" + kTangent;
  paths.push_back(temporary_file("tangent_hit.toml", kTangent));
  paths.push_back(temporary_file("tangent_miss.toml", miss));
  for (const std::string& path : paths) {
    const scene::Scene scene = scene::load_scene(path).scene;
    const Written written(path, ".png");
    ASSERT_EQ(written.picture().width, scene.camera->width);
    ASSERT_EQ(written.picture().height, scene.camera->height);
    std::uint64_t hits_here = 0;
    std::map<std::size_t, double> hues;
    for (const Seen& seen : all_seen(scene)) {
      ++(seen.sphere ? hits : misses);
      const auto& colour = written.picture().at(seen.column, seen.line);
      EXPECT_EQ(colour != kBackground, seen.sphere.has_value())
          << path << " " << seen.column << " " << seen.line;
      if (!seen.sphere) continue;
      ++hits_here;
      EXPECT_GT(*std::max_element(colour.begin(), colour.end()), 80) << path;
      const auto [at, is_new] = hues.emplace(seen.sphere->index, hue(colour));
      EXPECT_NEAR(std::remainder(hue(colour) - at->second, 360.0), 0, 3) << path;
    }
    expect_values(written.report(),
                  {{"pixels_that_see", hits_here}, {"spheres_seen", hues.size()}});
    for (auto a = hues.begin(); a != hues.end(); ++a) {
      for (auto b = std::next(a); b != hues.end(); ++b) {
        EXPECT_GT(std::abs(std::remainder(a->second - b->second, 360.0)), 12) << path;
      }
    }
    if (has(path, "tangent")) {
      EXPECT_EQ(written.picture().at(32, 16) != kBackground, path != paths.back()) << path;
    }
  }
  EXPECT_GT(hits, 400u);
  EXPECT_GT(misses, 500u);
}

TEST(Image, shows_the_errors_that_check_counts) {
  for (const auto& [method, exit_code] : {std::pair("quadratic", 1), std::pair("cross", 0)}) {
    const std::string arguments = example("far-sphere.toml") + " --intersect " + method;
    const json check = printed_json("check " + arguments);
    const json& quantities = check["candidates"][0]["quantities"];
    const json wrong_by_standing = quantity_of(quantities, "class")["wrong_by_standing"];
    const std::uint64_t wrong = quantity_of(quantities, "class")["wrong"];
    const std::uint64_t measured = quantity_of(quantities, "parameter")["cases"];
    const Written written(arguments + " --what error", ".png", exit_code);
    const json error = written.report()["error"];
    for (const auto& [standing, pixels] : wrong_by_standing.items()) {
      EXPECT_EQ(error["wrong"][standing]["pixels"], pixels) << standing;
    }
    EXPECT_EQ(wrong_by_standing["defect"] > 0, exit_code == 1);
    std::map<std::string, std::uint64_t> by_colour;
    for (const auto& colour : written.picture().pixels) {
      char text[7];
      std::snprintf(text, sizeof text, "%02x%02x%02x", unsigned{colour[0]}, unsigned{colour[1]},
                    unsigned{colour[2]});
      ++by_colour[text];
    }
    std::uint64_t wrong_pixels = 0;
    for (const auto& [standing, those] : error["wrong"].items()) {
      EXPECT_EQ(by_colour[those["colour"].get<std::string>()], those["pixels"]) << standing;
      wrong_pixels += those["pixels"].get<std::uint64_t>();
    }
    EXPECT_EQ(wrong_pixels, wrong);
    std::uint64_t sum = 0;
    for (const json& step : error["steps"]) {
      EXPECT_EQ(by_colour[step["colour"].get<std::string>()], step["pixels"]);
      sum += step["pixels"].get<std::uint64_t>();
    }
    EXPECT_EQ(sum, measured);
    EXPECT_GT(measured, 50u);
    // The textbook loses s; the other method does not (docs/scenes.md).
    EXPECT_EQ(error["steps"].back()["pixels"] > 0, exit_code == 1);
    EXPECT_EQ(error["steps"][0]["pixels"] > 0, exit_code == 0);
  }
}

TEST(Image, does_not_depend_on_the_number_of_threads) {
  const std::string sizes[] = {" --size 333,1100 --what ", " --size 30,1200 --what "};
  for (const char* what : {"sphere", "error"}) {
    const std::string asked =
        example("ten-spheres.toml") + sizes[what == std::string("error")] + what + " --threads ";
    const Written one(asked + "1", ".png");
    EXPECT_TRUE(Written(asked + "3", ".png").picture() == one.picture()) << what;
  }
}

TEST(Image, does_not_depend_on_the_bands) {
  // 4200 rows of 17 pixels are two bands, and so are 17 rows of 4200 pixels.
  for (const char* size : {"17,4200", "4200,17"}) {
    scene::Scene scene = scene::load_scene(example("ten-spheres.toml")).scene;
    const Written written(example("ten-spheres.toml") + " --size " + size, ".ppm");
    scene.camera->width = written.picture().width;
    scene.camera->height = written.picture().height;
    std::size_t hits = 0;
    for (const Seen& seen : all_seen(scene)) {
      hits += seen.sphere ? 1 : 0;
      ASSERT_EQ(written.picture().at(seen.column, seen.line) != kBackground,
                seen.sphere.has_value())
          << seen.column << " " << seen.line;
    }
    EXPECT_GT(hits, 20000u);
  }
}

/// The number of files of unfinished pictures that have at least this many bytes.
std::size_t parts_left(std::uintmax_t least_bytes = 0) {
  std::size_t left = 0;
  for (const auto& entry : fs::directory_iterator(testing::TempDir())) {
    const std::string name = entry.path().filename().string();
    if (name.find("raycheck_" + std::to_string(getpid())) == 0 && name.ends_with(".part") &&
        entry.file_size() >= least_bytes) {
      ++left;
    }
  }
  return left;
}

TEST(Image, keeps_an_older_picture_when_interrupted) {
  const std::string path = temporary_file("interrupted.png", "an older picture");
  const Outcome result = run_interrupted(
      "image " + example("ten-spheres.toml") + " --size 100000,100000 --out " + path,
      [&] { return parts_left(1) > 0; });
  EXPECT_EQ(result.exit_code, 130) << result.err;
  EXPECT_TRUE(has(result.out, "INTERRUPTED: no picture was written"));
  EXPECT_EQ(contents(path), "an older picture");
  EXPECT_EQ(parts_left(), 0u);
}

TEST(PictureFile, ThrowsOnErrorsOfLibpngAndLeavesNoFile) {
  const std::string path = temporary_file("refused.png", "an older picture");
  const std::size_t before = parts_left();
  {
    tools::PictureFile file("--out", path);
    file.start(3, 4);
    EXPECT_EQ(parts_left(), before + 1);
    expect_parts(thrown_by<std::runtime_error>([&] { file.place(); }), {"libpng: No IDATs"});
  }
  EXPECT_EQ(contents(path), "an older picture");
  EXPECT_EQ(parts_left(), before);
}

TEST(Image, replaces_an_older_picture_and_warns_about_the_scene) {
  const std::string path = temporary_file("new.ppm", "an older picture");
  const std::string scene =
      temporary_file("foggy.txt", contents(example("driver-a.txt")) + "fog 1\n");
  const Outcome result = run("image " + scene + " --dialect A --out " + path, 0);
  expect_parts(result.err, {"warning", "fog: unknown keyword, ignored"});
  EXPECT_TRUE(has(result.out, "wrote " + path));
  EXPECT_EQ(read_picture(path).width, 16);
}

}  // namespace
}  // namespace raycheck::tests
