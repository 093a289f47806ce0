#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace raycheck::tools {

/// A line of text in a plot, in pixels.
inline constexpr double kLine = 16;
/// About as wide as a text is in a sans-serif font of 12 pixels, and rather more.
double text_width(std::string_view text);

/// From (left, bottom), y upwards.
struct PlotBox {
  double left = 0, bottom = 0, width = 0, height = 0;

  bool overlaps(const PlotBox& other) const;
};

/// Places at least `gap` apart in the order of those wanted, from `low` to `high`, and as near to
/// them as that allows: the sum of squares of what they are moved by is the least. Where there is
/// no room for that gap, the widest that there is room for.
std::vector<double> spread_apart(const std::vector<double>& wanted, double gap, double low,
                                 double high);

/// What a name is to stand beside.
struct NamedPoint {
  double x = 0, y = 0;
  std::string name;
};

/// What no name is to stand on; a line is less of a nuisance.
struct PlotObstacle {
  PlotBox box;
  bool is_line = false;
};

/// Where a name stands. `joint`: the place of it that is nearest to its point.
struct PlacedName {
  PlotBox box;
  std::array<double, 2> joint = {};
  bool ends_here = false;     ///< Its end is nearer to the point than its beginning.
  bool needs_leader = false;  ///< It is not right beside its point, or nearer to another.
};

/// A place for each name, beside its point, within the frame, over no other name and no obstacle
/// where there is such a place, leaders crossing as little as may be.
/// Shape: one a point.
std::vector<PlacedName> names_beside(const std::vector<NamedPoint>& points,
                                     const std::vector<PlotObstacle>& obstacles,
                                     const PlotBox& frame);

}  // namespace raycheck::tools
