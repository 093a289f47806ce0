#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace raycheck::tools {

/// Of a plane: to the right and up.
using PlanePoint = std::array<double, 2>;

/// A window of a plane, and what is drawn in it: SVG in colours of the page, told apart by their
/// shapes, too. Kinds are classes of the page's style.
class PlaneDrawing {
 public:
  /// Shows all of these points.
  explicit PlaneDrawing(const std::vector<PlanePoint>& shown);

  /// Whether marks at two points are seen to be two.
  bool tells_apart(const PlanePoint& a, const PlanePoint& b) const;
  bool shows(const PlanePoint& point) const;
  /// The left and the right end of what is drawn at a height.
  PlanePoint left(double up) const;
  PlanePoint right(double up) const;

  void circle(const PlanePoint& centre, double radius);
  void line(const char* kind, const std::vector<PlanePoint>& points);
  void arrow(const char* kind, const PlanePoint& from, const PlanePoint& to);
  /// A ring for the exact answer and a cross for the student's, their names on either side.
  void answers(const std::optional<PlanePoint>& exact, const std::optional<PlanePoint>& yours);
  void name_above(const char* kind, const PlanePoint& point, std::string_view text);
  void name_below(const char* kind, const PlanePoint& point, std::string_view text);

  /// The drawing above its caption, which says all of it in words.
  std::string html(const std::string& caption) const;

 private:
  double x(const PlanePoint& point) const;  ///< In the drawing's pixels, y from its top.
  double y(const PlanePoint& point) const;
  void name(const char* kind, const PlanePoint& point, double below, std::string_view text);

  PlanePoint low_, high_;
  double scale_;
  std::string svg_;
};

}  // namespace raycheck::tools
