#include "tools/explain/explain.h"

#include <fmt/core.h>

#include <algorithm>
#include <functional>
#include <stdexcept>
#include <utility>

#include "reference/account/condition.h"
#include "reference/error_measure.h"
#include "scene/interruption.h"
#include "scene/invalid_input.h"
#include "scene/validate.h"

namespace raycheck::tools {
namespace {

using properties::Candidate;
using properties::Case;
using properties::SharedTruths;
using reference::ClosedForm;
using reference::ClosedForm3;
using reference::Enclosure;
using reference::Enclosure3;
using reference::ExactRay;

std::vector<ClosedForm> coordinates(const ClosedForm3& form) { return {form.begin(), form.end()}; }

/// The ray to explain, in exact and symbolic form.
struct Subject {
  ExactRay exact;
  reference::ClosedFormRay symbolic;
  bool from_camera;
};

/// The double nearest to a number that can be enclosed at any precision. If the closed form is 0,
/// which enclosures cannot prove, 0.
double rounded(const std::function<Enclosure(int)>& enclose, const ClosedForm& closed_form) {
  if (closed_form.is_zero()) return 0;
  constexpr int kMostBits = 1 << 14;
  for (int bits = 128;; bits *= 2) {
    scene::poll();
    const Enclosure value = enclose(bits);
    const double low = value.lower_rounded();
    if (low == value.upper_rounded() || bits >= kMostBits) return low;
  }
}

Step scalar_step(const char* symbol, std::string formula, ClosedForm closed_form,
                 const std::function<Enclosure(int)>& enclose) {
  const double value = rounded(enclose, closed_form);
  return {symbol, std::move(formula), {std::move(closed_form)}, {value}};
}

Step vector_step(const char* symbol, const char* formula, const ClosedForm3& closed_form,
                 const std::function<Enclosure3(int)>& enclose) {
  Step step{symbol, formula, coordinates(closed_form), {}};
  Enclosure Enclosure3::*const members[] = {&Enclosure3::x, &Enclosure3::y, &Enclosure3::z};
  for (std::size_t k = 0; k < 3; ++k) {
    step.rounded.push_back(
        rounded([&](int bits) { return enclose(bits).*members[k]; }, closed_form[k]));
  }
  return step;
}

/// An enclosure of T = C - L.
Enclosure3 to_centre(const Subject& subject, const scene::Sphere& sphere, int bits) {
  return reference::enclose_exactly(sphere.centre) - subject.exact.enclose(bits).origin();
}

/// The shares of the way across and down at which a pixel lies, by samples.
constexpr std::pair<const char*, const char*> kShares[] = {
    {"i/(w - 1)", "j/(h - 1)"}, {"(i + 1/2)/w", "(j + 1/2)/h"}, {"i/w", "j/h"}};

void derive_camera(const reference::ExactCamera& camera, const Subject& subject,
                   const scene::Pixel& pixel, std::vector<Step>& steps) {
  const auto axes = reference::closed_form_frame(camera.camera());
  const auto frame = camera.rounded_frame();
  const double condition = reference::condition_of_frame(camera);
  const auto alone = reference::stage_conditions(subject.exact);
  const bool top_first = camera.conventions().rows == scene::Rows::kTopFirst;
  steps.push_back({"E", "the eye", {}, numbers(camera.camera().eye)});
  steps.push_back({"W", "(E - A)/|E - A|", coordinates(axes.W), numbers(frame.W), condition});
  steps.push_back({"U", "(up x W)/|up x W|", coordinates(axes.U), numbers(frame.U), condition});
  steps.push_back({"V", "W x U", coordinates(axes.V), numbers(frame.V), condition});
  const auto& closed = subject.symbolic;
  const auto position = [&](const char* first, const char* last, const char* share) {
    return fmt::format("{0} + {1} ({2} - {0})", first, share, last);
  };
  const auto& [across, down] = kShares[static_cast<std::size_t>(camera.conventions().samples)];
  steps.push_back(scalar_step("alpha", position("left", "right", across), closed.alpha(),
                              [&](int bits) { return camera.plane_position(pixel, bits).x; }));
  steps.push_back(scalar_step(
      "beta", top_first ? position("top", "bottom", down) : position("bottom", "top", down),
      closed.beta(), [&](int bits) { return camera.plane_position(pixel, bits).y; }));
  steps.push_back({"P", "E + n W + alpha U + beta V", coordinates(closed.pixel_point()),
                   numbers(subject.exact.rounded_pixel_point()),
                   reference::condition_of_pixel_point(subject.exact), alone.pixel_point});
  steps.push_back({"D", "(P - E)/|P - E|", coordinates(closed.direction()),
                   numbers(subject.exact.rounded_direction()),
                   reference::condition_of_direction(subject.exact), alone.direction});
}

void derive_given(const Subject& subject, const scene::Ray& ray, std::vector<Step>& steps) {
  steps.push_back({"L", "the ray's origin", {}, numbers(ray.origin)});
  steps.push_back({"direction", "as given", {}, numbers(ray.direction)});
  steps.push_back({"D", "direction/|direction|", coordinates(subject.symbolic.direction()),
                   numbers(subject.exact.rounded_direction()),
                   reference::condition_of_direction(subject.exact),
                   reference::stage_conditions(subject.exact).direction});
}

void derive_sphere(const Subject& subject, const scene::Sphere& sphere, const SphereReport& report,
                   std::vector<Step>& steps) {
  const auto& closed = subject.symbolic;
  const ExactRay& ray = subject.exact;
  const reference::Intersection& at = report.intersection;
  const auto alone = reference::stage_conditions(ray, sphere, at);
  const auto add = [&](Step step, std::optional<double> condition,
                       std::optional<double> condition_alone) {
    step.condition = condition;
    step.condition_alone = condition_alone;
    steps.push_back(std::move(step));
  };
  steps.push_back(vector_step("T", "C - L", closed.to_centre(sphere),
                              [&](int bits) { return to_centre(subject, sphere, bits); }));
  add(scalar_step("v", "T . D", closed.axial_distance(sphere),
                  [&](int bits) { return ray.enclose(bits).axial_distance(sphere); }),
      reference::condition_of_axial_distance(ray, sphere), alone.axial_distance);
  add(scalar_step("d^2", "r^2 - (|T|^2 - v^2)", closed.half_chord_sq(sphere),
                  [&](int bits) { return ray.enclose(bits).half_chord_sq(sphere); }),
      reference::condition_of_half_chord_sq(ray, sphere), alone.half_chord_sq);
  if (!report.parameter) return;
  const bool smaller = at.root == reference::WhichRoot::kSmaller;
  const char* formula = smaller ? "v - d" : "v + d";
  if (!subject.from_camera) {
    // The lecture's s, for the unit direction; the given direction need not be unit.
    steps.push_back(
        scalar_step("s |direction|", formula, closed.distance(sphere, at), [&](int bits) {
          const auto enclosed = ray.enclose(bits);
          return enclosed.parameter(sphere, at) * enclosed.length();
        }));
    formula = smaller ? "(v - d)/|direction|" : "(v + d)/|direction|";
  }
  add({"s", formula, {*report.closed_form_parameter}, {*report.parameter}},
      reference::condition_of_parameter(ray, sphere, at), alone.root);
  add({"Q", subject.from_camera ? "L + s D" : "L + s direction", report.closed_form_point,
       report.point},
      reference::condition_of_point(ray, sphere, at), alone.point);
}

/// The roots >= 0 before `taken`, the one that counts.
std::vector<RootLeftOut> roots_left_out(const ExactRay& ray, const scene::Sphere& sphere,
                                        const reference::Intersection& taken,
                                        const scene::Conventions& conventions) {
  using reference::HitClass;
  std::vector<RootLeftOut> left_out;
  const auto usual = ray.intersect(sphere, scene::Root::kNearest);
  if (conventions.valid.is_usual() || usual.hit_class == HitClass::kMiss ||
      taken.hit_class == HitClass::kTangent) {
    return left_out;
  }
  for (const auto root : {reference::WhichRoot::kSmaller, reference::WhichRoot::kLarger}) {
    const reference::Intersection at{usual.hit_class, root};
    const reference::RootCounts why = ray.counts(sphere, at, conventions.valid);
    if (why == reference::RootCounts::kYes) break;
    if (ray.compare_parameter(sphere, at, 0, scene::TUnit::kAbsolute) >= 0) {
      left_out.push_back({root, ray.rounded_parameter(sphere, at), why});
    }
    const bool is_only_root =
        conventions.root == scene::Root::kSmaller || at.hit_class == HitClass::kTangent;
    if (is_only_root) break;
  }
  return left_out;
}

SphereReport report_sphere(const Subject& subject, const scene::Sphere& sphere,
                           const scene::Conventions& conventions) {
  SphereReport report;
  report.intersection = subject.exact.intersect(sphere, conventions);
  report.is_hit = reference::counts_as_hit(report.intersection.hit_class, conventions.tangent);
  report.left_out = roots_left_out(subject.exact, sphere, report.intersection, conventions);
  if (report.intersection.hit_class == reference::HitClass::kMiss) return report;
  report.parameter = subject.exact.rounded_parameter(sphere, report.intersection);
  report.point = numbers(subject.exact.rounded_point(sphere, report.intersection));
  report.closed_form_parameter = subject.symbolic.parameter(sphere, report.intersection);
  report.closed_form_point = coordinates(subject.symbolic.point(sphere, report.intersection));
  return report;
}

/// The scene under the candidate's conventions and in its format.
scene::Scene asked_scene(const ExplainOptions& options, const std::optional<Candidate>& other,
                         std::size_t& rounded_numbers) {
  scene::Scene scene = options.scene;
  scene::require_valid(scene);
  // As in `check`: if a method makes rays only from the eye, it is judged with the eye as origin.
  if (options.rays->pixel_rays == nullptr) scene.conventions.origin = scene::Origin::kFocal;
  if (!other) return scene;
  scene.conventions = other->declared.over(scene.conventions);
  properties::RoundedCase rounded = properties::rounded_scene(scene, other->input_format());
  if (!rounded.the_case) throw std::invalid_argument(other->name + ": " + rounded.reason);
  rounded_numbers = rounded.changed;
  return std::move(rounded.the_case->scene);
}

Subject subject_of(const scene::Scene& scene, const std::optional<reference::ExactCamera>& camera,
                   const std::optional<scene::Pixel>& pixel) {
  if (!camera) {
    const scene::Ray& ray = scene.rays.front();
    return {ExactRay(ray), reference::ClosedFormRay(ray), false};
  }
  return {ExactRay(*camera, *pixel),
          reference::ClosedFormRay(*scene.camera, scene.conventions, *pixel), true};
}

void report_all_rays(const Case& the_case, const std::optional<Candidate>& other,
                     ExplainReport& report) {
  SharedTruths truths(the_case);
  const auto add = [&](const Candidate& candidate, const fast::PixelRayMethod* own) {
    const auto conventions = candidate.declared.over(the_case.scene.conventions);
    MethodReport rays = report_rays(candidate, the_case, truths.under(conventions), own);
    if (!rays.steps.empty() || rays.wrong) report.methods.push_back(std::move(rays));
  };
  for (const auto* method : fast::pixel_ray_methods()) {
    add(candidate_of(MethodPair{method, kDefaultMethods.intersect}), method);
  }
  if (other) add(*other, nullptr);
}

/// Adds the answers of all methods about the case's one sphere.
void report_all_intersections(const Case& the_case, const fast::PixelRayMethod& rays,
                              const std::optional<Candidate>& other, ExplainReport& report) {
  SharedTruths truths(the_case);
  const auto add = [&](const Candidate& candidate, const fast::IntersectMethod* own) {
    scene::poll();
    const auto conventions = candidate.declared.over(the_case.scene.conventions);
    report.methods.push_back(report_intersection(
        candidate, the_case, truths.under(conventions, candidate.interface.from_inside), own));
  };
  for (const auto* method : fast::intersect_methods()) {
    add(candidate_of(MethodPair{&rays, method}), method);
  }
  if (other && other->intersect) add(*other, nullptr);
}

}  // namespace

const Step* ExplainReport::find(const std::string& symbol) const {
  const auto found = std::ranges::find(steps, symbol, &Step::symbol);
  return found == steps.end() ? nullptr : &*found;
}

bool ExplainReport::has_discrepancy() const {
  return std::ranges::any_of(methods, [](const MethodReport& method) {
    return method.wrong && method.wrong->excuse.standing() == properties::Standing::kDefect;
  });
}

ExplainReport explain(const ExplainOptions& options) {
  ExplainReport report;
  std::optional<Candidate> other;
  if (options.other) other = options.other->make();
  report.scene = asked_scene(options, other, report.rounded_numbers);
  report.other = options.other;
  report.pixel = options.pixel;
  report.rays_method = std::string(options.rays->name);

  const scene::Scene& scene = report.scene;
  Case the_case{scene, {}};
  std::optional<reference::ExactCamera> camera;
  if (scene.camera) {
    the_case.pixels = {options.pixel.value()};
    camera.emplace(*scene.camera, scene.conventions);
  } else {
    report.ray = scene.rays.front();
    the_case.scene.rays = {report.ray};
  }
  const Subject subject = subject_of(scene, camera, options.pixel);
  if (camera) {
    derive_camera(*camera, subject, *options.pixel, report.steps);
    report_all_rays(the_case, other, report);
  } else {
    derive_given(subject, report.ray, report.steps);
  }

  for (const scene::Sphere& sphere : scene.spheres) {
    scene::poll();
    report.spheres.push_back(report_sphere(subject, sphere, scene.conventions));
  }
  if (const auto nearest = subject.exact.nearest(scene.spheres, scene.conventions)) {
    report.nearest = nearest->index;
  }
  if (scene.spheres.empty()) {
    if (options.sphere) throw scene::InvalidInput("sphere", "", "the scene has no spheres");
    return report;
  }
  report.sphere = options.sphere.value_or(report.nearest.value_or(0));
  if (*report.sphere >= scene.spheres.size()) {
    throw scene::InvalidInput(
        "sphere", std::to_string(*report.sphere),
        scene.spheres.size() == 1
            ? "the scene has only sphere 0"
            : fmt::format("the scene's spheres are numbered 0 to {}", scene.spheres.size() - 1));
  }
  const scene::Sphere& sphere = scene.spheres[*report.sphere];
  const SphereReport& exact = report.spheres[*report.sphere];
  scene::poll();
  derive_sphere(subject, sphere, exact, report.steps);
  const scene::Conventions own =
      candidate_of(kDefaultMethods).declared.over(scene.conventions);  // those of each of them
  if (own != scene.conventions) report.by_every_root = report_sphere(subject, sphere, own);
  the_case.scene.spheres = {sphere};
  report_all_intersections(the_case, *options.rays, other, report);
  return report;
}

}  // namespace raycheck::tools
