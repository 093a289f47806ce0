#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "properties/verdict.h"
#include "reference/account/closed_form.h"
#include "reference/exact_ray.h"
#include "scene/scene.h"
#include "tools/implementations/built_in.h"
#include "tools/report/view.h"

namespace raycheck::tools {

/// What is explained: one ray of a scene (a camera's pixel or a given one) and one sphere, if any.
struct ExplainOptions {
  scene::Scene scene;
  std::optional<scene::Pixel> pixel;  ///< Where the scene has a camera.
  std::optional<std::size_t> sphere;  ///< Empty: the one met first, or else the first.
  const fast::PixelRayMethod* rays = kDefaultMethods.rays;  ///< Whose rays the intersections get.
  /// Someone else's implementation, by whose conventions all is explained; null: there is none.
  std::shared_ptr<const Implementation> other = nullptr;
};

/// One step of the exact derivation: a scalar or three coordinates.
struct Step {
  std::string symbol;
  std::string formula;
  std::vector<reference::ClosedForm> closed_form;  ///< One, or three coordinates.
  std::vector<double> rounded;  ///< Correctly rounded; empty: the closed form is an input's own.
  std::optional<double> condition = {};  ///< kappa by the scene's numbers; of axes, the worst's.
  std::optional<double> condition_alone = {};  ///< kappa by what goes into the step directly.
};

/// A method's value at a step, and how far it is off.
struct MethodStep {
  std::string symbol;
  std::vector<double> value;    ///< Empty: it has none (a miss).
  std::optional<double> error;  ///< From the exact value; empty where that or the value is a miss.
  std::string_view unit;        ///< Of its errors.
  /// The error of this step alone, fed with the method's own values of the steps before, taken
  /// exactly; empty where it has none.
  std::optional<double> error_alone = {};
};

struct MethodReport {
  std::string name;
  std::vector<MethodStep> steps;
  bool intersects = false;          ///< An intersection method; the next four speak of those only.
  bool makes_ray = false;           ///< The ray of a pixel, which it is otherwise given.
  std::optional<double> parameter;  ///< Empty: a miss.
  std::optional<double> ulp_error;  ///< Empty unless both hit.
  scene::Precision precision = scene::Precision::kDouble;  ///< What that is an ulp of.
  /// What the laws find wrong first with its answers; empty: nothing.
  std::optional<properties::Discrepancy> wrong = {};
  std::string goes_wrong_at;  ///< The first wrong step's symbol; empty: none.

  /// How it gave no answer, after these steps; empty: it did.
  std::string failure() const {
    const bool has_failed = wrong && (wrong->wrong == properties::Wrong::kFailed ||
                                      wrong->wrong == properties::Wrong::kRefused);
    return has_failed ? wrong->what : "";
  }
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
  bool is_hit = false;                ///< Under the conventions, which say what counts.
  std::vector<RootLeftOut> left_out;  ///< Before the one that counts, if any.
  std::optional<double> parameter;
  std::vector<double> point;
  std::optional<reference::ClosedForm> closed_form_parameter;
  std::vector<reference::ClosedForm> closed_form_point;
};

struct ExplainReport {
  scene::Scene scene;               ///< In the format of `other`.
  std::size_t rounded_numbers = 0;  ///< That were none of it.
  std::optional<scene::Pixel> pixel;
  scene::Ray ray;  ///< Where it is given.
  std::string rays_method;
  std::vector<Step> steps;
  std::vector<MethodReport> methods;
  std::shared_ptr<const Implementation> other;
  std::optional<std::size_t> sphere;  ///< The one derived and intersected by the methods.
  std::vector<SphereReport> spheres;
  /// Of that sphere, where the conventions say otherwise: raycheck's own methods count every root
  /// >= 0, and are judged so.
  std::optional<SphereReport> by_every_root;
  std::optional<std::size_t> nearest;

  const Step* find(const std::string& symbol) const;
  bool has_discrepancy() const;
};

/// Derives one ray step by step, exactly and by every method.
/// Domain: a valid scene; otherwise throws std::invalid_argument naming the field.
ExplainReport explain(const ExplainOptions& options);

std::string explain_text(const ExplainReport& report, const ViewOptions& options);
std::string explain_json(const ExplainReport& report, const ViewOptions& options);

/// What the text says of one method: "s = 6 (0x1.8p+2), off by 0.2 ulp".
std::string method_verdict(const MethodReport& method, const ExplainReport& report);
/// Of that what follows an answer, ", off by 0.2 ulp, a false hit (excused)"; of a method that
/// makes rays all of it. Domain: it did not fail.
std::string answer_remarks(const MethodReport& method);
/// What is added to the step at which a method goes wrong; mostly nothing.
std::string wrong_step_remark(const MethodReport& method, const ExplainReport& report);

inline constexpr View<ExplainReport> kExplainViews[] = {
    {"text", explain_text},
    {"json", explain_json},
};

}  // namespace raycheck::tools
