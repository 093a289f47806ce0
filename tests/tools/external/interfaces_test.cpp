// Candidates that are called, or answer, in another way than raycheck's laws do.

#include "properties/interfaces.h"

#include "tests/tools/external/judged.h"

namespace raycheck::tests {
namespace {

/// A way of being called, the law that breaks if it is not declared, and right.cpp called so.
struct Called {
  std::string name, contract, law, says, functions, members;
};
const std::vector<Called> kCalled = {
    {"by_row", "pixels row-column", "direction", "right under pixels = row-column",
     "Ray by_row(const Camera& camera, const Conventions& asked, Pixel pixel) {\n"
     "  return pixel_ray(camera, asked, {pixel.j, pixel.i});\n}\n",
     ".pixel_ray = by_row"},
    {"longer", "made_directions any", "unit-direction", "right under made_directions = any",
     "Ray longer(const Camera& camera, const Conventions& asked, Pixel pixel) {\n"
     "  const Ray ray = pixel_ray(camera, asked, pixel);\n"
     "  return {ray.origin, out(3 * in(ray.direction))};\n}\n",
     ".pixel_ray = longer"},
    {"to_plane", "made_directions image-plane", "unit-direction",
     "right under made_directions = any",
     "Ray to_plane(const Camera& camera, const Conventions& asked, Pixel pixel) {\n"
     "  return {camera.eye, out(sight(camera, asked, pixel))};\n}\n",
     ".focal_ray = to_plane"},
    {"about", "placement origin", "class", "the centre is left out",
     "std::optional<Hit> about(const Ray& ray, const Sphere& ball, const Conventions& asked) {\n"
     "  return intersect(ray, {{}, ball.radius}, asked);\n}\n",
     ".intersect = about"},
    {"unit", "placement unit", "class", "",
     "std::optional<Hit> unit(const Ray& ray, const Sphere&, const Conventions& asked) {\n"
     "  return intersect(ray, {{}, 1}, asked);\n}\n",
     ".intersect = unit"},
    {"along", "view direction", "direction", "right under view = direction",
     "Ray along(const Camera& camera, const Conventions& asked, Pixel pixel) {\n"
     "  Camera it = camera;\n"
     "  it.look_at = out(in(camera.eye) + in(camera.look_at));\n"
     "  return pixel_ray(it, asked, pixel);\n}\n"
     "Frame frame_along(const Camera& camera) {\n"
     "  Camera it = camera;\n"
     "  it.look_at = out(in(camera.eye) + in(camera.look_at));\n"
     "  return frame(it);\n}\n",
     ".frame = frame_along, .pixel_ray = along"},
    {"by_angle", "windows symmetric", "direction",
     "the image plane is taken to be centred: half its height is top, half its width "
     "top (right - left)/(top - bottom)",
     "Ray by_angle(const Camera& camera, const Conventions& asked, Pixel pixel) {\n"
     "  Camera it = camera;\n"
     "  const double angle = 2 * std::atan(camera.top / std::abs(camera.near_plane));\n"
     "  it.near_plane = -1;\n"
     "  it.top = std::tan(angle / 2);\n"
     "  it.right = it.top * ((camera.right - camera.left) / (camera.top - camera.bottom));\n"
     "  it.bottom = -it.top, it.left = -it.right;\n"
     "  return focal_ray(it, asked, pixel);\n}\n",
     ".focal_ray = by_angle"},
    {"square", "windows square-pixels", "direction",
     "the image plane is taken to be centred: half its height is top, half its width top w/h",
     "Ray square(const Camera& camera, const Conventions& asked, Pixel pixel) {\n"
     "  Camera it = camera;\n"
     "  it.right = it.top * static_cast<double>(it.width) / static_cast<double>(it.height);\n"
     "  it.bottom = -it.top, it.left = -it.right;\n"
     "  return focal_ray(it, asked, pixel);\n}\n",
     ".focal_ray = square"},
    {"cornered", "samples corners", "direction", "right under samples = corners",
     "Ray cornered(const Camera& camera, const Conventions& asked, Pixel pixel) {\n"
     "  Conventions at = asked;\n  at.samples = Samples::corners;\n"
     "  return pixel_ray(camera, at, pixel);\n}\n",
     ".pixel_ray = cornered"},
    {"across", "spheres diameter", "class", "right under spheres = diameter",
     "std::optional<Hit> across(const Ray& ray, const Sphere& ball, const Conventions& asked) {\n"
     "  return intersect(ray, {ball.centre, ball.radius / 2}, asked);\n}\n",
     ".intersect = across"},
    {"segment", "rays end; t_max 1", "class", "right under rays = end",
     "std::optional<Hit> segment(const Ray& ray, const Sphere& ball, const Conventions& asked) {\n"
     "  const Vector3 to = in(ray.direction) - in(ray.origin);\n"
     "  const auto hit = intersect({ray.origin, out(to)}, ball, asked);\n"
     "  return hit && hit->parameter <= 1 ? hit : std::nullopt;\n}\n",
     ".intersect = segment"},
    {"solid", "from_inside start", "nearest-root", "from_inside = start",
     "std::optional<Hit> solid(const Ray& ray, const Sphere& ball, const Conventions& asked) {\n"
     "  if ((in(ray.origin) - in(ball.centre)).norm() <= ball.radius) return Hit{0, ray.origin};\n"
     "  return intersect(ray, ball, asked);\n}\n",
     ".intersect = solid"},
    {"behind", "from_inside near-root", "nearest-root", "from_inside = near-root",
     "std::optional<Hit> behind(const Ray& ray, const Sphere& ball, const Conventions& asked) {\n"
     "  const Vector3 to = in(ball.centre) - in(ray.origin), d = in(ray.direction);\n"
     "  if (to.norm() > ball.radius) return intersect(ray, ball, asked);\n"
     "  const double a = d.squaredNorm(), r = ball.radius;\n"
     "  const double under_root = std::max(0.0, a * r * r - to.cross(d).squaredNorm());\n"
     "  const double s = (to.dot(d) - std::sqrt(under_root)) / a;\n"
     "  return Hit{s, out(in(ray.origin) + s * d)};\n}\n",
     ".intersect = behind"},
    {"inner", "from_inside start; t_max 1", "class", "from_inside = start",
     "std::optional<Hit> inner(const Ray& ray, const Sphere& ball, const Conventions& asked) {\n"
     "  if ((in(ray.origin) - in(ball.centre)).norm() <= ball.radius) return Hit{0, ray.origin};\n"
     "  const auto hit = intersect(ray, ball, asked);\n"
     "  return hit && hit->parameter <= 1 ? hit : std::nullopt;\n}\n",
     ".intersect = inner"}};

/// Those of single tests: plain functions; half of the way to the image plane; from
/// before there were corners, so that it follows edges and centres; and with both roots, the other
/// of which is off by a factor.
const std::vector<Called> kSingle = {
    {"plain", "", "", "", "", ".pixel_ray = pixel_ray, .intersect = intersect"},
    {"half", "", "", "",
     "Ray half(const Camera& camera, const Conventions& asked, Pixel pixel) {\n"
     "  return {camera.eye, out(0.5 * sight(camera, asked, pixel))};\n}\n",
     ".focal_ray = half"},
    {"older", "", "", "",
     "Ray older(const Camera& camera, const Conventions& asked, Pixel pixel) {\n"
     "  Conventions at = asked;\n"
     "  if (asked.samples == Samples::corners) at.samples = Samples::centres;\n"
     "  return pixel_ray(camera, at, pixel);\n}\n",
     ".pixel_ray = older"},
    {"both", "", "", "",
     "template <int kOff>\n"
     "std::optional<Hit> both(const Ray& ray, const Sphere& ball, const Conventions&) {\n"
     "  const Vector3 origin = in(ray.origin), d = in(ray.direction);\n"
     "  const Vector3 to = in(ball.centre) - origin;\n"
     "  const double a = d.squaredNorm(), b = to.dot(d), r = ball.radius;\n"
     "  const double discriminant = a * r * r - to.cross(d).squaredNorm();\n"
     "  if (discriminant < 0) return {};\n"
     "  const double q = b + std::copysign(std::sqrt(discriminant), b);\n"
     "  const double length = to.norm();\n"
     "  const double one = q / a, other = q == 0 ? 0 : (length - r) * (length + r) / q;\n"
     "  return Hit{std::min(one, other), {(1 + kOff * 1e-9) * std::max(one, other), 0, 0}};\n}\n",
     ".tangent = Tangent::hit, .intersect = both<0>, .returns = Returns::roots"},
    {"both_off", "", "", "", "",
     ".tangent = Tangent::hit, .intersect = both<1>, .returns = Returns::roots"}};

/// All of them in one library, from right.cpp without its last statement.
std::string source_of_all() {
  std::string text = contents(RAYCHECK_SOURCE_DIR "/tests/candidates/right.cpp"), offers;
  text.resize(text.rfind("RAYCHECK_CANDIDATE("));
  for (const std::vector<Called>& some : {kCalled, kSingle}) {
    for (const Called& called : some) {
      text += called.functions;
      offers += "  if (is_chosen(\"" + called.name + "\")) return raycheck::detail::offer({" +
                called.members + ", .contract = contract_of()});\n";
    }
  }
  return kChoice + text +
         "extern \"C\" const raycheck_candidate* raycheck_candidate_functions(void) {\n" + offers +
         "  return nullptr;\n}\n";
}

std::string candidate(const Called& called, const std::string& contract) {
  static const std::string all = compiled(temporary_file("called.cpp", source_of_all()));
  return chosen(all, called.name, contract);
}

const Called& single(const std::string& name) {
  return *std::ranges::find(kSingle, name, &Called::name);
}

Outcome judged_by(const Called& called, const std::string& contract, const std::string& laws) {
  return run("properties --cases 140 " + laws + " --candidate " + candidate(called, contract));
}

TEST(Interfaces, are_right_as_declared) {
  for (const Called& called : kCalled) {
    const Outcome outcome = judged_by(called, called.contract, "--level demanding");
    EXPECT_EQ(outcome.exit_code, 0) << called.name << outcome.out << outcome.err;
  }
}

TEST(Interfaces, that_are_not_declared_are_named) {
  for (const Called& called : kCalled) {
    const bool limits = called.contract.find(';') != std::string::npos;
    const Outcome outcome = judged_by(called, limits ? "t_max 1" : "",
                                      "--filter " + called.law + (limits ? " --source rays" : ""));
    EXPECT_EQ(outcome.exit_code, 1) << called.name;
    expect_parts(outcome.out, {called.says});
  }
}

TEST(Interfaces, of_segments_without_a_largest_s_are_told_so) {
  const auto segment = std::ranges::find(kCalled, "segment", &Called::name);
  const Outcome outcome = judged_by(*segment, "rays end", "--filter class --source rays");
  EXPECT_EQ(outcome.exit_code, 1);
  expect_parts(outcome.out, {"right under t_max = 1, which the candidate does not declare"});
}

/// Plain functions that declare what they do not follow.
TEST(Interfaces, that_are_not_followed_are_broken) {
  for (const auto& [contract, law, says] :
       {std::tuple("pixels row-column", "direction", "pixels = column-row"),
        {"spheres diameter", "class", "spheres = radius"},
        {"view direction", "direction", "view = look-at"},
        {"from_inside start", "nearest-root", "from_inside = root"},
        {"from_inside near-root", "nearest-root", "from_inside = root"},
        {"rays end", "class", "rays = direction"}}) {
    const Outcome outcome = judged_by(single("plain"), contract, std::string("--filter ") + law);
    EXPECT_EQ(outcome.exit_code, 1) << contract;
    expect_parts(outcome.out,
                 {std::string("right under ") + says + ", which the candidate does not declare"});
  }
}

TEST(Corners, are_in_random_cases_for_those_who_follow_them) {
  const Outcome unasked = judged_by(single("older"), "", "");
  EXPECT_EQ(unasked.exit_code, 0) << unasked.out;
  for (const char* contract : {"corners as-asked", "samples corners"}) {
    const Outcome asked = judged_by(single("older"), contract, "--filter direction");
    EXPECT_EQ(asked.exit_code, 1) << asked.out;
    // Right answers under edges contradict "at their centres", and no other contract is named.
    EXPECT_EQ(asked.out.find("right under"), std::string::npos) << asked.out;
    EXPECT_EQ(has(asked.out, "pixels are sampled at their centres"), contract[0] == 's');
  }
}

TEST(Interfaces, of_segments_have_ends_that_are_doubles) {
  using properties::passed;
  const contract::Interface segments = {.rays = contract::RayForm::kEnd};
  const auto rounded = [](const scene::Ray& ray, scene::Precision precision) {
    return properties::rounded_ray(ray, {precision, {.rays = contract::RayForm::kEnd}});
  };
  const scene::Ray given = {{0.1, -1e3, 3}, {1.7, 1e-3, 1e20}};
  for (const auto precision : {scene::Precision::kDouble, scene::Precision::kSingle}) {
    const scene::Ray ray = rounded(given, precision);
    EXPECT_EQ(rounded(ray, precision), ray);
    const scene::Ray end = passed(ray, segments);  // throws if an end is not a double
    EXPECT_EQ(scene::rounded_to(precision, end.direction.x), end.direction.x);
    EXPECT_NEAR(ray.direction.x, 1.7, 1e-6);
    EXPECT_NEAR(ray.direction.y, 1e-3, 1e-4);
  }
  EXPECT_THROW(passed(given, segments), properties::CannotBeSaid);
  const scene::Ray exact = {{1, 2, 3}, {0.5, -2, 0}};
  EXPECT_EQ(rounded(exact, scene::Precision::kDouble), exact);
  EXPECT_EQ(passed(exact, segments).direction, (scene::Vector3{1.5, 0, 3}));
}

/// A ball that reaches the x axis only if its diameter is taken for its radius.
TEST(Interfaces, are_declared_in_every_language) {
  const std::string folder = temporary_folder("languages");
  const auto file = [&](const std::string& name, const std::string& text) {
    std::ofstream(folder + "/" + name) << text;
    return folder + "/" + name;
  };
  for (const char* name : {"raycheck_candidate.mjs", "RaycheckCandidate.java"}) {
    std::filesystem::copy_file(RAYCHECK_SOURCE_DIR "/tools/external/adapters/" + std::string(name),
                               folder + "/" + name);
  }
  const std::string scene = file("balls.toml",
                                 "[[ray]]\norigin = [0, 0, 0]\ndirection = [1, 0, 0]\n"
                                 "[[sphere]]\ncentre = [5, 0, 0]\nradius = 2\n"
                                 "[[sphere]]\ncentre = [5, 3.5, 0]\nradius = 2\n");
  std::vector<std::string> candidates = {
      "source:" + file("it.c",
                       "#include <raycheck/candidate.h>\n"
                       "static raycheck_hit meets(const raycheck_ray* ray, const raycheck_sphere* "
                       "ball,\n    const raycheck_conventions* asked) {\n"
                       "  raycheck_hit hit = {2 * ball->centre.y <= ball->radius};\n"
                       "  (void)ray, (void)asked;\n  return hit;\n}\n"
                       "const raycheck_candidate* raycheck_candidate_functions(void) {\n"
                       "  static raycheck_candidate it;\n"
                       "  it.version = RAYCHECK_CANDIDATE_VERSION;\n  it.intersect = meets;\n"
                       "  it.contract = \"spheres diameter; returns class\";\n"
                       "  return &it;\n}\n"),
      "source:" + file("it.cpp",
                       "#include <raycheck/candidate.hpp>\nusing namespace raycheck;\n"
                       "std::optional<Hit> meets(const Ray&, const Sphere& ball, const "
                       "Conventions&) {\n"
                       "  if (2 * ball.centre.y > ball.radius) return {};\n"
                       "  return Hit{};\n}\n"
                       "RAYCHECK_CANDIDATE(.intersect = meets,\n"
                       "                   .contract = \"spheres diameter; returns class\")\n"),
      "command:python3 " +
          file("it.py",
               "import raycheck_candidate as rc\nrc.run('it', spheres='diameter', "
               "returns='class',\n"
               "  intersect=lambda ray, ball, asked: 2 * ball[0][1] <= ball[1])\n")};
  if (is_installed("node")) {
    candidates.push_back(
        "command:node " +
        file("it.mjs",
             "import { run } from './raycheck_candidate.mjs';\n"
             "run('it', { spheres: 'diameter', returns: 'class',\n"
             "  intersect: (ray, ball) => 2 * ball.centre[1] <= ball.radius });\n"));
  }
  if (is_installed("javac")) {
    file("It.java",
         "public class It extends RaycheckCandidate {\n"
         "  @Override public java.util.List<String> declared() {\n"
         "    return java.util.List.of(\"spheres diameter\", \"returns class\");\n  }\n"
         "  @Override public Hit intersect(Ray ray, Sphere ball, Conventions asked) {\n"
         "    return 2 * ball.centre().y() <= ball.radius() ? new Hit(0, ray.origin()) : null;\n"
         "  }\n"
         "  public static void main(String[] all) throws java.io.IOException {\n"
         "    new It().run(\"it\");\n  }\n}\n");
    const std::string words = "cd " + folder + " && javac RaycheckCandidate.java It.java";
    ASSERT_EQ(std::system(words.c_str()), 0);
    candidates.push_back("command:java -cp " + folder + " It");
  }
  for (const std::string& one : candidates) {
    const json report = judged(scene, one);
    EXPECT_EQ(report["discrepancies"], 0) << one << report.dump(2);
    EXPECT_EQ(report["quantities"][0]["cases"], 2) << one << report.dump(2);
  }
}

/// Both roots are judged, also the one that does not count.
TEST(Interfaces, that_return_both_roots_must_be_right_in_both) {
  for (const auto& [name, exit_code] : {std::pair("both", 0), {"both_off", 1}}) {
    for (const char* contract : {"", "t_min 1e-3; t_max 1e9; culling front-faces"}) {
      const Outcome outcome = judged_by(single(name), contract, "");
      EXPECT_EQ(outcome.exit_code, exit_code) << contract << outcome.out << outcome.err;
      if (exit_code != 0 && *contract == 0) expect_parts(outcome.out, {"the other root"});
    }
  }
}

/// s = 1 is on the image plane: half of P - E is another direction, although of the same line.
TEST(Interfaces, of_directions_to_the_image_plane_have_its_length) {
  const Called half = single("half");
  EXPECT_EQ(judged_by(half, "made_directions any", "--filter direction").exit_code, 0);
  const Outcome outcome = judged_by(half, "made_directions image-plane", "--filter pixel-point");
  EXPECT_EQ(outcome.exit_code, 1);
  expect_parts(outcome.out, {"pixel-point"});
}

TEST(Interfaces, of_fields_of_view_have_windows_that_follow_from_them) {
  for (const auto precision : {scene::Precision::kDouble, scene::Precision::kSingle}) {
    for (const auto windows : {contract::Windows::kSymmetric, contract::Windows::kSquarePixels}) {
      const properties::InputFormat format = {precision, {.windows = windows}};
      scene::Scene scene;
      scene.camera = {{}, {0, 0, -1}, {0, 1, 0}, 0.1, {}, -0.3, 0.1, -0.2, 0.9, 641, 479};
      EXPECT_FALSE(properties::is_of_format(scene, format));
      const auto rounded = properties::rounded_case({scene, {{1, 2}}}, format);
      ASSERT_TRUE(rounded.the_case && has(rounded.replaced, "symmetric windows"));
      const scene::Camera camera = *rounded.the_case->scene.camera;
      EXPECT_TRUE(properties::is_of_format(rounded.the_case->scene, format));
      EXPECT_TRUE(camera.near < 0 && camera.left < 0 && camera.bottom < 0);
      EXPECT_TRUE(camera.left == -camera.right && camera.bottom == -camera.top);
      EXPECT_LE(std::max(camera.right, camera.top), -8 * camera.near);
      EXPECT_NEAR(camera.top, 0.9, 1e-3);
      if (windows == contract::Windows::kSquarePixels) {
        EXPECT_EQ(camera.right * 479, camera.top * 641);
      }
      // A scene that a user gives is not replaced.
      EXPECT_TRUE(has(properties::rounded_scene(scene, format).reason, "accepts only symmetric"));
      // One that the candidate accepts is only rounded: in floats, 0.45 * 40 is not 0.3 * 60.
      scene.camera = {{}, {0, 0, -1}, {0, 1, 0}, -1, {}, -0.45, 0.45, -0.3, 0.3, 60, 40};
      const auto accepted = properties::rounded_scene(scene, format);
      ASSERT_TRUE(accepted.the_case) << accepted.reason;
      EXPECT_TRUE(properties::is_of_format(accepted.the_case->scene, format));
    }
  }
}

/// Code in floats receives its own rays again: they must be floats.
TEST(Interfaces, of_any_length_give_unit_directions_of_the_format) {
  const contract::Interface any = {.made = contract::MadeLength::kAny};
  for (const auto precision : {scene::Precision::kDouble, scene::Precision::kSingle}) {
    const auto [x, y, z] = properties::made({{}, {3, 1, 7}}, any, precision).direction;
    for (const double one : {x, y, z}) EXPECT_EQ(scene::rounded_to(precision, one), one);
    EXPECT_NEAR(x * x + y * y + z * z, 1, 4 * scene::unit_roundoff(precision));
    EXPECT_NEAR(z / x, 7.0 / 3, 1e-6);
  }
}

}  // namespace
}  // namespace raycheck::tests
