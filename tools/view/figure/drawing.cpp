#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "tools/view/figure/figure.h"

namespace raycheck::tools {
namespace {

using reference::Enclosure;
using reference::Enclosure3;

/// Whether a root may be the answer under the conventions.
bool may_count(const reference::ExactRay& ray, const scene::Sphere& sphere,
               const reference::Intersection& at, const scene::Conventions& conventions) {
  const bool is_asked =
      conventions.root == scene::Root::kNearest || at.root == reference::WhichRoot::kSmaller;
  return is_asked && ray.counts(sphere, at, conventions.valid) == reference::RootCounts::kYes;
}

/// The hit class of a ray's whole line with a sphere, including the part behind the origin.
reference::HitClass class_of_line(const reference::ExactRay& ray, const scene::Sphere& sphere) {
  scene::Conventions anywhere;
  anywhere.valid.t_min = std::numeric_limits<double>::lowest();
  return ray.intersect(sphere, anywhere).hit_class;
}

/// L + v D
Enclosure3 foot_of(const reference::ExactRay& ray, const scene::Sphere& sphere, int bits) {
  const auto enclosed = ray.enclose(bits);
  const Enclosure3 origin = enclosed.origin(), direction = enclosed.direction();
  const Enclosure v = enclosed.axial_distance(sphere);
  return {origin.x + v * direction.x, origin.y + v * direction.y, origin.z + v * direction.z};
}

/// Both numbers in the same format, with enough digits to distinguish them, but at least six.
std::array<std::string, 2> distinct_texts(double a, double b) {
  constexpr int kFewestDigits = 6, kMostDigits = 17;
  for (int digits = kFewestDigits;; ++digits) {
    std::array<std::string, 2> texts = {fmt::format("{:.{}g}", a, digits),
                                        fmt::format("{:.{}g}", b, digits)};
    const auto has_exponent = [](const std::string& text) { return text.find('e') < text.size(); };
    const bool is_alike = has_exponent(texts[0]) == has_exponent(texts[1]);
    if ((texts[0] != texts[1] && is_alike) || digits == kMostDigits) return texts;
  }
}

/// A direction at right angles to a ray, towards a centre; any such direction if the ray passes
/// through the centre.
Drawn across(const Drawn& direction, const Drawn& foot, const Drawn& centre, const Drawn& origin) {
  constexpr double kTooNear = 0x1p-30;  // relative distance: a smaller one may be rounding error
  Drawn square;
  double least = kTooNear * length_of(centre - origin);
  for (const Drawn& way : {centre - foot, Drawn{0, 1, 0}, Drawn{0, 0, 1}}) {
    square = way - dot_product(way, direction) * direction;
    if (length_of(square) > least) break;
    least = kTooNear;
  }
  constexpr double kSteps = 1e6;  // steps per unit; this determines only the viewing direction
  const Drawn finest = (kSteps / length_of(square)) * square;
  return {std::round(finest[0]) / kSteps, std::round(finest[1]) / kSteps,
          std::round(finest[2]) / kSteps};
}

/// The drawing of a ray and a sphere.
struct RayDrawing {
  Drawn direction;   ///< D
  double until = 0;  ///< The line is drawn up to this distance from L.
  /// L, P, the foot L + v D, the roots, and points behind the origin.
  DrawnPlaces places;
  Json names = Json::object();  ///< Labels of places.
};

/// Adds the roots on a ray's line to the drawing.
void add_roots(const DrawnFrame& frame, const reference::ExactRay& ray, const scene::Sphere& sphere,
               const scene::Conventions& conventions, RayDrawing& drawing) {
  const auto line = class_of_line(ray, sphere);
  if (line == reference::HitClass::kMiss) return;
  const auto chosen = ray.intersect(sphere, conventions);
  const bool is_double = line == reference::HitClass::kTangent;
  const std::array<reference::Intersection, 2> both = {
      {{line, reference::WhichRoot::kSmaller}, {line, reference::WhichRoot::kLarger}}};
  const auto texts = distinct_texts(ray.rounded_parameter(sphere, both[0]),
                                    ray.rounded_parameter(sphere, both[1]));
  for (std::size_t k = 0; k < (is_double ? 1u : 2u); ++k) {
    const reference::Intersection& at = both[k];
    const bool is_chosen =
        chosen.hit_class != reference::HitClass::kMiss && (is_double || chosen.root == at.root);
    const std::string name = is_double ? "double root" : k == 0 ? "near root" : "far root";
    const Drawn point = frame.point([&](int bits) { return ray.enclose(bits).point(sphere, at); });
    drawing.places.emplace_back(name, point);
    if (is_chosen) drawing.places.emplace_back("answer", point);
    drawing.names[name] =
        fmt::format("{}, s = {}{}", name, texts[k],
                    is_chosen                                 ? ", the answer"
                    : may_count(ray, sphere, at, conventions) ? ""
                                                              : ", does not count");
  }
}

/// Sets the ends of the line through these places, a little beyond the last one.
void add_ends(RayDrawing& drawing) {
  constexpr double kBeyond = 1.2;  // times the distance of the last
  const Drawn origin = drawing.places.front().second;
  double first = 0, last = 0;
  Drawn behind = origin;
  for (const auto& [name, place] : drawing.places) {
    const double along = dot_product(place - origin, drawing.direction);
    last = std::max(last, along);
    if (along < first) behind = place;
    first = std::min(first, along);
  }
  drawing.until = last > 0 ? kBeyond * last : 1;
  if (first < 0) drawing.places.emplace_back("behind", behind);
}

}  // namespace

Json drawing_json(const DrawnFrame& frame, const reference::ExactRay& ray,
                  const scene::Sphere* sphere, const scene::Conventions& conventions) {
  RayDrawing drawing;
  Json across_ray = nullptr;
  drawing.direction = unit(ray.rounded_direction());
  const Drawn origin = frame.point([&](int bits) { return ray.enclose(bits).origin(); });
  drawing.places.emplace_back("L", origin);
  if (sphere != nullptr) {
    const Drawn foot = frame.point([&](int bits) { return foot_of(ray, *sphere, bits); });
    drawing.places.emplace_back("foot", foot);
    across_ray = drawn(across(drawing.direction, foot, frame.point(sphere->centre), origin));
    add_roots(frame, ray, *sphere, conventions, drawing);
  }
  add_ends(drawing);
  if (ray.source().camera) {
    drawing.places.emplace_back(
        "P", frame.point([&](int bits) { return ray.enclose(bits).pixel_point(); }));
  }
  return {{"D", drawn(drawing.direction)},
          {"across", std::move(across_ray)},
          {"until", drawn(static_cast<float>(drawing.until))},
          {"places", places_json(drawing.places)},
          {"names", std::move(drawing.names)}};
}

}  // namespace raycheck::tools
