#include <fmt/core.h>

#include "scene/scene.h"
#include "tests/tools/program.h"

namespace raycheck::tests {
namespace {

json explained(const std::string& arguments) { return printed_json("explain " + arguments); }

TEST(Explain, shows_the_conditioning_of_each_step) {
  const json report = explained("--ray -5,0.5,0,1,0,0 --sphere 0,0,0,1");
  const json& step = found(report["exact"]["steps"], "symbol", "s");
  ASSERT_FALSE(step.is_null());
  // kappa by implicit differentiation of |L + s d - C|^2 = r^2. With q = L + s d - C = (-sqrt(3)/2,
  // 1/2) and s = 5 - sqrt(3)/2, it is (|q_x| (5 + s) + |q_y| / 2 + 1) / (s |q_x|).
  const double x = std::sqrt(0.75), s = 5 - x;
  EXPECT_NEAR(step["condition"].get<double>(), (x * (5 + s) + 0.25 + 1) / (s * x), 5e-3);
  EXPECT_GT(step["condition_alone"].get<double>(), 1);
}

TEST(Explain, reports_the_step_at_which_the_textbook_goes_wrong) {
  const json horizon = printed_json(
      "explain --ray 0,1.7,0,1,-0.0007305260126504702,0 --sphere 0,-6371000,0,6371000", 0);
  EXPECT_EQ(number(horizon["exact"]["s"]), 4654.1799293292679);
  const json far = printed_json("explain --ray -1e9,0.5,0,1,0,0 --sphere 0,0,0,1", 1);
  const json floats = explained("scene/examples/far-sphere.toml --pixel 2,1");
  // At an exact tangent, s has no condition number; its error is measured by the backward error.
  const json tangent =
      printed_json("explain --ray 0,0,0,1,2,2 --sphere 41941071,83879142,83876142,3000", 1);
  const auto expect = [](const json& report, const char* name, const json& step,
                         const json& standing) {
    int found = 0;
    for (const json& method : report["methods"]) {
      if (method["name"] != name) continue;
      EXPECT_EQ(method["goes_wrong_at"], step) << name;
      EXPECT_EQ(method["standing"], standing) << name;
      ++found;
    }
    EXPECT_EQ(found, 1) << name;
  };
  expect(horizon, "quadratic", "d^2", "excused");  // a planet that is 3 u smaller is missed
  expect(far, "quadratic", "d^2", "defect");
  expect(tangent, "quadratic", "d^2", "defect");
  expect(tangent, "lecture", nullptr, nullptr);
  // L + s D cancels, so Q of cross is off by 4e8 u. But s is right, so nothing goes wrong.
  expect(far, "cross", nullptr, nullptr);
  // In floats, 10^8 radii away is outside the judged domain, so this is not a defect.
  expect(floats, "single-quadratic", "v", "not judged");
  expect(floats, "quadratic", "d^2", "defect");
}

/// Rays from all distances, in all directions, that pass the unit sphere near its edge or go
/// through it.
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

TEST(ExplainAndCheck, find_the_same_wrong_answers) {
  const auto triple = [](const auto& v) { return fmt::format("{},{},{}", v.x, v.y, v.z); };
  const std::vector<scene::Ray> rays = rays_from_everywhere(24);
  std::string toml = sphere_text("0, 0, 0", "1");
  for (const scene::Ray& ray : rays) {
    toml += ray_text(triple(ray.origin), triple(ray.direction));
  }
  const std::string path = temporary_file("rays.toml", toml);
  // For each method: the number of rays with wrong answers, and the verdicts on the worst.
  std::map<std::string, std::map<std::size_t, std::string>> wrong;
  for (const char* method : {"quadratic", "lecture", "kahan", "perpendicular", "cross", "robust"}) {
    auto& of_method = wrong[method];
    const json report =
        printed_json(fmt::format("check {} --intersect {} --top 1000", path, method));
    for (const json& one : report["candidates"][0]["worst"]) {
      const std::string law = one["law"];
      if (law != "class" && law != "nearest-root" && law != "parameter" && law != "hit-point") {
        continue;
      }
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

}  // namespace
}  // namespace raycheck::tests
