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
    {"by_row", "pixels row-column", "direction", "pixels = row-column",
     "Ray by_row(const Camera& camera, const Conventions& asked, Pixel pixel) {\n"
     "  return pixel_ray(camera, asked, {pixel.j, pixel.i});\n}\n",
     ".pixel_ray = by_row"},
    {"longer", "made_directions any", "unit-direction", "made_directions = any",
     "Ray longer(const Camera& camera, const Conventions& asked, Pixel pixel) {\n"
     "  const Ray ray = pixel_ray(camera, asked, pixel);\n"
     "  return {ray.origin, out(3 * in(ray.direction))};\n}\n",
     ".pixel_ray = longer"},
    {"cornered", "samples corners", "direction", "samples = corners",
     "Ray cornered(const Camera& camera, const Conventions& asked, Pixel pixel) {\n"
     "  Conventions at = asked;\n  at.samples = Samples::corners;\n"
     "  return pixel_ray(camera, at, pixel);\n}\n",
     ".pixel_ray = cornered"},
    {"across", "spheres diameter", "class", "spheres = diameter",
     "std::optional<Hit> across(const Ray& ray, const Sphere& ball, const Conventions& asked) {\n"
     "  return intersect(ray, {ball.centre, ball.radius / 2}, asked);\n}\n",
     ".intersect = across"},
    {"segment", "rays end; t_max 1", "class", "rays = end",
     "std::optional<Hit> segment(const Ray& ray, const Sphere& ball, const Conventions& asked) {\n"
     "  const Vector3 to = in(ray.direction) - in(ray.origin);\n"
     "  const auto hit = intersect({ray.origin, out(to)}, ball, asked);\n"
     "  return hit && hit->parameter <= 1 ? hit : std::nullopt;\n}\n",
     ".intersect = segment"}};

/// It declares `contract`.
std::string candidate(const Called& called, const std::string& contract) {
  std::string text = contents(RAYCHECK_SOURCE_DIR "/tests/candidates/right.cpp");
  text.resize(text.rfind("RAYCHECK_CANDIDATE("));
  return compiled(temporary_file(called.name + std::to_string(contract.size()) + ".cpp",
                                 text + called.functions + "RAYCHECK_CANDIDATE(" + called.members +
                                     ", .contract = \"" + contract + "\")\n"));
}

Outcome judged_by(const Called& called, const std::string& contract, const std::string& laws) {
  return run("properties --cases 300 " + laws + " --candidate " + candidate(called, contract));
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
    expect_parts(outcome.out,
                 {"right under " + called.says + ", which the candidate does not declare"});
  }
}

/// Plain functions that declare what they do not follow.
TEST(Interfaces, that_are_not_followed_are_broken) {
  Called plain = {"plain", "", "", "", "", ".pixel_ray = pixel_ray, .intersect = intersect"};
  for (const auto& [contract, law, says] :
       {std::tuple("pixels row-column", "direction", "pixels = column-row"),
        {"spheres diameter", "class", "spheres = radius"},
        {"rays end", "class", "rays = direction"}}) {
    plain.name = std::string("plain-") + law;
    const Outcome outcome = judged_by(plain, contract, std::string("--filter ") + law);
    EXPECT_EQ(outcome.exit_code, 1) << contract;
    expect_parts(outcome.out,
                 {std::string("right under ") + says + ", which the candidate does not declare"});
  }
}

/// Code from before there were corners follows edges and centres.
const Called kOlder = {"older",
                       "",
                       "",
                       "",
                       "Ray older(const Camera& camera, const Conventions& asked, Pixel pixel) {\n"
                       "  Conventions at = asked;\n"
                       "  if (asked.samples == Samples::corners) at.samples = Samples::centres;\n"
                       "  return pixel_ray(camera, at, pixel);\n}\n",
                       ".pixel_ray = older"};

TEST(Corners, are_in_random_cases_for_those_who_follow_them) {
  const Outcome unasked = judged_by(kOlder, "", "");
  EXPECT_EQ(unasked.exit_code, 0) << unasked.out;
  for (const char* contract : {"corners as-asked", "samples corners"}) {
    const Outcome asked = judged_by(kOlder, contract, "--filter direction");
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
