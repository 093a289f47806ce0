#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "properties/candidate.h"
#include "properties/case.h"
#include "properties/discrepancy.h"
#include "properties/truth.h"
#include "reference/account/closed_form.h"
#include "reference/exact_ray.h"
#include "scene/scene.h"
#include "tools/implementations/built_in.h"
#include "tools/report/view.h"

namespace raycheck::tools {

/// The ray to explain (of a camera's pixel, or the given ray), and one sphere, if any.
struct ExplainOptions {
  scene::Scene scene;
  std::optional<scene::Pixel> pixel;  ///< Only if the scene has a camera.
  /// Empty: the sphere met first; if none is met, the first in the file.
  std::optional<std::size_t> sphere;
  const fast::PixelRayMethod* rays = kDefaultMethods.rays;  ///< Makes the rays to intersect.
  /// An external candidate, or null. All explanations use its conventions.
  std::shared_ptr<const Implementation> other = nullptr;
};

/// One step of the exact derivation; its value is a number or three coordinates.
struct Step {
  std::string symbol;
  std::string formula;
  std::vector<reference::ClosedForm> closed_form;  ///< One form, or three.
  std::vector<double> rounded;  ///< Correctly rounded; empty if the closed form is an input.
  /// The condition number with the scene's numbers as inputs.
  std::optional<double> condition = {};
  /// The condition number with the step's operands as inputs.
  std::optional<double> condition_alone = {};
};

/// A method's value at a step, and its error.
struct MethodStep {
  std::string symbol;
  std::vector<double> value;    ///< Empty for a miss.
  std::optional<double> error;  ///< The error; empty if the method or the exact answer is a miss.
  std::string_view unit;        ///< The unit of both errors.
  /// The error of this step with the method's values of earlier steps taken as exact; empty if
  /// there is none.
  std::optional<double> error_alone = {};
};

struct MethodReport {
  std::string name;
  std::vector<MethodStep> steps;
  bool is_other = false;  ///< Whether it is an external candidate.
  /// Whether it is an intersection method. Only then are the next four members valid.
  bool intersects = false;
  bool makes_ray = false;           ///< Whether it makes the pixel's ray. If not, it gets that ray.
  std::optional<double> parameter;  ///< s; empty for a miss.
  /// The error of s; empty unless the method and the exact answer are hits.
  std::optional<double> ulp_error;
  scene::Precision precision = scene::Precision::kDouble;  ///< The format of the ulp.
  /// The first discrepancy that the laws find in its answers; empty if there is none.
  std::optional<properties::Discrepancy> wrong = {};
  std::string goes_wrong_at;  ///< The symbol of the first wrong step; empty if all are right.

  /// Why it gave no answer after these steps; empty if it gave one.
  std::string failure() const {
    const bool has_failed = wrong && (wrong->wrong == properties::Wrong::kFailed ||
                                      wrong->wrong == properties::Wrong::kRefused);
    return has_failed ? wrong->what : "";
  }
  bool goes_wrong() const { return !goes_wrong_at.empty() || !failure().empty(); }
  bool is_excluded() const { return wrong && wrong->excluded_by; }
};

/// A root >= 0 that does not count, and the reason.
struct RootLeftOut {
  reference::WhichRoot root = reference::WhichRoot::kSmaller;
  double s = 0;  ///< Correctly rounded.
  reference::RootCounts why = reference::RootCounts::kYes;
};

/// The exact answer about one sphere.
struct SphereReport {
  reference::Intersection intersection;
  /// Whether it is a hit under the conventions, which define which roots count.
  bool is_hit = false;
  std::vector<RootLeftOut> left_out;  ///< The roots before the one that counts; all if none counts.
  std::optional<double> parameter;
  std::vector<double> point;
  std::optional<reference::ClosedForm> closed_form_parameter;
  std::vector<reference::ClosedForm> closed_form_point;
};

struct ExplainReport {
  scene::Scene scene;               ///< Rounded to the format of `other`.
  std::size_t rounded_numbers = 0;  ///< The number of scene numbers that were rounded.
  std::optional<scene::Pixel> pixel;
  scene::Ray ray;  ///< Valid if the scene has given rays.
  std::string rays_method;
  std::vector<Step> steps;
  std::vector<MethodReport> methods;
  std::shared_ptr<const Implementation> other;
  std::optional<std::size_t> sphere;  ///< The sphere of the derivation and of the methods.
  std::vector<SphereReport> spheres;
  /// The answer about that sphere if every root >= 0 counts; raycheck's methods are judged by it.
  /// Empty if the conventions say the same.
  std::optional<SphereReport> by_every_root;
  std::optional<std::size_t> nearest;

  const Step* find(const std::string& symbol) const;
  bool has_discrepancy() const;
};

/// Derives one ray step by step, exactly and with every method.
/// Domain: a valid scene; otherwise throws std::invalid_argument naming the field.
ExplainReport explain(const ExplainOptions& options);

/// A candidate's answers about the one ray of a case, and the verdict of the laws. report_rays() is
/// about the ray that it makes for the case's pixel; report_intersection() is about the ray's
/// intersection with the case's one sphere. Its steps are compared with those of exactly the ray
/// that it got.
/// Domain: a case under the conventions of `truth`, whose parts are shared; `own` is
///         raycheck's method if the candidate is one, which has more steps to show; or null.
MethodReport report_rays(const properties::Candidate& candidate, const properties::Case& the_case,
                         std::shared_ptr<properties::Truth> truth,
                         const fast::PixelRayMethod* own = nullptr);
MethodReport report_intersection(const properties::Candidate& candidate,
                                 const properties::Case& the_case,
                                 std::shared_ptr<properties::Truth> truth,
                                 const fast::IntersectMethod* own = nullptr);

std::string explain_text(const ExplainReport& report, const ViewOptions& options);
std::string explain_json(const ExplainReport& report, const ViewOptions& options);

/// The coordinates as a list.
template <class Triple>
std::vector<double> numbers(const Triple& value) {
  return {value.x, value.y, value.z};
}

/// A number with 17 significant digits; several numbers in parentheses.
std::string digits_text(double value);
std::string numbers_text(const std::vector<double>& values);
/// "off by 3 ulp (0.5 in this step)"; empty if there is no error.
std::string off_text(const MethodStep& step);
/// "condition number 4.2, of this step 1"; empty if there is none.
std::string condition_text(const Step& step);
/// The text about one method: "s = 6 (0x1.8p+2), off by 0.2 ulp".
std::string method_verdict(const MethodReport& method, const ExplainReport& report,
                           bool colours = false);
/// The part of method_verdict() after the answer: ", off by 0.2 ulp, a false hit (excused)". For a
/// method that makes rays, the whole text.
/// Domain: the method did not fail.
std::string answer_remarks(const MethodReport& method);
/// A remark for the step where a method goes wrong; usually empty.
std::string wrong_step_remark(const MethodReport& method, const ExplainReport& report);

inline constexpr View<ExplainReport> kExplainViews[] = {
    {"text", explain_text},
    {"json", explain_json},
};

}  // namespace raycheck::tools
