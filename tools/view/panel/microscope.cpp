#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "reference/error_measure.h"
#include "scene/interruption.h"
#include "scene/text.h"
#include "tools/report/words.h"
#include "tools/view/panel/panel.h"

namespace raycheck::tools {
namespace {

using reference::Enclosure;
using reference::Enclosure3;

/// Thrown if, at some precision, the enclosure of a number is too wide.
struct TooWide : std::runtime_error {
  TooWide() : std::runtime_error("more bits are needed") {}
};

/// Enclosures of shown numbers have at most a relative width of 2^-kToldBits. Distances below
/// kNothing ulp are invisible and shown as 0.
constexpr int kToldBits = 34;
constexpr double kNothing = 0x1p-30;

/// The half width of the first window, in ulp. Each further window is wider by a factor.
constexpr double kFirstHalfWidth = 4;
constexpr double kZoomFactor = 2;
constexpr double kLargestHalfWidth = 0x1p60;
constexpr int kCurveSteps = 8;  ///< Steps for half a curve.
/// Curves that bend by less than this share of a window are drawn straight.
constexpr double kStraight = 0x1p-10;
constexpr int kGridSteps = 8;  ///< The number of doubles on each side of s.
/// Lengths from 2^-1074 to 2^1024 in one scene need some 2,100 bits, and as many more cancel.
constexpr int kMostMicroscopeBits = 6144;

struct MicroscopeMark {
  std::string method;
  std::size_t number = 0;  ///< Its index among all methods, which determines shape and colour.
  /// Whether the mark is its hit point. If not, it is its s on the exact ray.
  bool is_point = false;
  double x = 0, y = 0;
  bool is_wrong = false;
  std::string text;
};

/// The contents of the microscope, in ulp.
struct Microscope {
  scene::Precision precision = scene::Precision::kDouble;
  bool is_hit = false;
  double parameter = 0;  ///< s of the exact point, correctly rounded.
  double ulp = 0;
  double gap = 0;  ///< The distance from the ray to the sphere, for a miss.
  /// The distance by which a relative change u of the inputs may move s; empty if there is no
  /// bound.
  std::optional<double> region;
  std::vector<MicroscopeMark> marks;
};

double middle(const Enclosure& value) {
  const double low = value.lower(), high = value.upper();
  if (std::abs(low) < kNothing && std::abs(high) < kNothing) return 0;
  if (!value.is_within(kToldBits)) throw TooWide();
  return low / 2 + high / 2;
}

/// The gap between numbers of a format around a number.
double ulp_at(double value, scene::Precision precision) {
  const double size = std::abs(value);
  const double above = scene::next_after(precision, size, HUGE_VAL);
  return std::isfinite(above) ? above - scene::next_after(precision, above, 0)
                              : size - scene::next_after(precision, size, 0);
}

Enclosure3 scaled(const Enclosure3& v, const Enclosure& factor) {
  return {v.x * factor, v.y * factor, v.z * factor};
}

/// Any unit vector at right angles to a unit vector.
Enclosure3 across(const Enclosure3& d, int bits) {
  const double x = std::abs(d.x.lower()), y = std::abs(d.y.lower()), z = std::abs(d.z.lower());
  Enclosure3 least = {Enclosure(0.0, bits), Enclosure(0.0, bits), Enclosure(0.0, bits)};
  (x <= y && x <= z ? least.x : y <= z ? least.y : least.z) = Enclosure(1.0, bits);
  const Enclosure3 normal = cross(d, least);
  return scaled(normal, Enclosure(1.0, bits) / norm(normal));
}

/// The plane of the microscope at one precision: its origin, axes and unit.
class Plane {
 public:
  Plane(const reference::ExactRay& ray, const scene::Sphere& sphere,
        const reference::Intersection& exact, double ulp, int bits)
      : bits_(bits),
        hits_(exact.hit_class != reference::HitClass::kMiss),
        radius_(sphere.radius, bits) {
    const auto enclosed = ray.enclose(bits);
    along_ = enclosed.direction();
    const Enclosure length = ray.source().camera ? Enclosure(1.0, bits) : enclosed.length();
    unit_ = Enclosure(ulp, bits) * length;
    const Enclosure v = enclosed.axial_distance(sphere);
    const Enclosure3 ray_origin = enclosed.origin();
    parameter_ = hits_ ? enclosed.parameter(sphere, exact) : v / length;
    const Enclosure distance = hits_ ? parameter_ * length : v;
    const Enclosure3 way = scaled(along_, distance);
    origin_ = {ray_origin.x + way.x, ray_origin.y + way.y, ray_origin.z + way.z};
    const Enclosure3 to_foot = scaled(along_, v);
    const Enclosure3 to_centre = reference::enclose_exactly(sphere.centre) - ray_origin - to_foot;
    const Enclosure b = norm(to_centre);
    // If the line passes through the centre, there is no side; enclosures cannot prove this.
    const bool is_central = b.contains_zero();
    if (is_central && bits < kMostMicroscopeBits / 2) throw TooWide();
    normal_ = is_central ? across(along_, bits) : scaled(to_centre, Enclosure(1.0, bits) / b);
    centre_x_ = hits_ ? v - distance : Enclosure(0.0, bits);
    centre_y_ = is_central ? Enclosure(0.0, bits) : b;
    gap_ = hits_ ? Enclosure(0.0, bits) : centre_y_ - radius_;
  }

  /// The distance of a parameter from the exact parameter, in ulp.
  Enclosure x_of(double parameter, double ulp) const {
    return (Enclosure(parameter, bits_) - parameter_) / Enclosure(ulp, bits_);
  }
  std::array<double, 2> place_of(const std::vector<double>& point) const {
    const Enclosure3 offset =
        reference::enclose_exactly(scene::Point3{point[0], point[1], point[2]}) - origin_;
    return {middle(dot(offset, along_) / unit_), middle(dot(offset, normal_) / unit_)};
  }
  /// The distance of the sphere from the ray, for a miss.
  double gap() const { return middle(gap_ / unit_); }

  /// The exact circle in a window, drawn from its point nearest to the middle in both directions. A
  /// circle that is smaller than the window is drawn completely.
  std::vector<std::array<double, 2>> circle(double half_width) const {
    const Enclosure r = radius_ / unit_;
    if (radius_.contains_zero()) return {};
    if (!hits_ && (gap_ / unit_).lower() > half_width) return {};
    // From that point, the circle goes along `tangent` and bends along `inward`.
    const Enclosure zero(0.0, bits_), one(1.0, bits_);
    const Enclosure inward_x = hits_ ? centre_x_ / radius_ : zero;
    const Enclosure inward_y = hits_ ? centre_y_ / radius_ : one;
    const double reach = 1.5 * half_width;
    const bool whole = r.upper() < reach;
    std::vector<std::array<double, 2>> points;
    const auto add = [&](double share, bool far_side) {
      const Enclosure t = whole ? r * Enclosure(share, bits_) : Enclosure(share * reach, bits_);
      const Enclosure root = sqrt(r * r - t * t);
      const Enclosure depth = far_side ? r + root : t * t / (r + root);
      points.push_back({middle(depth * inward_x - t * inward_y),
                        middle(gap_ / unit_ + depth * inward_y + t * inward_x)});
    };
    const double bend = reach * reach / (2 * r.lower());
    const int steps = bend < kStraight * half_width ? 1 : kCurveSteps;
    for (int k = -steps; k <= steps; ++k) {
      const double share = static_cast<double>(k) / steps;
      add(whole ? std::sin(share * std::numbers::pi / 2) : share, false);
    }
    for (int k = kCurveSteps; whole && k >= -kCurveSteps; --k) {
      add(std::sin(static_cast<double>(k) / kCurveSteps * std::numbers::pi / 2), true);
    }
    return points;
  }

 private:
  int bits_;
  bool hits_;
  Enclosure radius_, unit_, parameter_, centre_x_, centre_y_, gap_;
  Enclosure3 along_, normal_, origin_;
};

/// The index of a method among all methods of raycheck; external candidates come after these.
std::size_t number_of(const MethodReport& method) {
  const auto all = all_intersect_methods();
  return static_cast<std::size_t>(
      std::ranges::find_if(all, [&](const auto* one) { return one->name == method.name; }) -
      all.begin());
}

void add_marks(const ExplainReport& report, const Plane& plane, Microscope& scope) {
  for (const MethodReport& method : report.methods) {
    if (!method.intersects || !method.parameter || !std::isfinite(*method.parameter)) continue;
    MicroscopeMark mark;
    mark.method = method.name;
    mark.number = number_of(method);
    mark.is_wrong = !method.goes_wrong_at.empty();
    mark.text = fmt::format("s = {:.17g}", *method.parameter);
    mark.x = middle(plane.x_of(*method.parameter, scope.ulp));
    mark.y = 0;
    scope.marks.push_back(mark);
    for (const MethodStep& step : method.steps) {
      const bool is_point =
          step.symbol == "Q" && step.value.size() == 3 &&
          std::ranges::all_of(step.value, [](double x) { return std::isfinite(x); });
      if (!is_point) continue;
      const auto [x, y] = plane.place_of(step.value);
      mark.is_point = true;
      mark.text = fmt::format("Q = ({:.17g}, {:.17g}, {:.17g})", step.value[0], step.value[1],
                              step.value[2]);
      mark.x = x;
      mark.y = y;
      scope.marks.push_back(mark);
    }
  }
}

struct Zoom {
  double half_width;
  std::vector<std::array<double, 2>> curve;  ///< The exact circle.
};

/// The first window, and those wider windows that show something new.
std::vector<Zoom> zooms_of(const Plane& plane, const Microscope& scope) {
  std::vector<Zoom> zooms;
  std::vector<double> distances = {0, std::abs(scope.gap)};
  for (const MicroscopeMark& mark : scope.marks) {
    distances.push_back(std::max(std::abs(mark.x), std::abs(mark.y)));
  }
  double before = -1;
  for (double half = kFirstHalfWidth; half <= kLargestHalfWidth; half *= kZoomFactor) {
    const bool shows_more = std::ranges::any_of(
        distances, [&](double distance) { return distance > before && distance <= half * 0.9; });
    if (!shows_more) continue;
    zooms.push_back({half, plane.circle(half)});
    before = half * 0.9;
  }
  return zooms;
}

/// The narrowest window that shows a mark; if there is none, the widest. A window is at least half
/// as high as it is wide.
std::size_t window_of(const MicroscopeMark& mark, const std::vector<Zoom>& zooms) {
  const auto found = std::ranges::find_if(zooms, [&](const Zoom& zoom) {
    return std::abs(mark.x) <= zoom.half_width && std::abs(mark.y) <= zoom.half_width / 2;
  });
  const auto index = static_cast<std::size_t>(found - zooms.begin());
  return zooms.empty() ? 0 : std::min(index, zooms.size() - 1);
}

/// Sentences about the centre, the unit, the distance of the sphere for a miss, and the methods
/// that cannot be drawn.
std::vector<std::string> sentences_of(const Microscope& microscope, const ExplainReport& report) {
  const bool is_single = microscope.precision == scene::Precision::kSingle;
  std::vector<std::string> sentences = {
      fmt::format("Around the {}, s = {:.17g}{}. 1 ulp = {:.3g}{}.",
                  microscope.is_hit ? "exact hit point" : "ray's point nearest to the centre",
                  microscope.parameter, direction_remark(report), microscope.ulp,
                  is_single ? ", of a float: the candidate's format" : "")};
  if (microscope.is_hit) {
    sentences.push_back(
        microscope.region ? fmt::format("Shaded: rounding the inputs moves s by up to {:.6g} ulp.",
                                        *microscope.region)
                          : "Shaded: rounding the inputs may move s anywhere.");
  } else {
    std::string text =
        fmt::format("A miss has no hit point; here the ray is {:.3g} ulp from the sphere",
                    std::abs(microscope.gap));
    double nearest = HUGE_VAL;
    for (const MicroscopeMark& mark : microscope.marks) {
      nearest = std::min(nearest, std::max(std::abs(mark.x), std::abs(mark.y)));
    }
    if (nearest < HUGE_VAL) {
      text += fmt::format(", and the nearest hit that a method claims is {:.3g} ulp away", nearest);
    }
    sentences.push_back(text + ".");
  }
  Grouped<std::string> absent;  // names by verdict
  for (const MethodReport& method : report.methods) {
    const bool is_drawn = std::ranges::any_of(
        microscope.marks, [&](const MicroscopeMark& mark) { return mark.method == method.name; });
    if (!method.intersects || is_drawn) continue;
    add_to(absent, method_verdict(method, report), method.name);
  }
  for (const auto& [verdict, names] : absent) {
    sentences.push_back(fmt::format("Not drawn: {}: {}.", scene::joined(names), verdict));
  }
  return sentences;
}

std::string six_digits(double value) { return fmt::format("{:.6g}", value); }

Json zoom_json(const Zoom& zoom) {
  const auto place_json = [](const std::array<double, 2>& place) {
    return Json{six_digits(place[0]), six_digits(place[1])};
  };
  return {{"half", six_digits(zoom.half_width)}, {"curve", list_json(zoom.curve, place_json)}};
}

Json look(const ExplainReport& report, const reference::ExactRay& ray, const scene::Sphere& sphere,
          int bits) {
  const SphereReport& exact = report.spheres[*report.sphere];
  const reference::Intersection& at = exact.intersection;
  Microscope scope;
  if (report.other) scope.precision = report.other->precision;
  scope.is_hit = at.hit_class != reference::HitClass::kMiss;
  const Step* const v = report.find("v");
  const double length = ray.source().camera ? 1 : ray.enclose(bits).length().lower();
  scope.parameter = scope.is_hit ? *exact.parameter : v->rounded.front() / length;
  if (!std::isfinite(scope.parameter)) throw TooWide();
  scope.ulp = ulp_at(scope.parameter, scope.precision);
  if (!std::isfinite(scope.ulp)) throw TooWide();
  const Plane plane(ray, sphere, at, scope.ulp, bits);
  if (!scope.is_hit) scope.gap = plane.gap();
  add_marks(report, plane, scope);
  const Step* const s = scope.is_hit ? report.find("s") : nullptr;
  if (s != nullptr && s->condition && std::isfinite(*s->condition)) {
    scope.region = *s->condition * scene::unit_roundoff(scope.precision) *
                   std::abs(scope.parameter) / scope.ulp;
  }
  const std::vector<Zoom> zooms = zooms_of(plane, scope);
  Json grid = Json::array();
  double neighbour = scope.parameter;
  for (int k = 0; k < kGridSteps; ++k)
    neighbour = scene::next_after(scope.precision, neighbour, -HUGE_VAL);
  for (int k = -kGridSteps; k <= kGridSteps && std::isfinite(neighbour); ++k) {
    grid.push_back(six_digits(middle(plane.x_of(neighbour, scope.ulp))));
    neighbour = scene::next_after(scope.precision, neighbour, HUGE_VAL);
  }
  const auto mark_json = [&](const MicroscopeMark& mark) {
    return Json{{"name", mark.method},
                {"number", mark.number},
                {"kind", mark.is_point ? "Q" : "s"},
                {"x", six_digits(mark.x)},
                {"y", six_digits(mark.y)},
                {"wrong", mark.is_wrong},
                {"text", mark.text},
                {"window", window_of(mark, zooms)}};
  };
  return {{"hit", scope.is_hit},
          {"sentences", sentences_of(scope, report)},
          {"s", digits_text(scope.parameter)},
          {"ulp", fmt::format("{:.3g}", scope.ulp)},
          {"zooms", list_json(zooms, zoom_json)},
          {"grid", std::move(grid)},
          {"region", or_null(scope.region, six_digits)},
          {"marks", list_json(scope.marks, mark_json)}};
}

}  // namespace

Json microscope_json(const ExplainReport& report, const reference::ExactRay& ray,
                     const scene::Sphere& sphere) {
  constexpr int kFewestBits = 192;
  for (int bits = kFewestBits; bits <= kMostMicroscopeBits; bits *= 2) {
    scene::poll();
    try {
      return look(report, ray, sphere, bits);
    } catch (const TooWide&) {
    }
  }
  return nullptr;
}

}  // namespace raycheck::tools
