#include "tools/grade/pages/drawing.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "properties/quantity.h"
#include "tools/grade/pages/answered.h"
#include "tools/grade/pages/plane_drawing.h"
#include "tools/report/words.h"

namespace raycheck::tools {
namespace {

/// Half of the window, in ulp, in which doubles are seen to be several.
constexpr double kWidestGrid = 16;
/// What is so many radii from a sphere is beyond the drawing.
constexpr double kFarthest = 6;
/// Radii whose squares are ordinary doubles.
constexpr double kSmallestRadius = 0x1p-500, kLargestRadius = 0x1p500;

/// The submission's mark: the point that it answers where that is judged, otherwise its s.
const MicroscopeMark* mark_of(const FailingCase& failing, const Microscope& scope) {
  const bool is_point = failing.answer.quantity == properties::Quantity::kHitPoint;
  const auto found =
      std::find_if(scope.marks.begin(), scope.marks.end(), [&](const MicroscopeMark& mark) {
        return mark.method == kYours && mark.is_point == is_point;
      });
  return found == scope.marks.end() ? nullptr : &*found;
}

/// Around the exact hit, or the point of the ray next to the centre, in ulp.
std::string magnified(const Microscope& scope, const MicroscopeMark& yours) {
  const PlanePoint place = {yours.x, yours.y};
  const double reach = std::max(std::abs(yours.x), std::abs(yours.y));
  const auto zoom =
      std::find_if(scope.zooms.begin(), scope.zooms.end(),
                   [&](const Microscope::Zoom& one) { return one.half_width * 0.9 >= reach; });
  if (zoom == scope.zooms.end()) return "";
  const double half = zoom->half_width;
  PlaneDrawing drawing({{-half, -half / 2}, {half, half / 2}});
  for (const double one : scope.grid) {
    if (half <= kWidestGrid && std::abs(one) <= half)
      drawing.line("grid", {{one, -half}, {one, half}});
  }
  std::vector<PlanePoint> curve(zoom->curve.begin(), zoom->curve.end());
  if (!curve.empty()) drawing.line("sphere", curve);
  drawing.arrow("ray", drawing.left(0), drawing.right(0));
  drawing.answers(scope.is_hit ? std::optional(PlanePoint{0, 0}) : std::nullopt, place);
  const std::string what =
      scope.is_hit
          ? fmt::format("the cross, yours, is off by {:.3g} steps from one double to the next",
                        std::hypot(yours.x, yours.y))
          : "exactly, it misses; the cross is yours";
  return drawing.html(fmt::format(
      "Magnified around {}, s = {:.17g}: the ray runs to the right, the curve is the sphere{}; {}.",
      scope.is_hit ? "the exact hit" : "the ray's point nearest to the centre", scope.parameter,
      half <= kWidestGrid ? ", upright lines are the doubles next to s" : "", what));
}

/// A ray and a sphere, the exact answer and the submission's.
std::string hit_html(const FailingCase& failing, const Panel& panel) {
  const ExplainReport& report = panel.report;
  const Microscope& scope = *panel.microscope;
  const double r = report.scene.spheres[*report.sphere].radius;
  if (r < kSmallestRadius || r > kLargestRadius) return "";
  const double half_chord_sq = report.find("d^2")->rounded.front() / r / r;
  const double beside = std::sqrt(std::max(0.0, 1 - half_chord_sq));
  const double half_chord = std::sqrt(std::max(0.0, half_chord_sq));
  if (!(beside < kFarthest)) return "";
  const bool is_smaller =
      report.spheres[*report.sphere].intersection.root == reference::WhichRoot::kSmaller;
  // In radii: the ray runs to the right, its point nearest to the centre is the origin.
  const PlanePoint exact = {scope.is_hit ? (is_smaller ? -half_chord : half_chord) : 0, 0};
  const PlanePoint centre = {0, beside};
  const scene::Vector3& d = report.ray.direction;
  const double unit = scope.ulp / r * (report.pixel ? 1 : std::hypot(d.x, d.y, d.z));
  const PlanePoint origin = {-report.find("v")->rounded.front() / r, 0};
  const MicroscopeMark* const mark = mark_of(failing, scope);
  std::vector<PlanePoint> shown = {{-1, beside - 1}, {1, beside + 1}, exact};
  PlanePoint yours = {};
  const bool is_origin_near = std::abs(origin[0]) < kFarthest;
  if (is_origin_near) shown.push_back(origin);
  if (mark != nullptr) {
    yours = {exact[0] + mark->x * unit, mark->y * unit};
    if (std::hypot(yours[0], yours[1]) < kFarthest) shown.push_back(yours);
  }
  PlaneDrawing drawing(shown);
  const bool is_close =
      mark != nullptr && (scope.is_hit ? !drawing.tells_apart(yours, exact)
                                       : !drawing.tells_apart({0, 1}, {0, beside}));
  if (is_close) return magnified(scope, *mark);
  drawing.circle(centre, 1);
  std::string caption =
      fmt::format("To scale, in the plane of the ray and the centre of sphere {}: ",
                  panel.selection.sphere.value_or(0));
  if (is_origin_near) {
    drawing.line("behind", {drawing.left(0), origin});
    drawing.arrow("ray", origin, drawing.right(0));
    drawing.name_above("ray", origin, "L");
    caption += "the ray runs to the right from L";
  } else if (origin[0] < 0) {
    drawing.arrow("ray", drawing.left(0), drawing.right(0));
    caption += "the ray runs to the right, from far to the left";
  } else {
    drawing.line("behind", {drawing.left(0), drawing.right(0)});
    caption += fmt::format(
        "the ray begins {:.3g} radii to the right and runs away; dashes are its line, behind it",
        origin[0]);
  }
  const bool is_shown = mark != nullptr && drawing.shows(yours);
  drawing.answers(scope.is_hit ? std::optional(exact) : std::nullopt,
                  is_shown ? std::optional(yours) : std::nullopt);
  caption += scope.is_hit ? "; the ring is the exact hit" : "; exactly, it misses";
  if (mark == nullptr) {
    caption += ", yours is a miss.";
  } else if (is_shown) {
    caption += ", the cross is yours.";
  } else {
    caption += fmt::format(", yours is {:.3g} radii from there.",
                           std::hypot(yours[0] - exact[0], yours[1] - exact[1]));
  }
  return drawing.html(caption);
}

/// A sphere and where the ray is at it, turned around the ray into the drawing's plane.
struct TurnedSphere {
  PlanePoint centre;
  double radius;
  PlanePoint hit;
};

/// Lengths from the ray's origin; empty where the page has no panel of that sphere, or it is
/// missed.
std::optional<TurnedSphere> turned(const SceneView& figure, double sphere) {
  for (const Panel& panel : figure.panels) {
    const ExplainReport& report = panel.report;
    if (!panel.selection.sphere || static_cast<double>(*panel.selection.sphere) != sphere) continue;
    const SphereReport& exact = report.spheres[*report.sphere];
    const double r = report.scene.spheres[*report.sphere].radius;
    if (!exact.parameter || r < kSmallestRadius || r > kLargestRadius) return {};
    const double half_chord_sq = report.find("d^2")->rounded.front() / r / r;
    const double v = report.find("v")->rounded.front();
    const bool is_smaller = exact.intersection.root == reference::WhichRoot::kSmaller;
    const double half_chord = r * std::sqrt(std::max(0.0, half_chord_sq));
    return TurnedSphere{{v, r * std::sqrt(std::max(0.0, 1 - half_chord_sq))},
                        r,
                        {is_smaller ? v - half_chord : v + half_chord, 0}};
  }
  return {};
}

/// The sphere that the submission sees, and the one that is met first.
std::string nearest_html(const FailingCase& failing, const SceneView& figure) {
  const WrongAnswer& answer = failing.answer;
  if (answer.got.size() != 1 || answer.exact->size() != 1) return "";
  const auto got = turned(figure, answer.got.front());
  const auto exact = turned(figure, answer.exact->front());
  if (!got || !exact) return "";
  std::vector<PlanePoint> shown = {{0, 0}};
  for (const TurnedSphere& one : {*got, *exact}) {
    shown.push_back({one.centre[0] - one.radius, one.centre[1] - one.radius});
    shown.push_back({one.centre[0] + one.radius, one.centre[1] + one.radius});
  }
  PlaneDrawing drawing(shown);
  if (!drawing.tells_apart(got->hit, exact->hit)) return "";
  for (const TurnedSphere& one : {*got, *exact}) {
    if (!drawing.tells_apart(one.centre, {one.centre[0] + one.radius, one.centre[1]})) return "";
    drawing.circle(one.centre, one.radius);
  }
  drawing.arrow("ray", {0, 0}, drawing.right(0));
  drawing.name_below("ray", {0, 0}, "L");
  drawing.answers(exact->hit, got->hit);
  return drawing.html(
      fmt::format("To scale, each sphere turned around the ray into one plane: the ray runs to the "
                  "right from L and meets sphere {} first, the ring; the cross is where it meets "
                  "sphere {}, yours.",
                  answer.exact->front(), answer.got.front()));
}

/// Whether the wrong answer is what was answered about the case itself, not one that a law made of
/// it.
bool is_kept(const FailingCase& failing) {
  const WrongAnswer& answer = failing.answer;
  if (!failing.answers || !failing.answers->hits || !answer.place.sphere) return false;
  const auto hit = failing.answers->hits->find(*answer.place.sphere);
  if (hit == failing.answers->hits->end()) return answer.got.empty();
  const auto& [s, point] = hit->second;
  return answer.got == std::vector{s} || answer.got == std::vector{point.x, point.y, point.z};
}

/// Two vectors, or two points as they are seen from the eye.
std::string vectors_html(const FailingCase& failing) {
  using properties::Quantity;
  const WrongAnswer& answer = failing.answer;
  const scene::Scene& scene = failing.the_case.scene;
  const bool is_point =
      answer.quantity == Quantity::kPixelPoint || answer.quantity == Quantity::kRayOrigin;
  if (answer.got.size() != 3 || answer.exact->size() != 3 || !scene.camera) return "";
  const scene::Point3& eye = scene.camera->eye;
  const std::array<double, 3> from = {eye.x, eye.y, eye.z};
  double got_sq = 0, exact_sq = 0, product = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double got = answer.got[k] - (is_point ? from[k] : 0);
    const double exact = (*answer.exact)[k] - (is_point ? from[k] : 0);
    got_sq += got * got;
    exact_sq += exact * exact;
    product += got * exact;
  }
  const double length = std::sqrt(exact_sq);
  const double along = product / length;
  const PlanePoint exact = {length, 0};
  const PlanePoint got = {along, std::sqrt(std::max(0.0, got_sq - along * along))};
  if (!std::isfinite(got[0]) || !std::isfinite(got[1]) || !std::isnormal(length)) return "";
  PlaneDrawing drawing({{0, 0}, exact, got});
  if (!drawing.tells_apart(exact, got)) return "";
  // One may lie on the other.
  const bool is_longer = got_sq > exact_sq;
  if (is_longer) drawing.arrow("yours", {0, 0}, got);
  drawing.arrow("exact", {0, 0}, exact);
  if (!is_longer) drawing.arrow("yours", {0, 0}, got);
  drawing.name_below("exact", exact, "exact");
  drawing.name_above("yours", got, kYours);
  if (is_point) drawing.name_below("ray", {0, 0}, "E");
  return drawing.html(fmt::format(
      "To scale, in the plane of both: {0} as it is exactly, and yours{1}.", answer.symbol,
      is_point      ? ", seen from the eye E"
      : got_sq == 0 ? ", which is zero"
                    : ""));
}

}  // namespace

std::string drawing_html(const FailingCase& failing, const SceneView& figure) {
  using properties::Quantity;
  switch (failing.answer.quantity) {
    case Quantity::kFrame:
    case Quantity::kPixelPoint:
    case Quantity::kDirection:
    case Quantity::kUnitDefect:
    case Quantity::kRayOrigin:
      return vectors_html(failing);
    case Quantity::kClass:
    case Quantity::kRoot:
    case Quantity::kParameter:
    case Quantity::kHitPoint:
      if (figure.panels.empty() || !figure.panels.front().microscope) return "";
      return is_kept(failing) ? hit_html(failing, figure.panels.front()) : "";
    case Quantity::kNearestSphere:
      return nearest_html(failing, figure);
    default:
      return "";
  }
}

}  // namespace raycheck::tools
