#include <stdexcept>
#include <utility>
#include <vector>

#include "properties/quantity.h"
#include "properties/rounded_case.h"
#include "reference/account/condition.h"
#include "reference/error_measure.h"
#include "scene/validate.h"
#include "tools/explain/explain_methods.h"

namespace raycheck::tools {
namespace {

using properties::Quantity;

/// The bound that it is held to at a condition number.
double bound_of(const properties::Candidate& candidate, Quantity quantity, double condition) {
  return documented_bound(candidate, quantity, false).value_or(properties::kDefaultMaxError) *
         properties::bound_growth(condition);
}

/// The one answer of several that was asked for.
template <class Answers>
const auto& only(const Answers& answers) {
  if (answers.size() != 1) throw std::runtime_error("it gave no answer, or several");
  return answers.front();
}

}  // namespace

MethodReport judge_others_rays(const properties::Candidate& candidate,
                               const scene::Conventions& conventions, const scene::Camera& camera,
                               const scene::Pixel& pixel) {
  MethodReport report;
  report.name = candidate.name;
  const reference::ExactCamera exact_camera(camera, conventions);
  const reference::ExactRay exact(exact_camera, pixel);
  const double u_of_doubles =
      properties::kDoubleRoundoff / scene::unit_roundoff(candidate.precision);
  const auto add = [&](const char* symbol, std::vector<double> value, double error,
                       Quantity quantity, double condition) {
    report.steps.push_back(step(symbol, std::move(value), error * u_of_doubles,
                                bound_of(candidate, quantity, condition), quantity,
                                candidate.precision));
  };
  try {
    if (candidate.frame) {
      const properties::FrameAnswer got = candidate.frame(camera);
      const auto truth = exact_camera.frame();
      const double condition = reference::condition_of_frame(exact_camera);
      const auto add_axis = [&](const char* symbol, const scene::UnitVector3& axis,
                                const reference::Enclosure3& exactly) {
        add(symbol, numbers(axis), reference::relative_error(axis, exactly), Quantity::kFrame,
            condition);
      };
      add_axis("W", got.W, truth.W);
      add_axis("U", got.U, truth.U);
      add_axis("V", got.V, truth.V);
    }
    if (candidate.pixel_points) {
      const auto points = candidate.pixel_points(camera, conventions, {&pixel, 1});
      const scene::Point3& got = only(points);
      add("P", numbers(got), reference::relative_error(got, exact.pixel_point()),
          Quantity::kPixelPoint, reference::condition_of_pixel_point(exact));
    }
    const bool from_pixel = candidate.pixel_rays &&
                            (conventions.origin == scene::Origin::kPixel || !candidate.focal_rays);
    const auto& make = from_pixel ? candidate.pixel_rays : candidate.focal_rays;
    if (make) {
      const auto rays = make(camera, conventions, {&pixel, 1});
      const scene::Vector3& d = only(rays).direction;
      const scene::UnitVector3 got = {d.x, d.y, d.z};
      add("D", numbers(got), reference::angle_error(got, exact.direction()), Quantity::kDirection,
          reference::condition_of_direction(exact));
    }
  } catch (const std::runtime_error& error) {
    report.failure = error.what();
  }
  for (const MethodStep& one : report.steps) {
    if (one.wrong) {
      report.goes_wrong_at = first_wrong(report);
      break;
    }
  }
  return report;
}

MethodReport judge_others_intersection(const properties::Candidate& candidate,
                                       const scene::Ray& ray, const scene::Sphere& sphere,
                                       const scene::Conventions& conventions,
                                       const Subject& subject, const SphereReport& exact) {
  RayAnswered answer{candidate.name,
                     {},
                     {},
                     bound_of(candidate, Quantity::kParameter, 0),
                     bound_of(candidate, Quantity::kHitPoint, 0),
                     candidate.unit_roundoff,
                     true,
                     candidate.precision};
  const scene::Ray given = properties::rounded_ray(ray, candidate.precision);
  try {
    if (scene::defects(given).empty()) {
      const auto hits = candidate.intersect({&given, 1}, {&sphere, 1}, conventions);
      const properties::SphereHits& of_sphere = only(hits);
      if (!of_sphere.empty()) {
        const properties::HitAnswer& hit = of_sphere.front().hit;
        answer.hit = {hit.parameter, hit.point};
      }
    }
  } catch (const std::runtime_error& error) {
    MethodReport report;
    report.name = candidate.name;
    report.intersects = true;
    report.failure = error.what();
    return report;
  }
  return judge_answer(answer, given, sphere, conventions, subject, exact);
}

}  // namespace raycheck::tools
