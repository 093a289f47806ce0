#include <fmt/core.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <map>
#include <nlohmann/json.hpp>
#include <random>
#include <string>
#include <vector>

#include "scene/scene.h"
#include "tests/tools/program.h"

namespace raycheck::tests {
namespace {

using nlohmann::json;

json explained(const std::string& arguments) {
  const Outcome result = run("explain " + arguments + " --format json");
  EXPECT_TRUE(result.exit_code == 0 || result.exit_code == 1) << result.err;
  return json::parse(result.out);
}

double number(const json& hexfloat) {
  return std::strtod(hexfloat.get<std::string>().c_str(), nullptr);
}

TEST(Explain, reports_the_lecture_s_own_ray) {
  const json report = explained("--ray 1,1,3,4,3,0 --sphere 5,5,5,3");
  EXPECT_EQ(report["exact"]["class"], "hit");
  EXPECT_EQ(report["exact"]["closed_form"], "-1/25*sqrt(109) + 28/25");
  EXPECT_NEAR(number(report["exact"]["s"]), (28 - std::sqrt(109.0)) / 25, 1e-15);
  EXPECT_NE(report.dump().find("-1/5*sqrt(109) + 28/5"), std::string::npos);
  EXPECT_NE(report.dump().find("-4/25*sqrt(109) + 137/25"), std::string::npos);
  ASSERT_EQ(report["methods"].size(), 13u);
  for (const json& method : report["methods"]) {
    if (method["name"].get<std::string>().rfind("single", 0) == 0) continue;
    EXPECT_TRUE(method.at("hit").get<bool>());
    EXPECT_FALSE(method.at("class_error").get<bool>());
    EXPECT_LT(method.at("ulp_error").get<double>(), 4);
    EXPECT_NEAR(number(method.at("s")), number(report["exact"]["s"]), 1e-14);
  }
}

TEST(Explain, shows_the_conditioning_of_each_step) {
  const json report =
      json::parse(run("explain --ray -5,0.5,0,1,0,0 --sphere 0,0,0,1 --format json").out);
  for (const json& step : report["exact"]["steps"]) {
    if (step["symbol"] != "s") continue;
    // By implicit differentiation of |L + s d - C|^2 = r^2: with q = L + s d - C = (-sqrt(3)/2,
    // 1/2) and s = 5 - sqrt(3)/2 it is (|q_x| (5 + s) + |q_y| / 2 + 1) / (s |q_x|).
    const double x = std::sqrt(0.75);
    const double s = 5 - x;
    EXPECT_NEAR(step["condition"].get<double>(), (x * (5 + s) + 0.25 + 1) / (s * x), 5e-3);
    EXPECT_GT(step["condition_alone"].get<double>(), 1);
    return;
  }
  ADD_FAILURE() << "no step s";
}

TEST(Explain, reports_the_step_at_which_the_textbook_goes_wrong) {
  const Outcome result =
      run("explain --ray 0,1.7,0,1,-0.0007305260126504702,0 --sphere "
          "0,-6371000,0,6371000 --format json");
  EXPECT_EQ(result.exit_code, 0);
  const json report = json::parse(result.out);
  EXPECT_EQ(number(report["exact"]["s"]), 4654.1799293292679);
  for (const json& method : report["methods"]) {
    if (method["name"] == "quadratic") {
      EXPECT_EQ(method["goes_wrong_at"], "d^2");
      EXPECT_EQ(method["standing"], "excused");  // a planet that is 3 u smaller is missed
    }
  }
  const Outcome far = run("explain --ray -1e9,0.5,0,1,0,0 --sphere 0,0,0,1 --format json");
  EXPECT_EQ(far.exit_code, 1);
  const json of_far = json::parse(far.out);
  for (const json& method : of_far["methods"]) {
    if (method["name"] == "quadratic") {
      EXPECT_EQ(method["standing"], "defect");
    }
    // What L + s D cancels is the question's fault: of 4e8 u of Q cross, whose s is right, has
    // none.
    if (method["name"] == "cross") {
      EXPECT_EQ(method["goes_wrong_at"], nullptr);
    }
  }
  // 10^8 radii away is more than is judged in floats, and no defect of theirs.
  const json floats = explained("scene/examples/far-sphere.toml --pixel 2,1");
  for (const json& method : floats["methods"]) {
    if (method["name"] == "single-quadratic") {
      EXPECT_EQ(method["goes_wrong_at"], "v");
      EXPECT_EQ(method["standing"], "not judged");
    }
    if (method["name"] == "quadratic") {
      EXPECT_EQ(method["standing"], "defect");
    }
  }
}

TEST(Explain, reports_a_pixel_of_the_lecture) {
  const json exact = explained("scene/examples/optical-axis.toml --pixel 0,0").at("exact");
  const std::vector<double> point = {-12, 28, 70};
  for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(number(exact["pixel_point"][k]), point[k]);
  EXPECT_EQ(exact["closed_form"]["direction"],
            json({"-2/17*sqrt(17)", "2/17*sqrt(17)", "-3/17*sqrt(17)"}));
  EXPECT_EQ(exact["closed_form"]["U"], json({"1", "0", "0"}));
  EXPECT_EQ(exact["U"].size(), 3u);
  EXPECT_EQ(exact["V"].size(), 3u);
  EXPECT_EQ(exact["W"].size(), 3u);
  EXPECT_NEAR(number(exact["direction"][2]), -3 / std::sqrt(17.0), 1e-15);
  ASSERT_EQ(exact["spheres"].size(), 1u);
  EXPECT_EQ(exact["spheres"][0]["class"], "miss");
  EXPECT_TRUE(exact["nearest"].is_null());
  const json centre = explained("scene/examples/optical-axis.toml --pixel 1,1").at("exact");
  EXPECT_EQ(centre["spheres"][0]["class"], "hit");
  EXPECT_EQ(centre["nearest"], 0);
  EXPECT_TRUE(centre["spheres"][0]["s"].is_string());
  EXPECT_EQ(centre["spheres"][0]["point"].size(), 3u);
}

/// Rays to the unit sphere from all distances, past its edge and through it, in any direction.
std::vector<scene::Ray> rays_from_everywhere(std::size_t count) {
  std::mt19937_64 generator(1);
  const auto uniform = [&](double from, double to) {
    return std::uniform_real_distribution<double>(from, to)(generator);
  };
  std::vector<scene::Ray> rays;
  for (std::size_t k = 0; k < count; ++k) {
    const double distance = std::pow(10, uniform(0, 12));
    const double height =
        k % 3 == 0 ? uniform(0, 1.2) : 1 + (k % 3 == 1 ? -1 : 1) * std::pow(10, uniform(-16, -1));
    const double turn = uniform(0, 6.28), length = std::pow(10, uniform(-5, 5));
    const double c = std::cos(turn), s = std::sin(turn);
    rays.push_back(
        {{height * c - distance * s, height * s + distance * c, 0}, {length * s, -length * c, 0}});
  }
  return rays;
}

TEST(ExplainAndCheck, call_the_same_answers_wrong) {
  const auto triple = [](const auto& v) { return fmt::format("{},{},{}", v.x, v.y, v.z); };
  const std::vector<scene::Ray> rays = rays_from_everywhere(24);
  std::string toml = "[[sphere]]\ncentre = [0, 0, 0]\nradius = 1\n";
  for (const scene::Ray& ray : rays) {
    toml += fmt::format("[[ray]]\norigin = [{}]\ndirection = [{}]\n", triple(ray.origin),
                        triple(ray.direction));
  }
  const std::string path = temporary_file("rays.toml", toml);
  // Of each method: rays whose answers are wrong, and what the worst of these come to.
  std::map<std::string, std::map<std::size_t, std::string>> wrong;
  for (const char* method : {"quadratic", "lecture", "kahan", "perpendicular", "cross", "robust"}) {
    const Outcome checked =
        run(fmt::format("check {} --intersect {} --top 1000 --format json", path, method));
    auto& of_method = wrong[method];
    const json report = json::parse(checked.out);
    for (const json& one : report["candidates"][0]["worst"]) {
      const std::string law = one["law"];
      if (law != "class" && law != "nearest-root" && law != "parameter" && law != "hit-point") {
        continue;
      }
      if (law == "hit-point" && one["quantity"] != "hit point")
        continue;  // explain has no residual
      std::string& standing = of_method[one["ray"]];
      if (standing != "defect") standing = one["standing"];
    }
  }
  EXPECT_GT(wrong["quadratic"].size(), 4);
  EXPECT_EQ(wrong["robust"].size(), 0);
  for (std::size_t k = 0; k < rays.size(); ++k) {
    const json report = explained(fmt::format("--ray={},{} --sphere 0,0,0,1",
                                              triple(rays[k].origin), triple(rays[k].direction)));
    for (const json& method : report["methods"]) {
      const auto found = wrong.find(method["name"]);
      if (found == wrong.end()) continue;
      const auto known = found->second.find(k);
      const json expected = known == found->second.end() ? json(nullptr) : json(known->second);
      EXPECT_EQ(method["standing"], expected) << method["name"] << " on ray " << k;
    }
  }
}

TEST(Explain, fails_with_2_and_says_why) {
  const auto fails = [](const std::string& arguments, const std::string& why) {
    const Outcome result = run("explain " + arguments);
    EXPECT_EQ(result.exit_code, 2) << arguments;
    EXPECT_NE(result.err.find(why), std::string::npos) << arguments << "\n" << result.err;
  };
  fails("", "--pixel");
  fails("--ray 1,2,3", "--sphere");
  fails("--ray 1,2,3 --sphere 0,0,0,1", "6 numbers");
  fails("--ray 1,2,3,4,5,x --sphere 0,0,0,1", "'x' is not a number");
  fails("--ray 0,0,0,0,0,0 --sphere 0,0,0,1", "direction");
  fails("--ray 0,0,0,1,0,0 --sphere 0,0,0,-1", "radius");
  fails("--ray 0,0,0,1,0,inf --sphere 0,0,0,1", "direction");
  fails("scene/examples/optical-axis.toml --pixel 3,0", "--pixel 3,0: scene");
  fails("scene/examples/optical-axis.toml --pixel 0,0 --sphere 9",
        "sphere 9: the scene's spheres are numbered 0 to 0");
  fails("scene/examples/lecture-examples.toml --pixel 0,0", "no camera");
}

}  // namespace
}  // namespace raycheck::tests
