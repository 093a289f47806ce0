#include "tools/report/plot/plot_labels.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <optional>

namespace raycheck::tools {
namespace {

constexpr std::array<double, 9> kAways = {11, 17, 26, 38, 52, 70, 92, 120, 155};  ///< Pixels.
constexpr int kTurns = 24;           ///< Directions in which a name may stand.
constexpr int kRounds = 4;           ///< How often every name is placed anew among the others.
constexpr double kNeedsLeader = 14;  ///< Pixels.
constexpr double kMuchNearer = 4;    ///< Pixels by which its own point is to be the nearest.

// What it costs, in pixels farther from the point.
constexpr double kOnName = 4000;
constexpr double kOnObstacle = 800;
constexpr double kOnLine = 40;
constexpr double kLeaderOnName = 250;
constexpr double kLeaderOnObstacle = 60;
constexpr double kLeadersCross = 120;
constexpr double kNotBeside = 6;  ///< A name reads best at the right or the left of its point.

using Point = std::array<double, 2>;

double side(const Point& a, const Point& b, const Point& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

bool cross(const Point& a, const Point& b, const Point& c, const Point& d) {
  return side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0;
}

bool crosses(const Point& a, const Point& b, const PlotBox& box) {
  const Point corners[] = {{box.left, box.bottom},
                           {box.left + box.width, box.bottom + box.height},
                           {box.left, box.bottom + box.height},
                           {box.left + box.width, box.bottom}};
  return cross(a, b, corners[0], corners[1]) || cross(a, b, corners[2], corners[3]);
}

bool holds(const PlotBox& box, const Point& point) {
  return point[0] >= box.left && point[0] <= box.left + box.width && point[1] >= box.bottom &&
         point[1] <= box.bottom + box.height;
}

double distance_to(const PlotBox& box, const NamedPoint& point) {
  return std::hypot(point.x - std::clamp(point.x, box.left, box.left + box.width),
                    point.y - std::clamp(point.y, box.bottom, box.bottom + box.height));
}

PlacedName placed_at(const NamedPoint& point, double away, double angle) {
  const double width = text_width(point.name);
  PlacedName placed;
  placed.box = {point.x + (away + width / 2) * std::cos(angle) - width / 2,
                point.y + (away + kLine / 2) * std::sin(angle) - kLine / 2, width, kLine};
  const PlotBox& box = placed.box;
  placed.joint = {std::clamp(point.x, box.left, box.left + box.width),
                  std::clamp(point.y, box.bottom, box.bottom + box.height)};
  placed.ends_here = box.left + width / 2 < point.x;
  placed.needs_leader = distance_to(box, point) > kNeedsLeader;
  return placed;
}

bool is_within(const PlotBox& box, const PlotBox& frame) {
  return box.left >= frame.left && box.bottom >= frame.bottom &&
         box.left + box.width <= frame.left + frame.width &&
         box.bottom + box.height <= frame.bottom + frame.height;
}

/// Names being placed; those without a place yet stand in nobody's way.
struct Placing {
  const std::vector<NamedPoint>& points;
  const std::vector<PlotObstacle>& obstacles;
  std::vector<std::optional<PlacedName>> names;

  double cost(std::size_t k, const PlacedName& candidate) const {
    const Point from = {points[k].x, points[k].y};
    double sum = std::hypot(candidate.joint[0] - from[0], candidate.joint[1] - from[1]);
    if (std::abs(candidate.box.bottom + kLine / 2 - from[1]) > 1) sum += kNotBeside;
    for (const PlotObstacle& one : obstacles) {
      if (candidate.box.overlaps(one.box)) sum += one.is_line ? kOnLine : kOnObstacle;
      if (!one.is_line && !holds(one.box, from) && crosses(from, candidate.joint, one.box)) {
        sum += kLeaderOnObstacle;
      }
    }
    for (std::size_t other = 0; other < names.size(); ++other) {
      if (other == k || !names[other]) continue;
      const PlacedName& its = *names[other];
      const Point its_from = {points[other].x, points[other].y};
      if (candidate.box.overlaps(its.box)) sum += kOnName;
      if (crosses(from, candidate.joint, its.box)) sum += kLeaderOnName;
      if (its.needs_leader && crosses(its_from, its.joint, candidate.box)) sum += kLeaderOnName;
      if (cross(from, candidate.joint, its_from, its.joint)) sum += kLeadersCross;
    }
    return sum;
  }

  void place(std::size_t k, const PlotBox& frame) {
    double least = std::numeric_limits<double>::infinity();
    std::optional<PlacedName> best;
    for (const double away : kAways) {
      for (int turn = 0; turn < kTurns; ++turn) {
        const PlacedName candidate =
            placed_at(points[k], away, 2 * std::numbers::pi * turn / kTurns);
        if (!is_within(candidate.box, frame)) continue;
        const double cost_here = cost(k, candidate);
        if (cost_here >= least) continue;
        least = cost_here;
        best = candidate;
      }
    }
    names[k] = best ? *best : placed_at(points[k], kAways.front(), 0);
  }
};

}  // namespace

double text_width(std::string_view text) {
  constexpr std::string_view kNarrow = "fijlrt-.,:;'!|/ ()[]{}";
  constexpr std::string_view kWide = "mwMW@%";
  double width = 4;
  for (const char c : text) {
    width += kNarrow.find(c) != kNarrow.npos ? 5.2 : kWide.find(c) != kWide.npos ? 11.5 : 7.7;
  }
  return width;
}

bool PlotBox::overlaps(const PlotBox& other) const {
  return left < other.left + other.width && other.left < left + width &&
         bottom < other.bottom + other.height && other.bottom < bottom + height;
}

std::vector<double> spread_apart(const std::vector<double>& wanted, double gap, double low,
                                 double high) {
  if (wanted.empty()) return {};
  const auto count = static_cast<double>(wanted.size());
  if (count > 1) gap = std::min(gap, (high - low) / (count - 1));
  std::vector<std::size_t> order(wanted.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return wanted[a] < wanted[b]; });
  // Less k gaps, the k-th places are to increase: neighbours that do not are pooled at their mean.
  struct Pool {
    double sum = 0;
    double count = 0;
    double mean() const { return sum / count; }
  };
  std::vector<Pool> pools;
  for (std::size_t k = 0; k < order.size(); ++k) {
    pools.push_back({wanted[order[k]] - gap * static_cast<double>(k), 1});
    while (pools.size() > 1 && pools[pools.size() - 2].mean() >= pools.back().mean()) {
      const Pool last = pools.back();
      pools.pop_back();
      pools.back().sum += last.sum;
      pools.back().count += last.count;
    }
  }
  std::vector<double> places(wanted.size());
  std::size_t k = 0;
  for (const Pool& pool : pools) {
    const double place = std::clamp(pool.mean(), low, high - gap * (count - 1));
    for (double left = pool.count; left > 0; --left, ++k) {
      places[order[k]] = place + gap * static_cast<double>(k);
    }
  }
  return places;
}

std::vector<PlacedName> names_beside(const std::vector<NamedPoint>& points,
                                     const std::vector<PlotObstacle>& obstacles,
                                     const PlotBox& frame) {
  Placing placing{points, obstacles, std::vector<std::optional<PlacedName>>(points.size())};
  for (int round = 0; round < kRounds; ++round) {
    for (std::size_t k = 0; k < points.size(); ++k) placing.place(k, frame);
  }
  std::vector<PlacedName> names;
  for (std::size_t k = 0; k < points.size(); ++k) {
    names.push_back(*placing.names[k]);
    const PlotBox& box = names.back().box;
    for (const NamedPoint& other : points) {
      const bool is_nearer = distance_to(box, other) < distance_to(box, points[k]) + kMuchNearer;
      if (&other != &points[k] && is_nearer) names.back().needs_leader = true;
    }
  }
  return names;
}

}  // namespace raycheck::tools
