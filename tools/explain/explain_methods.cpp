#include "tools/explain/explain_methods.h"

#include <fmt/core.h>

#include <algorithm>
#include <limits>
#include <string>

#include "fast/camera_frame.h"
#include "properties/quantity.h"
#include "properties/trial.h"
#include "reference/account/condition.h"
#include "reference/account/nearby_answer.h"
#include "reference/error_measure.h"
#include "reference/ray_error.h"
#include "scene/validate.h"

namespace raycheck::tools {

using properties::Quantity;
using reference::Enclosure;
using reference::Enclosure3;
using reference::ExactRay;
using reference::Intersection;

MethodStep step(const char* symbol, std::vector<double> value, std::optional<double> error,
                double bound, Quantity quantity, scene::Precision precision) {
  return {symbol, std::move(value), error, unit_name(quantity, precision), error && *error > bound};
}

std::string first_wrong(const MethodReport& report) {
  for (const MethodStep& one : report.steps) {
    if (one.wrong) return one.symbol;
  }
  return report.steps.back().symbol;
}

namespace {

/// g = n W + alpha U + beta V of the method's own axes, exactly.
Enclosure3 along_own_axes(const fast::CameraFrame& frame, const Enclosure3& plane_position) {
  const Enclosure3 U = reference::enclose_exactly(frame.U);
  const Enclosure3 V = reference::enclose_exactly(frame.V);
  const Enclosure3 W = reference::enclose_exactly(frame.W);
  const auto sum = [&](Enclosure Enclosure3::*member) {
    return plane_position.z * W.*member + plane_position.x * U.*member +
           plane_position.y * V.*member;
  };
  return {sum(&Enclosure3::x), sum(&Enclosure3::y), sum(&Enclosure3::z)};
}

Enclosure3 scaled(const Enclosure& factor, const Enclosure3& v) {
  return {factor * v.x, factor * v.y, factor * v.z};
}

/// The root and the point alone: from the method's own v and d^2, and from its own s.
void judge_alone(const scene::Ray& ray, const Intersection& at, const fast::Roots* roots,
                 double u_of_doubles, MethodStep& s, MethodStep& point) {
  const Enclosure3 direction = reference::enclose_exactly(ray.direction);
  if (roots != nullptr && std::isfinite(roots->axial_distance) && roots->half_chord_sq >= 0 &&
      std::isfinite(roots->half_chord_sq)) {
    constexpr int kBits = 256;
    const Enclosure v(roots->axial_distance, kBits);
    const Enclosure d = sqrt(Enclosure(roots->half_chord_sq, kBits));
    const bool smaller = at.root == reference::WhichRoot::kSmaller;
    s.error_alone = reference::ulp_error(s.value[0], (smaller ? v - d : v + d) / norm(direction));
  }
  if (!std::isfinite(s.value[0])) return;
  const scene::Point3 got = {point.value[0], point.value[1], point.value[2]};
  point.error_alone = u_of_doubles * reference::relative_error(
                                         got, reference::enclose_exactly(ray.origin) -
                                                  scaled(-Enclosure(s.value[0], 256), direction));
}

}  // namespace

MethodReport judge_rays(const fast::PixelRayMethod& method, const scene::Conventions& conventions,
                        const scene::Camera& camera, const scene::Pixel& pixel) {
  MethodReport report;
  report.name = std::string(method.name);
  const bool has_points = method.pixel_points != nullptr;
  const reference::ExactCamera exact_camera(camera, conventions);
  const ExactRay exact(exact_camera, pixel);
  const auto frame = fast::camera_frame(camera);
  const auto exact_frame = exact_camera.frame();
  const double frame_bound =
      fast::kFrameMaxUlp * properties::bound_growth(reference::condition_of_frame(exact_camera));
  const auto add_axis = [&](const char* symbol, const scene::UnitVector3& got,
                            const Enclosure3& truth) {
    report.steps.push_back(step(symbol, numbers(got), reference::relative_error(got, truth),
                                frame_bound, Quantity::kFrame));
  };
  add_axis("W", frame.W, exact_frame.W);
  add_axis("U", frame.U, exact_frame.U);
  add_axis("V", frame.V, exact_frame.V);
  const std::vector<scene::Pixel> pixels = {pixel};
  // Their ulps say little where the bounds cancel: what is wrong with them shows in P and D.
  constexpr double kNoBound = std::numeric_limits<double>::infinity();
  const auto position = fast::plane_position(camera, conventions, pixel);
  const Enclosure3 exact_position = exact_camera.plane_position(pixel);
  const Enclosure3 own_along = along_own_axes(frame, exact_position);
  report.steps.push_back(step("alpha", {position.alpha},
                              reference::ulp_error(position.alpha, exact_position.x), kNoBound,
                              Quantity::kParameter));
  report.steps.push_back(step("beta", {position.beta},
                              reference::ulp_error(position.beta, exact_position.y), kNoBound,
                              Quantity::kParameter));
  if (has_points) {
    fast::Vectors points;
    method.pixel_points(camera, conventions, pixels, points);
    const scene::Point3 got = {points.x[0], points.y[0], points.z[0]};
    report.steps.push_back(step(
        "P", numbers(got), reference::relative_error(got, exact.pixel_point()),
        method.max_point_ulp * properties::bound_growth(reference::condition_of_pixel_point(exact)),
        Quantity::kPixelPoint));
    const Enclosure3 minus_along = scaled(Enclosure(-1), own_along);
    report.steps.back().error_alone =
        reference::relative_error(got, reference::enclose_exactly(camera.eye) - minus_along);
  }
  fast::Rays rays;
  method.focal_rays(camera, conventions, pixels, rays);
  const scene::UnitVector3 got = {rays.direction.x[0], rays.direction.y[0], rays.direction.z[0]};
  report.steps.push_back(step(
      "D", numbers(got), reference::angle_error(got, exact.direction()),
      method.max_direction_ulp * properties::bound_growth(reference::condition_of_direction(exact)),
      Quantity::kDirection));
  report.steps.back().error_alone = reference::angle_error(got, own_along);
  const bool any_wrong = std::any_of(report.steps.begin(), report.steps.end(),
                                     [](const MethodStep& one) { return one.wrong; });
  if (any_wrong) report.goes_wrong_at = first_wrong(report);
  return report;
}

MethodReport judge_intersection(const fast::IntersectMethod& method, const scene::Ray& ray,
                                const scene::Sphere& sphere, const scene::Conventions& conventions,
                                const Subject& subject, const SphereReport& exact) {
  RayAnswered answer{std::string(method.name), {}, {}, method.max_ulp, method.max_point_ulp,
                     method.unit_roundoff};
  if (scene::defects(ray).empty()) {
    fast::Rays rays;
    rays.resize(1);
    rays.origin = {{ray.origin.x}, {ray.origin.y}, {ray.origin.z}};
    rays.direction = {{ray.direction.x}, {ray.direction.y}, {ray.direction.z}};
    fast::Hits hits;
    method.intersect(rays, sphere, conventions.root, conventions.tangent, hits);
    if (hits.hit[0] != 0) {
      answer.hit = {hits.parameter[0], {hits.point.x[0], hits.point.y[0], hits.point.z[0]}};
    }
    if (method.roots != nullptr) answer.roots = method.roots(ray, sphere);
  }
  return judge_answer(answer, ray, sphere, conventions, subject, exact);
}

MethodReport judge_answer(const RayAnswered& answer, const scene::Ray& ray,
                          const scene::Sphere& sphere, const scene::Conventions& conventions,
                          const Subject& subject, const SphereReport& exact) {
  MethodReport report;
  report.name = answer.name;
  report.intersects = true;
  if (!scene::defects(ray).empty()) {  // over- or underflow on the ray's way: nothing to intersect
    report.class_error = exact.is_hit;
    report.goes_wrong_at = "D";
    return report;
  }
  const bool hit = answer.hit.has_value();
  if (hit) report.parameter = answer.hit->parameter;

  const scene::Precision precision = answer.precision;
  report.precision = precision;
  const double u_of_doubles = properties::kDoubleRoundoff / scene::unit_roundoff(precision);
  const ExactRay own(ray);
  const Intersection own_at = own.intersect(sphere, conventions);
  const bool own_hit = reference::counts_as_hit(own_at.hit_class, conventions.tangent);
  if (!answer.tells_roots_alone) {
    const scene::Vector3 to_centre = sphere.centre - ray.origin;
    report.steps.push_back(step(
        "T", numbers(to_centre),
        reference::relative_error(
            scene::UnitVector3{to_centre.x, to_centre.y, to_centre.z},
            reference::enclose_exactly(sphere.centre) - reference::enclose_exactly(ray.origin)),
        properties::kDefaultMaxError, Quantity::kHitPoint));
  }
  if (answer.roots) {
    const fast::Roots& roots = *answer.roots;
    const auto enclosed = own.enclose(1024);
    report.steps.push_back(
        step("v", {roots.axial_distance},
             reference::ulp_error(roots.axial_distance, enclosed.axial_distance(sphere)),
             properties::kDefaultMaxError, Quantity::kParameter));
    const Enclosure half_chord_sq = own_at.hit_class == reference::HitClass::kTangent
                                        ? Enclosure(0)
                                        : enclosed.half_chord_sq(sphere);
    report.steps.push_back(step("d^2", {roots.half_chord_sq},
                                reference::ulp_error(roots.half_chord_sq, half_chord_sq),
                                properties::kDefaultMaxError, Quantity::kParameter));
  }
  // As the laws have it: of the exact ray, whatever ray the method was given.
  report.is_excluded = is_excluded(properties::RayAnswer{subject.exact, sphere, report.parameter},
                                   exact.intersection, conventions, precision);
  MethodStep s = step("s", {}, std::nullopt, 0, Quantity::kParameter, precision);
  MethodStep point = step("Q", {}, std::nullopt, 0, Quantity::kHitPoint, precision);
  if (hit) {
    s.value = {answer.hit->parameter};
    point.value = numbers(answer.hit->point);
  }
  if (hit && own_hit) {
    s = step("s", s.value,
             reference::ulp_error(s.value[0], own.parameter(sphere, own_at), precision),
             answer.max_ulp *
                 properties::bound_growth(reference::condition_of_parameter(own, sphere, own_at)),
             Quantity::kParameter, precision);
    point = step(
        "Q", point.value,
        u_of_doubles *
            reference::relative_error(scene::Point3{point.value[0], point.value[1], point.value[2]},
                                      own.point(sphere, own_at)),
        answer.max_point_ulp *
            properties::bound_growth(reference::condition_of_computed_point(own, sphere, own_at)),
        Quantity::kHitPoint, precision);
    judge_alone(ray, own_at, answer.roots ? &*answer.roots : nullptr, u_of_doubles, s, point);
  }
  if (hit != own_hit) s.wrong = point.wrong = true;
  if (report.is_excluded) s.wrong = true;
  report.steps.push_back(s);
  report.steps.push_back(point);

  const bool judged = exact.intersection.hit_class != reference::HitClass::kTangent ||
                      conventions.tangent != scene::Tangent::kEither;
  report.class_error = judged && hit != exact.is_hit;
  if (hit && exact.is_hit) {
    report.ulp_error = reference::ulp_error(
        answer.hit->parameter, subject.exact.parameter(sphere, exact.intersection), precision);
  }
  const bool wrong =
      report.class_error || report.is_excluded || point.wrong ||
      (report.ulp_error &&
       *report.ulp_error > (answer.max_ulp + subject.inherited_bound) *
                               properties::bound_growth(reference::condition_of_parameter(
                                   subject.exact, sphere, exact.intersection)));
  const bool is_other_root =
      hit && exact.is_hit &&
      is_at_other_root(subject.exact, sphere, exact.intersection, *report.parameter);
  if (report.class_error || is_other_root || report.is_excluded) {
    const reference::Neighbourhood around{
        .root = conventions.root,
        .tangent = conventions.tangent,
        .relative_change = properties::excused_change(answer.unit_roundoff),
        .valid = conventions.valid};
    report.standing = properties::standing_of(
        right_nearby(subject.exact, sphere, around, report.parameter).found);
  }
  if (wrong) {
    // Right for the ray it was given: what went wrong is that ray.
    const bool right_alone = hit == own_hit && !s.wrong;
    report.goes_wrong_at = right_alone && subject.from_camera ? "D" : first_wrong(report);
  }
  return report;
}

scene::Ray ray_by(const fast::PixelRayMethod& method, const scene::Camera& camera,
                  const scene::Conventions& conventions, const scene::Pixel& pixel) {
  const auto make =
      conventions.origin == scene::Origin::kPixel ? method.pixel_rays : method.focal_rays;
  fast::Rays rays;
  const std::vector<scene::Pixel> pixels = {pixel};
  make(camera, conventions, pixels, rays);
  return {{rays.origin.x[0], rays.origin.y[0], rays.origin.z[0]},
          {rays.direction.x[0], rays.direction.y[0], rays.direction.z[0]}};
}

}  // namespace raycheck::tools
