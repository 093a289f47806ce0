#include "scene/plan/plan.h"

#include <cmath>
#include <stdexcept>
#include <string>

#include "properties/laws/law_list.h"
#include "properties/laws/plan_claims.h"

namespace raycheck::properties {
namespace {

using reference::ExactCamera;
using reference::ExactRay;
using reference::HitClass;
using reference::Intersection;
using scene::LeftOut;
using scene::Pixel;
using scene::SpherePlan;
using scene::Wanted;

/// A sphere at a pixel, of which a plan says something.
struct SaidOf {
  const Trial& trial;
  std::size_t sphere;
  Pixel pixel;
};

/// Nothing excuses a plan: it promises to change no answer, whatever the scene.
void judge(Verdict& verdict, const SaidOf& it, Quantity quantity, Wrong wrong,
           const std::string& what) {
  const auto width = static_cast<std::size_t>(it.trial.scene().camera->width);
  const std::size_t ray =
      static_cast<std::size_t>(it.pixel.j) * width + static_cast<std::size_t>(it.pixel.i);
  const Expected expected = quantity == Quantity::kRoot            ? Expected::kSmallerRoot
                            : quantity == Quantity::kNearestSphere ? Expected::kNearestOfSeveral
                                                                   : Expected::kMiss;
  it.trial.judge(
      verdict, {quantity, expected, {ray, it.pixel, it.sphere}, wrong}, [] { return Excuse{}; },
      [&](Discrepancy& d) { d.what = what; });
}

std::string for_what(const PlanStatement& statement) {
  const auto wanted = scene::kWantedNames[static_cast<std::size_t>(statement.wanted)];
  return ", where the " + std::string(wanted) + " is wanted";
}

/// Every ray that meets `sphere` meets `by` first: nearer, or as near and earlier in the file.
bool is_hidden(const ExactRay& ray, const Trial& trial, std::size_t sphere, std::size_t by) {
  const auto& spheres = trial.scene().spheres;
  const scene::Conventions& conventions = trial.conventions();
  const Intersection at = ray.intersect(spheres[sphere], conventions.root);
  if (!reference::counts_as_hit(at.hit_class, conventions.tangent)) return true;
  const Intersection at_by = ray.intersect(spheres[by], conventions.root);
  if (!reference::counts_as_hit(at_by.hit_class, conventions.tangent)) return false;
  const int order = ray.compare(spheres[by], at_by, spheres[sphere], at);
  return order < 0 || (order == 0 && by < sphere);
}

void judge_left_out(Trial& trial, Verdict& verdict) {
  const PlanStatements statements(trial);
  const ExactCamera camera(*trial.scene().camera, trial.conventions());
  const auto& spheres = trial.scene().spheres;
  for (std::size_t k = 0; k < spheres.size(); ++k) {
    for (const PlanStatement& statement : statements.of(k)) {
      const SpherePlan& said = statement.said();
      if (!said.left_out) continue;
      const bool is_ranked =
          said.left_out == LeftOut::kHidden && statement.wanted == Wanted::kNearest;
      for (const Pixel& pixel : statements.inside(statement)) {
        const ExactRay ray(camera, pixel);
        const bool is_right =
            is_ranked
                ? is_hidden(ray, trial, k, said.hidden_by.value())
                : ray.intersect(spheres[k], trial.conventions().root).hit_class == HitClass::kMiss;
        judge(verdict, {trial, k, pixel}, is_ranked ? Quantity::kNearestSphere : Quantity::kClass,
              is_right    ? Wrong::kNot
              : is_ranked ? Wrong::kWrongSphere
                          : Wrong::kMissed,
              std::string(scene::kLeftOutNames[static_cast<std::size_t>(*said.left_out)]) +
                  for_what(statement));
      }
    }
  }
  if (verdict.compared() == 0) return verdict.leave_out("the plan leaves out no sphere");
}

void judge_rectangles(Trial& trial, Verdict& verdict) {
  const PlanStatements statements(trial);
  const ExactCamera camera(*trial.scene().camera, trial.conventions());
  const auto& spheres = trial.scene().spheres;
  for (std::size_t k = 0; k < spheres.size(); ++k) {
    for (const PlanStatement& statement : statements.of(k)) {
      const SpherePlan& said = statement.said();
      if (said.left_out) continue;
      if (!statements.image().contains(said.pixels)) {
        throw std::runtime_error("the rectangle of sphere " + std::to_string(k) +
                                 " is not inside the image");
      }
      for (const Pixel& pixel : statements.outside(statement)) {
        const Intersection at =
            ExactRay(camera, pixel).intersect(spheres[k], trial.conventions().root);
        judge(verdict, {trial, k, pixel}, Quantity::kClass,
              at.hit_class == HitClass::kMiss ? Wrong::kNot : Wrong::kMissed,
              "outside its rectangle" + for_what(statement));
      }
    }
  }
  if (verdict.compared() == 0) return verdict.leave_out("every rectangle is the whole image");
}

/// The rays from the eye through a pixel and away from it: their line meets what one of them meets.
class BothWays {
 public:
  BothWays(const scene::Camera& camera, const scene::Conventions& conventions)
      : forwards_(camera, from_eye(conventions)),
        backwards_(opposite(camera), from_eye(conventions)) {}

  bool meets(const scene::Sphere& sphere, const Pixel& pixel) const {
    return ExactRay(forwards_, pixel).intersect(sphere).hit_class != HitClass::kMiss ||
           ExactRay(backwards_, pixel).intersect(sphere).hit_class != HitClass::kMiss;
  }

 private:
  static scene::Conventions from_eye(scene::Conventions conventions) {
    conventions.origin = scene::Origin::kFocal;
    return conventions;
  }
  static scene::Camera opposite(scene::Camera camera) {
    for (double* position :
         {&camera.near, &camera.left, &camera.right, &camera.bottom, &camera.top}) {
      *position = -*position;
    }
    return camera;
  }

  ExactCamera forwards_, backwards_;
};

void judge_roots(Trial& trial, Verdict& verdict) {
  const PlanStatements statements(trial);
  const ExactCamera camera(*trial.scene().camera, trial.conventions());
  const BothWays line(*trial.scene().camera, trial.conventions());
  const auto& spheres = trial.scene().spheres;
  for (std::size_t k = 0; k < spheres.size(); ++k) {
    for (const PlanStatement& statement : statements.of(k)) {
      const SpherePlan& said = statement.said();
      if (said.origin_inside && said.reaches_behind) continue;
      for (const Pixel& pixel : statements.inside(statement)) {
        const Intersection at =
            ExactRay(camera, pixel).intersect(spheres[k], trial.conventions().root);
        const bool is_hit = at.hit_class != HitClass::kMiss;
        if (is_hit) {
          judge(verdict, {trial, k, pixel}, Quantity::kRoot,
                at.root == reference::WhichRoot::kLarger ? Wrong::kWrongRoot : Wrong::kNot,
                said.origin_inside ? "behind the origin" : "from inside");
        }
        if (!said.reaches_behind) {
          judge(verdict, {trial, k, pixel}, Quantity::kClass,
                !is_hit && line.meets(spheres[k], pixel) ? Wrong::kFalseHit : Wrong::kNot,
                "behind the origin");
        }
      }
    }
  }
  if (verdict.compared() == 0) return verdict.leave_out("any ray may start inside, or past it");
}

constexpr Law kPlanLawTable[] = {
    {.name = "plan-left-out",
     .sentence = "no ray sees a sphere that the plan leaves out",
     .per = Per::kPair,
     .needs = Needs::kPlan | Needs::kSpheres,
     .quantity = Quantity::kClass,
     .judge = judge_left_out},
    {.name = "plan-rectangles",
     .sentence = "every pixel outside a sphere's rectangle misses it",
     .per = Per::kPair,
     .needs = Needs::kPlan | Needs::kSpheres,
     .quantity = Quantity::kClass,
     .judge = judge_rectangles},
    {.name = "plan-roots",
     .sentence = "the far root, and the test for what is behind, are needed where the plan says",
     .per = Per::kPair,
     .needs = Needs::kPlan | Needs::kSpheres,
     .quantity = Quantity::kRoot,
     .judge = judge_roots},
};

}  // namespace

constinit const std::span<const Law> kPlanLaws = kPlanLawTable;

}  // namespace raycheck::properties
