#include <iterator>
#include <limits>
#include <optional>
#include <stdexcept>

#include "properties/laws/law_list.h"

namespace raycheck::properties {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinite = std::numeric_limits<double>::infinity();

/// One way to make a camera, a sphere or a ray invalid, and the name of the defect.
template <class Thing>
struct Spoiling {
  const char* what;
  void (*spoil)(Thing&);
  bool keeps_frame = false;  ///< Whether it affects only a camera's pixels, not its frame.
};

constexpr Spoiling<Camera> kCameraSpoilings[] = {
    {"eye is not a number", [](Camera& c) { c.eye.x = kNaN; }},
    {"look_at is infinite", [](Camera& c) { c.look_at.y = kInfinite; }},
    {"up is not a number", [](Camera& c) { c.up.z = kNaN; }},
    {"look_at equals eye", [](Camera& c) { c.look_at = c.eye; }},
    {"up is zero", [](Camera& c) { c.up = {}; }},
    {"up is parallel to the view",
     [](Camera& c) {
       c.eye = {1, 2, 3};
       c.look_at = {2, 4, 6};
       c.up = {-3, -6, -9};
     }},
    {"near is zero", [](Camera& c) { c.near = 0; }, true},
    {"left is infinite", [](Camera& c) { c.left = -kInfinite; }, true},
    {"right equals left", [](Camera& c) { c.right = c.left; }, true},
    {"top equals bottom", [](Camera& c) { c.top = c.bottom; }, true},
    {"near is not a number", [](Camera& c) { c.near = kNaN; }, true},
    {"right is infinite", [](Camera& c) { c.right = kInfinite; }, true},
    {"bottom is not a number", [](Camera& c) { c.bottom = kNaN; }, true},
    {"top is infinite", [](Camera& c) { c.top = kInfinite; }, true},
    {"width is zero", [](Camera& c) { c.width = 0; }, true},
    {"height is negative", [](Camera& c) { c.height = -1; }, true},
};

constexpr Spoiling<Sphere> kSphereSpoilings[] = {
    {"radius is negative", [](Sphere& s) { s.radius = -1; }},
    {"radius is not a number", [](Sphere& s) { s.radius = kNaN; }},
    {"radius is infinite", [](Sphere& s) { s.radius = kInfinite; }},
    {"centre is infinite", [](Sphere& s) { s.centre.z = kInfinite; }},
};

constexpr Spoiling<Ray> kRaySpoilings[] = {
    {"ray direction is zero", [](Ray& r) { r.direction = {}; }},
    {"ray origin is not a number", [](Ray& r) { r.origin.x = kNaN; }},
    {"ray direction is infinite", [](Ray& r) { r.direction.y = kInfinite; }},
};

/// In a campaign, the invalid questions are asked in turn, so that a case has few: each throws an
/// exception, which takes longer than most judgements.
bool is_asked(const Trial& trial, std::size_t question, std::size_t turns) {
  const std::optional<std::uint64_t>& turn = trial.options().turn;
  return !turn || *turn % turns == question % turns;
}

/// Calls the function directly (as_is), because each rethrow of an exception takes time.
template <class Ask>
void expect_refusal(Trial& trial, Verdict& verdict, const char* what, const Ask& ask) {
  Wrong wrong = Wrong::kAnswered;
  try {
    try {
      ask();
    } catch (const std::invalid_argument&) {
      wrong = Wrong::kNot;
    } catch (...) {
      asked([] { throw; });
    }
  } catch (const CandidateRefused&) {
    wrong = Wrong::kNot;
  }
  trial.judge(
      verdict, {Quantity::kRefusal, Expected::kRefusal, {}, wrong}, [] { return Excuse{}; },
      [&](Discrepancy& d) { d.what = what; });
}

void spoil_cameras(Trial& trial, Verdict& verdict) {
  const Candidate& candidate = trial.candidate();
  const Conventions& conventions = trial.conventions();
  const std::vector<Pixel> pixels = {{0, 0}};
  std::size_t defect = 0;
  for (const auto& [what, spoil, keeps_frame] : kCameraSpoilings) {
    if (!is_asked(trial, defect++, std::size(kCameraSpoilings))) continue;
    Camera camera = *trial.scene().camera;
    spoil(camera);
    if (candidate.frame && !keeps_frame) {
      expect_refusal(trial, verdict, what, [&] { candidate.frame.as_is(camera); });
    }
    for (const auto* make : {&candidate.pixel_rays, &candidate.focal_rays}) {
      if (!*make) continue;
      expect_refusal(trial, verdict, what, [&] { make->as_is(camera, conventions, pixels); });
    }
    if (candidate.pixel_points) {
      expect_refusal(trial, verdict, what,
                     [&] { candidate.pixel_points.as_is(camera, conventions, pixels); });
    }
  }
}

void spoil_intersections(Trial& trial, Verdict& verdict) {
  constexpr std::size_t kCount = std::size(kSphereSpoilings) + std::size(kRaySpoilings);
  std::size_t question = 0;
  const auto ask = [&](const char* what, const Ray& ray, const Sphere& sphere) {
    if (!is_asked(trial, question++, kCount)) return;
    expect_refusal(trial, verdict, what, [&] {
      trial.candidate().intersect.as_is(std::span(&ray, 1), std::span(&sphere, 1),
                                        trial.conventions());
    });
  };
  const Ray ray =
      trial.scene().rays.empty() ? Ray{{0, 0, 0}, {1, 0, 0}} : trial.scene().rays.front();
  const Sphere sphere = trial.scene().spheres.front();
  for (const auto& spoiling : kSphereSpoilings) {
    Sphere spoilt = sphere;
    spoiling.spoil(spoilt);
    ask(spoiling.what, ray, spoilt);
  }
  for (const auto& spoiling : kRaySpoilings) {
    Ray spoilt = ray;
    spoiling.spoil(spoilt);
    ask(spoiling.what, spoilt, sphere);
  }
}

void judge_refusal(Trial& trial, Verdict& verdict) {
  if (trial.scene().camera) spoil_cameras(trial, verdict);
  if (trial.candidate().intersect && !trial.scene().spheres.empty()) {
    spoil_intersections(trial, verdict);
  }
  if (verdict.compared() == 0) {
    return verdict.leave_out("the candidate has no function that takes the scene's input");
  }
}

constexpr Law kRefusalLawTable[] = {
    {"refusal", "input that is not finite, or is degenerate, is refused, not answered", Per::kScene,
     Needs::kRefusals, Quantity::kRefusal, judge_refusal},
};

}  // namespace

constinit const std::span<const Law> kRefusalLaws = kRefusalLawTable;

}  // namespace raycheck::properties
