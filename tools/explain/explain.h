#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "properties/discrepancy.h"
#include "reference/account/closed_form.h"
#include "reference/exact_ray.h"
#include "scene/scene.h"
#include "tools/implementations/built_in.h"
#include "tools/report/view.h"

namespace raycheck::tools {

/// The explained ray of a scene (a camera's pixel or a given one), and one sphere, if any.
struct ExplainOptions {
  scene::Scene scene;
  std::optional<scene::Pixel> pixel;  ///< If the scene has a camera.
  std::optional<std::size_t> sphere;  ///< Empty: the sphere met first; if none is met, sphere 0.
  const fast::PixelRayMethod* rays = kDefaultMethods.rays;  ///< Makes the rays to intersect.
  /// An external candidate, whose conventions all explanations use; or null.
  std::shared_ptr<const Implementation> other = nullptr;
};

/// One step of the exact derivation: a scalar or three coordinates.
struct Step {
  std::string symbol;
  std::string formula;
  std::vector<reference::ClosedForm> closed_form;  ///< One, or three coordinates.
  std::vector<double> rounded;  ///< Correctly rounded; empty if the closed form is an input.
  std::optional<double> condition = {};        ///< kappa with respect to the scene's numbers.
  std::optional<double> condition_alone = {};  ///< kappa with respect to the step's operands.
};

/// A method's value at a step, and its error.
struct MethodStep {
  std::string symbol;
  std::vector<double> value;    ///< Empty if it has none (a miss).
  std::optional<double> error;  ///< The error of the value; empty if it or the truth is a miss.
  std::string_view unit;        ///< The unit of its errors.
  /// The error of only this step, whose operands are the method's values of earlier steps, taken as
  /// exact; empty if it has none.
  std::optional<double> error_alone = {};
};

struct MethodReport {
  std::string name;
  std::vector<MethodStep> steps;
  bool is_other = false;            ///< It is not one of raycheck's methods.
  bool intersects = false;          ///< It is an intersection method: the next four are valid.
  bool makes_ray = false;           ///< It makes the pixel's ray; if not, it is given the ray.
  std::optional<double> parameter;  ///< Empty: a miss.
  std::optional<double> ulp_error;  ///< Empty unless both hit.
  scene::Precision precision = scene::Precision::kDouble;  ///< The format of that ulp.
  /// The first discrepancy that the laws find in its answers, if any.
  std::optional<properties::Discrepancy> wrong = {};
  std::string goes_wrong_at;  ///< The first wrong step's symbol; empty: all are right.

  /// Why it gave no answer after these steps; empty if it gave one.
  std::string failure() const {
    const bool has_failed = wrong && (wrong->wrong == properties::Wrong::kFailed ||
                                      wrong->wrong == properties::Wrong::kRefused);
    return has_failed ? wrong->what : "";
  }
  bool goes_wrong() const { return !goes_wrong_at.empty() || !failure().empty(); }
  bool is_excluded() const { return wrong && wrong->excluded_by; }
};

/// A root >= 0 that does not count, and why.
struct RootLeftOut {
  reference::WhichRoot root = reference::WhichRoot::kSmaller;
  double s = 0;  ///< Correctly rounded.
  reference::RootCounts why = reference::RootCounts::kYes;
};

/// The exact answer about one sphere.
struct SphereReport {
  reference::Intersection intersection;
  bool is_hit = false;                ///< Under the conventions.
  std::vector<RootLeftOut> left_out;  ///< The roots before the one that counts.
  std::optional<double> parameter;
  std::vector<double> point;
  std::optional<reference::ClosedForm> closed_form_parameter;
  std::vector<reference::ClosedForm> closed_form_point;
};

struct ExplainReport {
  scene::Scene scene;               ///< In the format of `other`.
  std::size_t rounded_numbers = 0;  ///< The number of scene numbers that had to be rounded.
  std::optional<scene::Pixel> pixel;
  scene::Ray ray;  ///< If it is given.
  std::string rays_method;
  std::vector<Step> steps;
  std::vector<MethodReport> methods;
  std::shared_ptr<const Implementation> other;
  std::optional<std::size_t>
      sphere;  ///< The sphere that is derived, and intersected by the methods.
  std::vector<SphereReport> spheres;
  /// The exact answer for `sphere` if every root >= 0 counts, if the conventions differ: raycheck's
  /// methods are judged by it.
  std::optional<SphereReport> by_every_root;
  std::optional<std::size_t> nearest;

  const Step* find(const std::string& symbol) const;
  bool has_discrepancy() const;
};

/// Derives one ray step by step, exactly and with every method.
/// Domain: a valid scene; otherwise throws std::invalid_argument naming the field.
ExplainReport explain(const ExplainOptions& options);

std::string explain_text(const ExplainReport& report, const ViewOptions& options);
std::string explain_json(const ExplainReport& report, const ViewOptions& options);

/// Numbers with 17 significant digits; several in parentheses.
std::string digits_text(double value);
std::string numbers_text(const std::vector<double>& values);
/// "off by 3 ulp (0.5 by this step only)"; empty without an error.
std::string off_text(const MethodStep& step);
/// "condition number 4.2 (of this step only: 1)"; empty without one.
std::string condition_text(const Step& step);
/// The text about one method: "s = 6 (0x1.8p+2), off by 0.2 ulp".
std::string method_verdict(const MethodReport& method, const ExplainReport& report,
                           bool colours = false);
/// The part of method_verdict() after the answer, ", off by 0.2 ulp, a false hit (excused)"; the
/// whole text for a method that makes rays. Domain: it did not fail.
std::string answer_remarks(const MethodReport& method);
/// A remark for the step where a method goes wrong; usually empty.
std::string wrong_step_remark(const MethodReport& method, const ExplainReport& report);

inline constexpr View<ExplainReport> kExplainViews[] = {
    {"text", explain_text},
    {"json", explain_json},
};

}  // namespace raycheck::tools
