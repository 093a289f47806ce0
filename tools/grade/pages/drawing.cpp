#include "tools/grade/pages/drawing.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "properties/quantity.h"
#include "tools/grade/pages/answered.h"
#include "tools/report/html_text.h"
#include "tools/report/words.h"

namespace raycheck::tools {
namespace {

using Place = std::array<double, 2>;  ///< Of a plane: to the right and up.

constexpr double kWidth = 360, kHeight = 220;  ///< Of a drawing, in its own pixels.
constexpr double kMargin = 26;                 ///< Around what it shows, for names.
constexpr double kAbove = -9, kBelow = 18;     ///< A mark its name is, in pixels down.
constexpr double kSeen = 8;                    ///< Marks so many pixels apart are told apart.
constexpr double kWidestGrid =
    16;                          ///< Half of the window, in ulp, in which doubles are told apart.
constexpr double kFarthest = 6;  ///< What is so many radii beyond a sphere is beyond the drawing.
/// Radii whose squares are ordinary doubles.
constexpr double kSmallestRadius = 0x1p-500, kLargestRadius = 0x1p500;

/// A window of the plane, and what is drawn in it.
class Drawing {
 public:
  /// Shows all of these places.
  explicit Drawing(const std::vector<Place>& shown) : low_(shown.front()), high_(shown.front()) {
    for (const Place& place : shown) {
      for (std::size_t k = 0; k < 2; ++k) {
        low_[k] = std::min(low_[k], place[k]);
        high_[k] = std::max(high_[k], place[k]);
      }
    }
    scale_ = std::min((kWidth - 2 * kMargin) / (high_[0] - low_[0]),
                      (kHeight - 2 * kMargin) / (high_[1] - low_[1]));
  }

  bool tells_apart(const Place& a, const Place& b) const {
    return std::hypot(a[0] - b[0], a[1] - b[1]) * scale_ >= kSeen;
  }
  bool shows(const Place& place) const {
    return x(place) >= 0 && x(place) <= kWidth && y(place) >= 0 && y(place) <= kHeight;
  }
  /// The left and the right end of what is drawn at a height.
  Place left(double up) const { return {(low_[0] + high_[0]) / 2 - kWidth / 2 / scale_, up}; }
  Place right(double up) const { return {(low_[0] + high_[0]) / 2 + kWidth / 2 / scale_, up}; }

  void circle(const Place& centre, double radius) {
    svg_ += fmt::format("<circle class=\"sphere\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.1f}\"/>",
                        x(centre), y(centre), radius * scale_);
  }
  void line(const char* kind, const std::vector<Place>& places) {
    svg_ += fmt::format("<polyline class=\"{}\" points=\"", kind);
    for (const Place& place : places) svg_ += fmt::format("{:.1f},{:.1f} ", x(place), y(place));
    svg_ += "\"/>";
  }
  void arrow(const char* kind, const Place& from, const Place& to) {
    line(kind, {from, to});
    const double length = std::hypot(x(to) - x(from), y(to) - y(from));
    if (length < 1) return;
    constexpr double kHead = 9, kHalf = 4;
    const double right = (x(to) - x(from)) / length, down = (y(to) - y(from)) / length;
    svg_ += fmt::format(
        "<path class=\"{0}\" d=\"M{1:.1f},{2:.1f}L{3:.1f},{4:.1f}L{5:.1f},{6:.1f}\"/>", kind,
        x(to) - kHead * right - kHalf * down, y(to) - kHead * down + kHalf * right, x(to), y(to),
        x(to) - kHead * right + kHalf * down, y(to) - kHead * down - kHalf * right);
  }
  /// Both answers, their names on either side.
  void answers(const std::optional<Place>& exact, const std::optional<Place>& yours) {
    const bool is_above = !exact || !yours || (*yours)[1] >= (*exact)[1];
    if (exact) {
      svg_ += fmt::format("<circle class=\"exact\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"5\"/>",
                          x(*exact), y(*exact));
      name("exact", *exact, is_above ? kBelow : kAbove, "exact");
    }
    if (!yours) return;
    constexpr double kArm = 5;
    svg_ += fmt::format(
        "<path class=\"yours\" "
        "d=\"M{0:.1f},{2:.1f}L{1:.1f},{3:.1f}M{0:.1f},{3:.1f}L{1:.1f},{2:.1f}\"/>",
        x(*yours) - kArm, x(*yours) + kArm, y(*yours) - kArm, y(*yours) + kArm);
    name("yours", *yours, is_above ? kAbove : kBelow, kYours);
  }
  /// A name, so many pixels below a place.
  void name(const char* kind, const Place& place, double below, std::string_view text) {
    const double room = 3.5 * static_cast<double>(text.size());
    svg_ += fmt::format("<text class=\"{}\" x=\"{:.1f}\" y=\"{:.1f}\">{}</text>", kind,
                        std::clamp(x(place), room, kWidth - room),
                        std::clamp(y(place) + below, 12.0, kHeight - 4), escaped(text));
  }

  std::string html(const std::string& caption) const {
    return fmt::format(
        "<figure class=\"drawing\"><svg viewBox=\"0 0 {0:.0f} {1:.0f}\" role=\"img\" "
        "aria-label=\"{2}\">{3}</svg><figcaption>{2}</figcaption></figure>\n",
        kWidth, kHeight, escaped(caption), svg_);
  }

 private:
  double x(const Place& place) const {
    return kWidth / 2 + (place[0] - (low_[0] + high_[0]) / 2) * scale_;
  }
  double y(const Place& place) const {
    return kHeight / 2 - (place[1] - (low_[1] + high_[1]) / 2) * scale_;
  }

  Place low_, high_;
  double scale_ = 1;
  std::string svg_;
};

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
  const Place place = {yours.x, yours.y};
  const double reach = std::max(std::abs(yours.x), std::abs(yours.y));
  const auto zoom =
      std::find_if(scope.zooms.begin(), scope.zooms.end(),
                   [&](const Microscope::Zoom& one) { return one.half_width * 0.9 >= reach; });
  if (zoom == scope.zooms.end()) return "";
  const double half = zoom->half_width;
  Drawing drawing({{-half, -half / 2}, {half, half / 2}});
  for (const double one : scope.grid) {
    if (half <= kWidestGrid && std::abs(one) <= half)
      drawing.line("grid", {{one, -half}, {one, half}});
  }
  std::vector<Place> curve(zoom->curve.begin(), zoom->curve.end());
  if (!curve.empty()) drawing.line("sphere", curve);
  drawing.arrow("ray", drawing.left(0), drawing.right(0));
  drawing.answers(Place{0, 0}, place);
  return drawing.html(fmt::format(
      "Magnified around {}, s = {:.17g}: the ray runs to the right, the curve is the sphere{}; the "
      "cross, yours, is off by {:.3g} steps from one double to the next.",
      scope.is_hit ? "the exact hit" : "the ray's point nearest to the centre", scope.parameter,
      half <= kWidestGrid ? ", upright lines are the doubles next to s" : "",
      std::hypot(yours.x, yours.y)));
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
  const Place exact = {scope.is_hit ? (is_smaller ? -half_chord : half_chord) : 0, 0};
  const Place centre = {0, beside};
  const scene::Vector3& d = report.ray.direction;
  const double unit = scope.ulp / r * (report.pixel ? 1 : std::hypot(d.x, d.y, d.z));
  const Place origin = {-report.find("v")->rounded.front() / r, 0};
  const MicroscopeMark* const mark = mark_of(failing, scope);
  std::vector<Place> shown = {{-1, beside - 1}, {1, beside + 1}, exact};
  Place yours = {};
  const bool is_origin_near = std::abs(origin[0]) < kFarthest;
  if (is_origin_near) shown.push_back(origin);
  if (mark != nullptr) {
    yours = {exact[0] + mark->x * unit, mark->y * unit};
    if (std::hypot(yours[0], yours[1]) < kFarthest) shown.push_back(yours);
  }
  Drawing drawing(shown);
  const bool is_close =
      mark != nullptr && (scope.is_hit ? !drawing.tells_apart(yours, exact)
                                       : !drawing.tells_apart({0, 1}, {0, beside}));
  if (is_close) return magnified(scope, *mark);
  drawing.circle(centre, 1);
  drawing.arrow("ray", is_origin_near ? origin : drawing.left(0), drawing.right(0));
  if (is_origin_near) drawing.name("ray", origin, kAbove, "L");
  std::string caption = fmt::format(
      "To scale, in the plane of the ray and the centre of sphere {}: the ray runs to the right",
      panel.selection.sphere.value_or(0));
  caption += is_origin_near ? " from L" : ", from far to the left";
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
  const Place exact = {length, 0};
  const Place got = {along, std::sqrt(std::max(0.0, got_sq - along * along))};
  if (!std::isfinite(got[0]) || !std::isfinite(got[1]) || !std::isnormal(length)) return "";
  Drawing drawing({{0, 0}, exact, got});
  if (!drawing.tells_apart(exact, got)) return "";
  // One may lie on the other.
  const bool is_longer = got_sq > exact_sq;
  if (is_longer) drawing.arrow("yours", {0, 0}, got);
  drawing.arrow("exact", {0, 0}, exact);
  if (!is_longer) drawing.arrow("yours", {0, 0}, got);
  drawing.name("exact", exact, kBelow, "exact");
  drawing.name("yours", got, kAbove, kYours);
  if (is_point) drawing.name("ray", {0, 0}, kBelow, "E");
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
    default:
      return "";
  }
}

}  // namespace raycheck::tools
