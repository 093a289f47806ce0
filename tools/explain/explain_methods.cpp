#include <cmath>
#include <exception>
#include <string>
#include <utility>

#include "fast/camera_frame.h"
#include "properties/laws/law.h"
#include "properties/quantity.h"
#include "reference/error_measure.h"
#include "scene/validate.h"
#include "tools/explain/explain.h"

namespace raycheck::tools {
namespace {

using properties::Candidate;
using properties::Case;
using properties::Law;
using properties::Quantity;
using properties::Trial;
using properties::Trials;
using properties::Truth;
using reference::Enclosure;
using reference::Enclosure3;
using reference::ExactRay;

/// The first discrepancy that the laws for which a condition holds find.
template <class Condition>
std::optional<properties::Discrepancy> found_wrong(Trials& trials, const Condition& is_asked) {
  properties::Verdict verdict;
  for (const Law& law : properties::laws()) {
    if (is_asked(law)) verdict.merge(trials.apply(law));
  }
  std::vector<properties::Discrepancy> worst = verdict.worst(1);
  return worst.empty() ? std::nullopt : std::optional(std::move(worst.front()));
}

constexpr bool is_of_made_rays(const Law& law) {
  return law.judges_values && is_about_cameras(law) && !is_about_intersections(law);
}
constexpr bool is_of_pairs(const Law& law) {
  return law.judges_values && law.per == properties::Per::kPair;
}

/// The steps of a report, in the format of its implementation.
class Steps {
 public:
  explicit Steps(MethodReport& report) : report_(report) {}

  MethodStep& add(const char* symbol, std::vector<double> value,
                  const std::optional<scene::Measured>& error, Quantity quantity) {
    report_.steps.push_back({symbol, std::move(value),
                             error ? std::optional(in_its_unit(*error)) : std::nullopt,
                             unit_name(quantity, report_.precision)});
    return report_.steps.back();
  }
  double in_its_unit(const scene::Measured& error) const {
    return error.in(report_.precision).value;
  }

 private:
  MethodReport& report_;
};

Enclosure3 scaled(const Enclosure& factor, const Enclosure3& v) {
  return {factor * v.x, factor * v.y, factor * v.z};
}

/// g = n W + alpha U + beta V with the method's own axes, exactly.
Enclosure3 along_own_axes(const properties::FrameAnswer& frame, const Enclosure3& plane_position) {
  return scaled(plane_position.z, reference::enclose_exactly(frame.W)) -
         scaled(-plane_position.x, reference::enclose_exactly(frame.U)) -
         scaled(-plane_position.y, reference::enclose_exactly(frame.V));
}

void add_ray_steps(Trial& trial, bool is_own, Steps steps) {
  const Candidate& candidate = trial.candidate();
  const scene::Camera& camera = *trial.scene().camera;
  const ExactRay& exact = trial.exact_ray(0);
  std::optional<Enclosure3> own_along;
  if (candidate.frame) {
    const reference::EnclosedFrame truth = trial.exact_camera().frame();
    const auto add_axis = [&](const char* symbol, const scene::UnitVector3& axis,
                              const Enclosure3& exactly) {
      steps.add(symbol, numbers(axis), reference::relative_error(axis, exactly), Quantity::kFrame);
    };
    add_axis("W", trial.frame().W, truth.W);
    add_axis("U", trial.frame().U, truth.U);
    add_axis("V", trial.frame().V, truth.V);
  }
  if (is_own) {
    const auto got = fast::plane_position(camera, trial.conventions(), trial.pixels().front());
    const Enclosure3 truth = trial.exact_camera().plane_position(trial.pixels().front());
    steps.add("alpha", {got.alpha}, reference::ulp_error(got.alpha, truth.x), Quantity::kParameter);
    steps.add("beta", {got.beta}, reference::ulp_error(got.beta, truth.y), Quantity::kParameter);
    own_along = along_own_axes(trial.frame(), truth);
  }
  if (candidate.pixel_points) {
    const scene::Point3& got = trial.pixel_points().front();
    MethodStep& step =
        steps.add("P", numbers(got), reference::relative_error(got, exact.pixel_point()),
                  Quantity::kPixelPoint);
    if (own_along) {
      step.error_alone = steps.in_its_unit(reference::relative_error(
          got, reference::enclose_exactly(camera.eye) - scaled(Enclosure(-1), *own_along)));
    }
  }
  if (trial.has_rays()) {
    const scene::Vector3& D = trial.rays().front().direction;
    const scene::UnitVector3 got = {D.x, D.y, D.z};
    MethodStep& step = steps.add("D", numbers(got), reference::angle_error(got, exact.direction()),
                                 Quantity::kDirection);
    if (own_along) step.error_alone = steps.in_its_unit(reference::angle_error(got, *own_along));
  }
}

/// Adds the steps T, v and d^2 of one of raycheck's methods.
std::optional<fast::Roots> add_own_steps(const fast::IntersectMethod& own, const ExactRay& exact,
                                         const Trial& trial, Steps steps) {
  const scene::Ray& ray = exact.source().given;
  const scene::Sphere& sphere = trial.scene().spheres.front();
  const scene::Vector3 to_centre = sphere.centre - ray.origin;
  steps.add("T", numbers(to_centre),
            reference::relative_error(
                scene::UnitVector3{to_centre.x, to_centre.y, to_centre.z},
                reference::enclose_exactly(sphere.centre) - reference::enclose_exactly(ray.origin)),
            Quantity::kHitPoint);
  if (own.roots == nullptr) return {};
  const fast::Roots roots = own.roots(ray, sphere);
  const auto enclosed = exact.enclose(1024);
  const bool is_tangent =
      exact.intersect(sphere, trial.conventions()).hit_class == reference::HitClass::kTangent;
  steps.add("v", {roots.axial_distance},
            reference::ulp_error(roots.axial_distance, enclosed.axial_distance(sphere)),
            Quantity::kParameter);
  steps.add("d^2", {roots.half_chord_sq},
            reference::ulp_error(roots.half_chord_sq,
                                 is_tangent ? Enclosure(0) : enclosed.half_chord_sq(sphere)),
            Quantity::kParameter);
  return roots;
}

/// The error of the step from the method's own v and d^2 to s.
std::optional<double> error_alone(double s, const fast::Roots& roots, const ExactRay& exact,
                                  reference::WhichRoot root) {
  if (!std::isfinite(roots.axial_distance) || !std::isfinite(roots.half_chord_sq) ||
      roots.half_chord_sq < 0) {
    return {};
  }
  constexpr int kBits = 256;
  const Enclosure v(roots.axial_distance, kBits);
  const Enclosure d = sqrt(Enclosure(roots.half_chord_sq, kBits));
  const Enclosure3 direction = reference::enclose_exactly(exact.source().given.direction);
  return reference::ulp_error(
             s, (root == reference::WhichRoot::kSmaller ? v - d : v + d) / norm(direction))
      .value;
}

void add_hit_steps(Trial& trial, const fast::IntersectMethod* own, MethodReport& report) {
  const scene::Ray& ray = trial.rays().front();
  if (!scene::defects(ray).empty()) return;  // over- or underflow on the ray's way
  Steps steps(report);
  const scene::Sphere& sphere = trial.scene().spheres.front();
  const ExactRay exact(ray);
  std::optional<fast::Roots> roots;
  if (own != nullptr) roots = add_own_steps(*own, exact, trial, steps);
  const properties::HitAnswer* const hit = properties::find_hit(trial.hits(0), 0);
  if (hit == nullptr) {
    steps.add("s", {}, {}, Quantity::kParameter);
    steps.add("Q", {}, {}, Quantity::kHitPoint);
    return;
  }
  report.parameter = hit->parameter;
  const reference::Intersection at = properties::exact_intersection(
      exact, sphere, trial.conventions(), trial.candidate().interface.from_inside);
  const bool meets = reference::counts_as_hit(at.hit_class, trial.conventions().tangent) &&
                     !properties::is_at_start(exact, sphere, trial.candidate());
  std::optional<scene::Measured> off_s, off_point;
  if (meets) {
    off_s = reference::ulp_error(hit->parameter, exact.parameter(sphere, at), report.precision);
    off_point = reference::relative_error(hit->point, exact.point(sphere, at));
  }
  const properties::Returns returns = trial.candidate().interface.returns;
  if (trial.exact_hit(0, 0) && properties::gives_parameter(returns) &&
      !properties::is_at_start(trial.exact_ray(0), sphere, trial.candidate())) {
    report.ulp_error =
        reference::ulp_error(hit->parameter,
                             trial.exact_ray(0).parameter(sphere, trial.exact_intersection(0, 0)),
                             report.precision)
            .value;
  }
  if (properties::gives_parameter(returns)) {
    MethodStep& s = steps.add("s", {hit->parameter}, off_s, Quantity::kParameter);
    if (meets && roots) s.error_alone = error_alone(hit->parameter, *roots, exact, at.root);
  }
  if (!properties::gives_point(returns)) return;
  MethodStep& point = steps.add("Q", numbers(hit->point), off_point, Quantity::kHitPoint);
  if (meets && std::isfinite(hit->parameter)) {
    point.error_alone = steps.in_its_unit(reference::relative_error(
        hit->point,
        reference::enclose_exactly(ray.origin) -
            scaled(-Enclosure(hit->parameter, 256), reference::enclose_exactly(ray.direction))));
  }
}

/// Whether an answer that is wrong for a camera's ray is right for the ray that the implementation
/// made.
bool is_right_for_own_ray(Trial& trial) {
  if (!trial.scene().camera) return false;
  Case given{trial.scene(), {}};
  given.scene.camera.reset();
  given.scene.rays = {trial.rays().front()};
  if (!scene::defects(given.scene.rays.front()).empty()) return true;
  Trials trials(given, trial.candidate());
  return !found_wrong(trials, is_of_pairs);
}

/// The first step before s whose error exceeds kDefaultMaxError; if there is none, the step that
/// the laws find wrong.
std::string wrong_step(const MethodReport& report) {
  for (const MethodStep& step : report.steps) {
    if (step.symbol == "s") break;
    if (step.error > properties::kDefaultMaxError) return step.symbol;
  }
  return report.wrong->symbol;
}

}  // namespace

MethodReport report_rays(const Candidate& candidate, const Case& the_case,
                         std::shared_ptr<Truth> truth, const fast::PixelRayMethod* own) {
  MethodReport report;
  report.is_other = own == nullptr;
  report.name = report.is_other ? candidate.name : std::string(own->name);
  report.precision = candidate.precision;
  Trials trials(the_case, candidate, {.truth = std::move(truth)});
  report.wrong = found_wrong(trials, is_of_made_rays);
  if (report.wrong && report.failure().empty()) {
    report.goes_wrong_at = report.wrong->symbol.empty() ? report.wrong->what : report.wrong->symbol;
  }
  try {
    add_ray_steps(trials.on_case(), own != nullptr, Steps(report));
  } catch (const std::exception&) {
    if (!report.wrong) throw;  // otherwise the laws say how it failed
  }
  return report;
}

MethodReport report_intersection(const Candidate& candidate, const Case& the_case,
                                 std::shared_ptr<Truth> truth, const fast::IntersectMethod* own) {
  MethodReport report;
  report.is_other = own == nullptr;
  report.name = report.is_other ? candidate.name : std::string(own->name);
  report.intersects = true;
  report.precision = candidate.precision;
  Trials trials(the_case, candidate, {.truth = std::move(truth)});
  report.wrong = found_wrong(trials, is_of_pairs);
  report.makes_ray = !trials.gave_rays();
  Trial& trial = trials.of(*properties::laws_that(is_of_pairs).front());
  try {
    add_hit_steps(trial, own, report);
    if (report.wrong && report.failure().empty()) {
      report.goes_wrong_at = is_right_for_own_ray(trial) ? "D" : wrong_step(report);
    }
  } catch (const std::exception&) {
    if (!report.wrong) throw;  // otherwise the laws say how it failed
  }
  return report;
}

}  // namespace raycheck::tools
