#include "scene/plan/plan.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "properties/laws/law_list.h"
#include "properties/trial.h"

namespace raycheck::properties {
namespace {

using scene::Bounds;
using scene::LeftOut;
using scene::PixelRectangle;
using scene::SpherePlan;
using scene::Wanted;

/// At most this many pixels are tried along each border of a rectangle.
constexpr std::int64_t kMostOfBorder = 64;
/// At most this many rows, and columns, are tried inside a rectangle.
constexpr std::int64_t kMostInside = 5;

/// What a plan states about one sphere, and the purpose of the plan.
struct PlanStatement {
  scene::Wanted wanted;
  const scene::ScenePlan* plan;
  std::size_t sphere;

  const scene::SpherePlan& planned() const { return plan->spheres[sphere]; }
};

/// Whole numbers in [begin, end), spread evenly, including the first and the last.
std::vector<std::int64_t> spread(std::int64_t begin, std::int64_t end, std::int64_t most) {
  std::vector<std::int64_t> result;
  const std::int64_t count = std::min(end - begin, most);
  result.reserve(static_cast<std::size_t>(std::max<std::int64_t>(0, count)));
  for (std::int64_t k = 0; k < count; ++k) {
    result.push_back(count == 1 ? begin : begin + (end - 1 - begin) * k / (count - 1));
  }
  return result;
}

void add_if_inside(const PixelRectangle& where, const Pixel& pixel, std::vector<Pixel>& pixels) {
  if (where.contains(pixel)) pixels.push_back(pixel);
}

double middle(const Bounds& x) { return x.low + (x.high - x.low) / 2; }

/// Adds the pixel, in or next to the image, at which a direction through the eye points.
void add_pointed_at(const scene::EyeSpace& eye, const PixelRectangle& image, const Vector3& along,
                    std::vector<Pixel>& pixels) {
  if (!(along.z > 0)) return;
  const double scale = std::abs(middle(eye.near())) / along.z;
  const double i = middle(eye.column(Bounds::exactly(along.x * scale)));
  const double j = middle(eye.row(Bounds::exactly(along.y * scale)));
  if (!(i > -2 && i < static_cast<double>(image.i_end) + 1)) return;
  if (!(j > -2 && j < static_cast<double>(image.j_end) + 1)) return;
  pixels.push_back(
      {static_cast<std::int64_t>(std::round(i)), static_cast<std::int64_t>(std::round(j))});
}

/// Approximate pixels of a silhouette's first and last column and row. In the plane (U, W) the
/// tangents from the eye touch the disc of centre (u, z) and radius r at (u q -+ z r, z q +- u r)
/// q/rho^2, where rho^2 = u^2 + z^2 and q^2 = rho^2 - r^2. The V coordinate there is that of the
/// centre. For the rows, U and V are exchanged.
std::vector<Pixel> touched(const PlanStatement& statement, const PixelRectangle& image) {
  const scene::EyeSphere& seen = statement.planned().seen;
  const scene::EyeSpace& eye = statement.plan->eye;
  const double u = middle(seen.u), v = middle(seen.v), r = middle(seen.radius);
  const double z = middle(eye.near()) < 0 ? -middle(seen.w) : middle(seen.w);
  const double across_sq = u * u + z * z, along_sq = v * v + z * z;
  const double across = std::sqrt(across_sq - r * r), along = std::sqrt(along_sq - r * r);
  std::vector<Pixel> result;
  for (const double side : {-r, r}) {
    add_pointed_at(eye, image,
                   {(u * across + z * side) * across / across_sq, v,
                    (z * across - u * side) * across / across_sq},
                   result);
    add_pointed_at(
        eye, image,
        {u, (v * along + z * side) * along / along_sq, (z * along - v * side) * along / along_sq},
        result);
  }
  return result;
}

bool is_same(const SpherePlan& a, const SpherePlan& b) {
  return a.left_out == b.left_out && a.hidden_by == b.hidden_by && a.pixels == b.pixels &&
         a.origin_inside == b.origin_inside && a.reaches_behind == b.reaches_behind;
}

/// The plans of a candidate for one scene, for every purpose (scene::Wanted). They determine for
/// which pixels the truth is computed, but do not change it.
/// Domain: a scene with a camera, a candidate that plans.
class PlanStatements {
 public:
  explicit PlanStatements(Trial& trial)
      : pixels_(trial.pixels()), camera_(*trial.scene().camera), plans_(trial.plans()) {}

  PixelRectangle image() const { return {0, camera_.width, 0, camera_.height}; }

  /// The distinct statements about each sphere.
  std::vector<PlanStatement> distinct() const {
    std::vector<PlanStatement> result;
    for (std::size_t sphere = 0; sphere < plans_.front().spheres.size(); ++sphere) {
      const auto first = static_cast<std::ptrdiff_t>(result.size());
      for (std::size_t k = 0; k < plans_.size(); ++k) {
        const PlanStatement next{scene::kEveryWanted[k], &plans_[k], sphere};
        if (std::none_of(result.begin() + first, result.end(), [&](const PlanStatement& known) {
              return is_same(known.planned(), next.planned());
            })) {
          result.push_back(next);
        }
      }
    }
    return result;
  }

  /// Pixels in a sphere's rectangle if a plan has one, otherwise in the image; and all pixels of
  /// the case.
  std::vector<Pixel> inside(const PlanStatement& statement) const {
    PixelRectangle where = image();
    for (const scene::ScenePlan& plan : plans_) {
      const PixelRectangle& pixels = plan.spheres[statement.sphere].pixels;
      if (!pixels.empty() && image().contains(pixels)) where = pixels;
    }
    std::vector<Pixel> result = pixels_;
    for (const std::int64_t j : spread(where.j_begin, where.j_end, kMostInside)) {
      for (const std::int64_t i : spread(where.i_begin, where.i_end, kMostInside)) {
        result.push_back({i, j});
      }
    }
    for (const Pixel& pixel : touched(statement, image())) {
      for (const std::int64_t j : {pixel.j - 1, pixel.j, pixel.j + 1}) {
        for (const std::int64_t i : {pixel.i - 1, pixel.i, pixel.i + 1}) {
          add_if_inside(where, {i, j}, result);
        }
      }
    }
    return result;
  }

  /// Pixels of the image just outside a sphere's rectangle, also next to the points where the
  /// silhouette touches it; and the pixels of the case that are outside the rectangle.
  std::vector<Pixel> outside(const PlanStatement& statement) const {
    const PixelRectangle& inner = statement.planned().pixels;
    if (inner.empty()) return inside(statement);
    std::vector<Pixel> result;
    for (const Pixel& pixel : pixels_) {
      if (!inner.contains(pixel)) result.push_back(pixel);
    }
    std::vector<std::int64_t> columns = spread(inner.i_begin - 1, inner.i_end + 1, kMostOfBorder);
    std::vector<std::int64_t> rows = spread(inner.j_begin - 1, inner.j_end + 1, kMostOfBorder);
    for (const Pixel& pixel : touched(statement, image())) {
      for (const int step : {-1, 0, 1}) {
        columns.push_back(std::clamp(pixel.i + step, inner.i_begin - 1, inner.i_end));
        rows.push_back(std::clamp(pixel.j + step, inner.j_begin - 1, inner.j_end));
      }
    }
    for (const std::int64_t i : columns) {
      add_if_inside(image(), {i, inner.j_begin - 1}, result);
      add_if_inside(image(), {i, inner.j_end}, result);
    }
    for (const std::int64_t j : rows) {
      add_if_inside(image(), {inner.i_begin - 1, j}, result);
      add_if_inside(image(), {inner.i_end, j}, result);
    }
    return result;
  }

 private:
  const std::vector<Pixel>& pixels_;
  const Camera& camera_;
  const std::vector<scene::ScenePlan>& plans_;
};

/// A sphere at a pixel about which a plan makes a statement.
struct SaidOf {
  const Trial& trial;
  std::size_t sphere;
  Pixel pixel;
};

/// Judges a plan's statement. A wrong one has no excuse, because a plan promises to change no
/// answer in any scene. `what` returns the text of the discrepancy.
template <class What>
void judge(Verdict& verdict, const SaidOf& it, Quantity quantity, Wrong wrong, const What& what) {
  const auto width = static_cast<std::size_t>(it.trial.scene().camera->width);
  const std::size_t ray =
      static_cast<std::size_t>(it.pixel.j) * width + static_cast<std::size_t>(it.pixel.i);
  const Expected expected = quantity == Quantity::kRoot            ? Expected::kSmallerRoot
                            : quantity == Quantity::kNearestSphere ? Expected::kNearestOfSeveral
                                                                   : Expected::kMiss;
  it.trial.judge(
      verdict, {quantity, expected, {ray, it.pixel, it.sphere}, wrong}, [] { return Excuse{}; },
      [&](Discrepancy& d) { d.what = what(); });
}

std::string for_what(const PlanStatement& statement) {
  const auto wanted = scene::kWantedNames[static_cast<std::size_t>(statement.wanted)];
  return ", if the " + std::string(wanted) + " is wanted";
}

/// Whether the ray misses `sphere`, or meets `by` first: nearer, or at the same distance and
/// earlier in the file.
bool is_hidden(const ExactRay& ray, const Trial& trial, std::size_t sphere, std::size_t by) {
  const auto& spheres = trial.scene().spheres;
  const Conventions& conventions = trial.conventions();
  const Intersection at = ray.intersect(spheres[sphere], conventions.root);
  if (!reference::counts_as_hit(at.hit_class, conventions.tangent)) return true;
  const Intersection at_by = ray.intersect(spheres[by], conventions.root);
  if (!reference::counts_as_hit(at_by.hit_class, conventions.tangent)) return false;
  const int order = ray.compare(spheres[by], at_by, spheres[sphere], at);
  return order < 0 || (order == 0 && by < sphere);
}

void judge_left_out(Trial& trial, Verdict& verdict) {
  const PlanStatements statements(trial);
  const ExactCamera& camera = trial.exact_camera();
  const auto& spheres = trial.scene().spheres;
  for (const PlanStatement& statement : statements.distinct()) {
    const std::size_t k = statement.sphere;
    const SpherePlan& planned = statement.planned();
    if (!planned.left_out) continue;
    const bool is_ranked =
        planned.left_out == LeftOut::kHidden && statement.wanted == Wanted::kNearest;
    for (const Pixel& pixel : statements.inside(statement)) {
      const ExactRay ray(camera, pixel);
      const bool is_right =
          is_ranked
              ? is_hidden(ray, trial, k, planned.hidden_by.value())
              : ray.intersect(spheres[k], trial.conventions().root).hit_class == HitClass::kMiss;
      judge(
          verdict, {trial, k, pixel}, is_ranked ? Quantity::kNearestSphere : Quantity::kClass,
          is_right    ? Wrong::kNot
          : is_ranked ? Wrong::kWrongSphere
                      : Wrong::kMissed,
          [&] {
            return std::string(scene::kLeftOutNames[static_cast<std::size_t>(*planned.left_out)]) +
                   for_what(statement);
          });
    }
  }
  if (verdict.compared() == 0) return verdict.leave_out("the plan leaves out no sphere");
}

void judge_rectangles(Trial& trial, Verdict& verdict) {
  const PlanStatements statements(trial);
  const ExactCamera& camera = trial.exact_camera();
  const auto& spheres = trial.scene().spheres;
  for (const PlanStatement& statement : statements.distinct()) {
    const std::size_t k = statement.sphere;
    const SpherePlan& planned = statement.planned();
    if (planned.left_out) continue;
    if (!statements.image().contains(planned.pixels)) {
      throw CandidateFailed("the rectangle of sphere " + std::to_string(k) +
                            " is not inside the image");
    }
    for (const Pixel& pixel : statements.outside(statement)) {
      const Intersection at =
          ExactRay(camera, pixel).intersect(spheres[k], trial.conventions().root);
      judge(verdict, {trial, k, pixel}, Quantity::kClass,
            at.hit_class == HitClass::kMiss ? Wrong::kNot : Wrong::kMissed,
            [&] { return "outside its rectangle" + for_what(statement); });
    }
  }
  if (verdict.compared() == 0) return verdict.leave_out("every rectangle is the whole image");
}

/// The ray from the eye through a pixel and the ray in the opposite direction; together they are
/// the whole line.
class BothWays {
 public:
  BothWays(const Camera& camera, const Conventions& conventions)
      : forwards_(camera, from_eye(conventions)),
        backwards_(opposite(camera), from_eye(conventions)) {}

  bool meets(const Sphere& sphere, const Pixel& pixel) const {
    return ExactRay(forwards_, pixel).intersect(sphere).hit_class != HitClass::kMiss ||
           ExactRay(backwards_, pixel).intersect(sphere).hit_class != HitClass::kMiss;
  }

 private:
  static Conventions from_eye(Conventions conventions) {
    conventions.origin = scene::Origin::kFocal;
    return conventions;
  }
  static Camera opposite(Camera camera) {
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
  const ExactCamera& camera = trial.exact_camera();
  const BothWays line(*trial.scene().camera, trial.conventions());
  const auto& spheres = trial.scene().spheres;
  for (const PlanStatement& statement : statements.distinct()) {
    const std::size_t k = statement.sphere;
    const SpherePlan& planned = statement.planned();
    if (planned.origin_inside && planned.reaches_behind) continue;
    for (const Pixel& pixel : statements.inside(statement)) {
      const Intersection at =
          ExactRay(camera, pixel).intersect(spheres[k], trial.conventions().root);
      const bool is_hit = at.hit_class != HitClass::kMiss;
      if (is_hit) {
        judge(verdict, {trial, k, pixel}, Quantity::kRoot,
              at.root == WhichRoot::kLarger ? Wrong::kWrongRoot : Wrong::kNot,
              [&] { return planned.origin_inside ? "behind the origin" : "from inside"; });
      }
      if (!planned.reaches_behind) {
        judge(verdict, {trial, k, pixel}, Quantity::kClass,
              !is_hit && line.meets(spheres[k], pixel) ? Wrong::kFalseHit : Wrong::kNot,
              [] { return "behind the origin"; });
      }
    }
  }
  if (verdict.compared() == 0)
    return verdict.leave_out("by the plan, rays may start inside or past every sphere");
}

constexpr Law kPlanLawTable[] = {
    {"plan-left-out", "no ray meets a sphere that the plan leaves out", Per::kPair,
     Needs::kPlan | Needs::kSpheres, Quantity::kClass, judge_left_out},
    {"plan-rectangles", "every pixel outside a sphere's rectangle misses it", Per::kPair,
     Needs::kPlan | Needs::kSpheres, Quantity::kClass, judge_rectangles},
    {"plan-roots", "far roots and spheres behind the origin occur only where the plan says so",
     Per::kPair, Needs::kPlan | Needs::kSpheres, Quantity::kRoot, judge_roots},
};

}  // namespace

constinit const std::span<const Law> kPlanLaws = kPlanLawTable;

}  // namespace raycheck::properties
