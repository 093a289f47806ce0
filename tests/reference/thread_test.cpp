// Concurrent use, and use under every rounding mode. Compiled with -frounding-math.

#include <cfenv>
#include <thread>

#include "reference/account/closed_form.h"
#include "reference/account/condition.h"
#include "reference/account/nearby_answer.h"
#include "reference/error_measure.h"
#include "tests/reference/random_cases.h"
#include "tests/testing.h"

namespace raycheck::reference {
namespace {

using scene::Sphere;

/// All results of reference/ for one ray and two spheres; doubles as hexfloats.
std::vector<std::string> everything(const ExactCamera& camera, const ExactRay& ray,
                                    const ClosedFormRay& forms, const std::array<Sphere, 2>& pair) {
  std::vector<std::string> said;
  const auto say = [&](double x) { said.push_back(scene::hexfloat(x)); };
  const auto say3 = [&](const auto& v) { said.push_back(spelled(v)); };
  const RoundedFrame frame = camera.rounded_frame();
  say3(frame.U);
  say3(frame.V);
  say3(frame.W);
  say(camera.frame().V.y.lower());
  say(condition_of_frame(camera));
  say3(ray.rounded_pixel_point());
  say3(ray.rounded_origin());
  say3(ray.rounded_direction());
  say(ray.direction(300).x.upper());
  say(condition_of_pixel_point(ray));
  say(condition_of_direction(ray));
  const Enclosure3 exact_direction = ray.direction();
  const scene::UnitVector3 direction = ray.rounded_direction();
  say(angle_error(direction, exact_direction).value);
  say(relative_error(direction, exact_direction).value);
  say(unit_defect(direction).value);
  say(stage_conditions(ray).direction);
  said.push_back(forms.length().text());
  for (const Sphere& sphere : pair) {
    for (const Engine engine : {Engine::kFiltered, Engine::kFieldOnly}) {
      const Intersection at = ray.intersect(sphere, scene::Root::kNearest, {engine});
      said.push_back(std::to_string(static_cast<int>(at.hit_class)));
      said.push_back(std::to_string(static_cast<int>(at.root)));
    }
    const Neighbourhood around{scene::Root::kNearest, scene::Tangent::kHit, 0x1p-6};
    const NearbyAnswer missed = right_nearby(ray, sphere, around, std::nullopt);
    said.push_back(std::to_string(static_cast<int>(missed.found)));
    for (const double share : missed.witness) said.push_back(scene::hexfloat(share));
    const Intersection at = ray.intersect(sphere);
    say(condition_of_axial_distance(ray, sphere));
    say(condition_of_half_chord_sq(ray, sphere));
    say(stage_conditions(ray, sphere, at).half_chord_sq);
    if (at.hit_class == HitClass::kMiss) continue;
    say(ray.rounded_parameter(sphere, at));
    say3(ray.rounded_point(sphere, at));
    say(ray.parameter(sphere, at).lower());
    say(ulp_error(ray.rounded_parameter(sphere, at), ray.parameter(sphere, at)).value);
    say(backward_error({ray.rounded_origin(), {direction.x, direction.y, direction.z}}, sphere,
                       ray.rounded_parameter(sphere, at))
            .value);
    say(condition_of_parameter(ray, sphere, at));
    say(condition_of_point(ray, sphere, at));
    said.push_back(forms.parameter(sphere, at).text());
    said.push_back(forms.point(sphere, at)[1].text());
  }
  const auto nearest = ray.nearest(pair, {});
  said.push_back(nearest ? std::to_string(nearest->index) : "none");
  return said;
}

struct Case {
  std::shared_ptr<const ExactCamera> camera;
  scene::Pixel pixel;
  std::shared_ptr<const ExactRay> ray;
  std::shared_ptr<const ClosedFormRay> forms;
  std::array<Sphere, 2> pair;
  std::vector<std::string> said;
};

std::vector<Case> random_cases_of(Sizes sizes, std::uint64_t seed) {
  Random random(seed);
  std::vector<Case> cases;
  const int cameras = sizes == Sizes::kAll ? 2 : 6;  // Cameras of all sizes are slow in the field.
  for (int k = 0; k < cameras; ++k) {
    const scene::Camera camera = random_camera(random, sizes);
    const scene::Conventions conventions = random_conventions(random);
    const auto exact = std::make_shared<const ExactCamera>(camera, conventions);
    for (int n = 0; n < 5; ++n) {
      const scene::Pixel pixel = random_pixel(random, camera);
      // The first sphere is around everything, so that each camera has a hit.
      const Sphere sphere = n == 0 ? Sphere{camera.eye, std::numeric_limits<double>::max()}
                                   : random_sphere(random, sizes);
      // Half of the pairs tie.
      const Sphere other = random.one_in(2) ? sphere : random_sphere(random, sizes);
      Case made{exact,
                pixel,
                std::make_shared<const ExactRay>(*exact, pixel),
                std::make_shared<const ClosedFormRay>(camera, conventions, pixel),
                {sphere, other},
                {}};
      made.said = everything(*made.camera, *made.ray, *made.forms, made.pair);
      cases.push_back(made);
    }
  }
  return cases;
}

TEST(Threads, SharingOneCameraGetTheAnswersOfOneThread) {
  const std::vector<Case> cases = random_cases_of(Sizes::kSmallIntegers, 1);
  constexpr std::size_t kThreads = 8;
  std::array<int, kThreads> compared{};
  std::array<int, kThreads> different{};
  std::vector<std::thread> threads;
  for (std::size_t t = 0; t < kThreads; ++t) {
    threads.emplace_back([&, t] {
      for (std::size_t k = 0; k < 2 * cases.size(); ++k) {
        const Case& one = cases[(k + 7 * t) % cases.size()];
        ++compared[t];
        // Every second time with a ray of this thread.
        const ExactRay own(*one.camera, one.pixel);
        const ExactRay& ray = k % 2 == 0 ? *one.ray : own;
        different[t] += everything(*one.camera, ray, *one.forms, one.pair) == one.said ? 0 : 1;
      }
      flint_cleanup();  // The caches that FLINT keeps for each thread.
    });
  }
  for (std::thread& thread : threads) thread.join();
  for (std::size_t t = 0; t < kThreads; ++t) {
    EXPECT_EQ(compared[t], 60);
    EXPECT_EQ(different[t], 0);
  }
}

constexpr std::array<int, 4> kModes{FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO};

class RoundingMode : public testing::TestWithParam<Sizes> {
 protected:
  void TearDown() override { std::fesetround(FE_TONEAREST); }
};

TEST_P(RoundingMode, OfTheCallerChangesNoAnswerAndIsRestored) {
  std::size_t longest = 0;
  for (const Case& one : random_cases_of(GetParam(), 2)) {
    const scene::Camera& camera = one.camera->camera();
    const scene::Conventions& conventions = one.camera->conventions();
    longest = std::max(longest, one.said.size());
    for (const int mode : kModes) {
      ASSERT_EQ(std::fesetround(mode), 0);
      const ExactCamera exact(camera, conventions);
      const bool kept_by_camera = std::fegetround() == mode;
      const ExactRay ray(exact, one.pixel);
      const bool kept_by_ray = std::fegetround() == mode;
      const ClosedFormRay forms(camera, conventions, one.pixel);
      const auto said = everything(exact, ray, forms, one.pair);
      const bool kept_by_all = std::fegetround() == mode;
      std::fesetround(FE_TONEAREST);
      EXPECT_TRUE(kept_by_camera && kept_by_ray && kept_by_all) << mode;
      EXPECT_EQ(said, one.said) << mode << " " << spelled(camera);
    }
  }
  EXPECT_GE(longest, 40u);
}

std::string name_of(const testing::TestParamInfo<Sizes>& info) {
  if (info.param == Sizes::kAll) return "OfAllSizes";
  return info.param == Sizes::kOrdinary ? "OfOrdinarySize" : "OfSmallIntegers";
}
INSTANTIATE_TEST_SUITE_P(Inputs, RoundingMode,
                         testing::Values(Sizes::kSmallIntegers, Sizes::kOrdinary, Sizes::kAll),
                         name_of);

TEST_F(RoundingMode, IsRestoredIfInputIsRefused) {
  for (const int mode : kModes) {
    ASSERT_EQ(std::fesetround(mode), 0);
    const ExactRay ray(scene::Ray{{0, 0, 0}, {1, 0, 0}});
    EXPECT_THROW(ray.intersect({{0, 0, 0}, -1}), std::invalid_argument);
    EXPECT_THROW(ExactRay(scene::Ray{}), std::invalid_argument);
    EXPECT_EQ(std::fegetround(), mode);
  }
}

}  // namespace
}  // namespace raycheck::reference
