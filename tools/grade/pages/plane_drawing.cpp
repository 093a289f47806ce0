#include "tools/grade/pages/plane_drawing.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "tools/grade/pages/answered.h"
#include "tools/report/spelling.h"

namespace raycheck::tools {
namespace {

constexpr double kWidth = 360, kHeight = 220;  ///< Of a drawing, in its own pixels.
constexpr double kMargin = 26;                 ///< Around what it shows, for names.
constexpr double kAbove = -9, kBelow = 18;     ///< A name is so far below its mark.
constexpr double kSeen = 8;                    ///< Marks so far apart are told apart.
constexpr double kHalfLetter = 3.5;
constexpr double kRing = 5, kArm = 5;            ///< Of marks.
constexpr double kArrowHead = 9, kHalfHead = 4;  ///< Of arrows: how long, and half how wide.

}  // namespace

PlaneDrawing::PlaneDrawing(const std::vector<PlanePoint>& shown)
    : low_(shown.front()), high_(shown.front()) {
  for (const PlanePoint& point : shown) {
    for (std::size_t k = 0; k < 2; ++k) {
      low_[k] = std::min(low_[k], point[k]);
      high_[k] = std::max(high_[k], point[k]);
    }
  }
  scale_ = std::min((kWidth - 2 * kMargin) / (high_[0] - low_[0]),
                    (kHeight - 2 * kMargin) / (high_[1] - low_[1]));
}

bool PlaneDrawing::tells_apart(const PlanePoint& a, const PlanePoint& b) const {
  return std::hypot(a[0] - b[0], a[1] - b[1]) * scale_ >= kSeen;
}

bool PlaneDrawing::shows(const PlanePoint& point) const {
  return x(point) >= 0 && x(point) <= kWidth && y(point) >= 0 && y(point) <= kHeight;
}

PlanePoint PlaneDrawing::left(double up) const {
  return {(low_[0] + high_[0]) / 2 - kWidth / 2 / scale_, up};
}

PlanePoint PlaneDrawing::right(double up) const {
  return {(low_[0] + high_[0]) / 2 + kWidth / 2 / scale_, up};
}

void PlaneDrawing::circle(const PlanePoint& centre, double radius) {
  svg_ += fmt::format("<circle class=\"sphere\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.1f}\"/>",
                      x(centre), y(centre), radius * scale_);
}

void PlaneDrawing::line(const char* kind, const std::vector<PlanePoint>& points) {
  svg_ += fmt::format("<polyline class=\"{}\" points=\"", kind);
  for (const PlanePoint& point : points) svg_ += fmt::format("{:.1f},{:.1f} ", x(point), y(point));
  svg_ += "\"/>";
}

void PlaneDrawing::arrow(const char* kind, const PlanePoint& from, const PlanePoint& to) {
  line(kind, {from, to});
  const double length = std::hypot(x(to) - x(from), y(to) - y(from));
  if (length < 1) return;
  const double right = (x(to) - x(from)) / length, down = (y(to) - y(from)) / length;
  const double neck_x = x(to) - kArrowHead * right, neck_y = y(to) - kArrowHead * down;
  svg_ += fmt::format("<path class=\"{}\" d=\"M{:.1f},{:.1f}L{:.1f},{:.1f}L{:.1f},{:.1f}\"/>", kind,
                      neck_x - kHalfHead * down, neck_y + kHalfHead * right, x(to), y(to),
                      neck_x + kHalfHead * down, neck_y - kHalfHead * right);
}

void PlaneDrawing::answers(const std::optional<PlanePoint>& exact,
                           const std::optional<PlanePoint>& yours) {
  const bool is_above = !exact || !yours || (*yours)[1] >= (*exact)[1];
  if (exact) {
    svg_ += fmt::format("<circle class=\"exact\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{}\"/>", x(*exact),
                        y(*exact), kRing);
    name("exact", *exact, is_above ? kBelow : kAbove, "exact");
  }
  if (!yours) return;
  svg_ += fmt::format(
      "<path class=\"yours\" "
      "d=\"M{0:.1f},{2:.1f}L{1:.1f},{3:.1f}M{0:.1f},{3:.1f}L{1:.1f},{2:.1f}\"/>",
      x(*yours) - kArm, x(*yours) + kArm, y(*yours) - kArm, y(*yours) + kArm);
  name("yours", *yours, is_above ? kAbove : kBelow, kYours);
}

void PlaneDrawing::name_above(const char* kind, const PlanePoint& point, std::string_view text) {
  name(kind, point, kAbove, text);
}

void PlaneDrawing::name_below(const char* kind, const PlanePoint& point, std::string_view text) {
  name(kind, point, kBelow, text);
}

std::string PlaneDrawing::html(const std::string& caption) const {
  return fmt::format(
      "<figure class=\"drawing\"><svg viewBox=\"0 0 {0:.0f} {1:.0f}\" role=\"img\" "
      "aria-label=\"{2}\">{3}</svg><figcaption>{2}</figcaption></figure>\n",
      kWidth, kHeight, escaped(caption), svg_);
}

double PlaneDrawing::x(const PlanePoint& point) const {
  return kWidth / 2 + (point[0] - (low_[0] + high_[0]) / 2) * scale_;
}

double PlaneDrawing::y(const PlanePoint& point) const {
  return kHeight / 2 - (point[1] - (low_[1] + high_[1]) / 2) * scale_;
}

void PlaneDrawing::name(const char* kind, const PlanePoint& point, double below,
                        std::string_view text) {
  const double room = kHalfLetter * static_cast<double>(text.size());
  svg_ += fmt::format("<text class=\"{}\" x=\"{:.1f}\" y=\"{:.1f}\">{}</text>", kind,
                      std::clamp(x(point), room, kWidth - room),
                      std::clamp(y(point) + below, 12.0, kHeight - 4), escaped(text));
}

}  // namespace raycheck::tools
