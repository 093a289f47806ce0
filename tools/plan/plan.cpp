#include "tools/plan/plan.h"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <functional>
#include <stdexcept>

#include "scene/interruption.h"

namespace raycheck::tools {
namespace {

using scene::SpherePlan;

/// "sphere 3", "spheres 3, 7, 12 and 41 more"
std::string spheres_text(const std::vector<std::size_t>& spheres) {
  constexpr std::size_t kShown = 4;
  std::string text = spheres.size() == 1 ? "sphere " : "spheres ";
  const std::size_t shown = spheres.size() <= kShown ? spheres.size() : kShown - 1;
  for (std::size_t k = 0; k < shown; ++k)
    text += fmt::format("{}{}", k > 0 ? ", " : "", spheres[k]);
  return shown == spheres.size() ? text
                                 : fmt::format("{} and {} more", text, spheres.size() - shown);
}

/// Counts what the items of a plan leave out.
class Accountant {
 public:
  Accountant(const scene::Scene& scene, const scene::ScenePlan& plan)
      : plan_(plan),
        asked_(which([](const SpherePlan& sphere) { return !sphere.left_out; })),
        pixels_(static_cast<std::uint64_t>(scene.camera->width) *
                static_cast<std::uint64_t>(scene.camera->height)) {
    for (const SpherePlan& sphere : plan.spheres) {
      pairs_ += static_cast<std::uint64_t>(sphere.pixels.count());
    }
  }

  /// In the order of kPlanItems; the filter's count comes from deciding pixels.
  std::vector<ItemReport> items() const {
    return {spheres_left_out(scene::LeftOut::kOutsideView, "no ray of the image meets it"),
            spheres_left_out(scene::LeftOut::kBehind, "all of it is behind where rays start"),
            hidden(),
            rectangles(),
            constants(),
            far_root(),
            behind_test(),
            scaling(),
            {0, 0, plan_.wanted == scene::Wanted::kClass ? "classes" : "pixels", ""},
            basis(),
            quantities()};
  }

 private:
  std::vector<std::size_t> which(const std::function<bool(const SpherePlan&)>& has) const {
    std::vector<std::size_t> indices;
    for (std::size_t k = 0; k < plan_.spheres.size(); ++k) {
      if (has(plan_.spheres[k])) indices.push_back(k);
    }
    return indices;
  }

  ItemReport spheres_left_out(scene::LeftOut how, const std::string& why) const {
    const auto found = which([how](const SpherePlan& s) { return s.left_out == how; });
    return {found.size(), plan_.spheres.size(), "spheres",
            found.empty() ? "there is none" : spheres_text(found) + ": " + why};
  }

  ItemReport hidden() const {
    ItemReport item =
        spheres_left_out(scene::LeftOut::kHidden, "a ray that meets it meets another no later");
    if (plan_.wanted != scene::Wanted::kNearest) {
      item.why = "only where nothing but the nearest sphere is wanted";
    }
    return item;
  }

  ItemReport rectangles() const {
    const std::uint64_t all = asked_.size() * pixels_;
    return {all - pairs_, all, "pairs", "certain bounds of the spheres' outlines"};
  }

  ItemReport constants() const {
    return {pairs_ - std::min<std::uint64_t>(pairs_, asked_.size()), pairs_, "pairs",
            "C - E along the axes and |C - E|^2 - r^2, once a sphere"};
  }

  ItemReport far_root() const {
    const auto inside = which([](const SpherePlan& s) { return !s.left_out && s.origin_inside; });
    const std::string why = plan_.conventions.root == scene::Root::kSmaller
                                ? "it never counts: root smaller"
                            : inside.empty() ? "no ray starts inside a sphere"
                                             : "rays may start inside " + spheres_text(inside);
    return {asked_.size() - inside.size(), asked_.size(), "spheres", why};
  }

  ItemReport behind_test() const {
    const auto behind = which([](const SpherePlan& s) { return !s.left_out && s.reaches_behind; });
    return {asked_.size() - behind.size(), asked_.size(), "spheres",
            behind.empty() ? "every sphere lies in front of where rays start"
                           : spheres_text(behind) + " may reach behind where rays start"};
  }

  ItemReport scaling() const {
    const scene::Scaling& scaling = plan_.eye.scaling();
    if (scaling == scene::Scaling{}) {
      return {1, 1, "scene",
              fmt::format("lengths are within 2^-{0} and 2^{0}, or the largest is about 1",
                          scene::kPlainExponent)};
    }
    return {0, 1, "scene",
            fmt::format("lengths are divided by 2^{}, the image plane's by 2^{}", scaling.lengths,
                        scaling.plane)};
  }

  ItemReport basis() const {
    if (plan_.eye.axis_aligned()) return {1, 1, "camera", "U, V, W are axes of the world"};
    return {0, 1, "camera", "U, V, W are not certainly axes of the world"};
  }

  ItemReport quantities() const {
    switch (plan_.wanted) {
      case scene::Wanted::kClass:
        return {3, 4, "quantities", "the class: no nearest sphere, s or Q"};
      case scene::Wanted::kNearest:
        return {2, 4, "quantities", "the nearest sphere: no s or Q"};
      case scene::Wanted::kParameter:
        return {1, 4, "quantities", "s: no Q"};
      case scene::Wanted::kPoint:
        break;
    }
    return {0, 4, "quantities", "Q, and all that leads to it"};
  }

  const scene::ScenePlan& plan_;
  std::vector<std::size_t> asked_;
  std::uint64_t pixels_;
  std::uint64_t pairs_ = 0;
};

void count_filtered(const reference::DecidedBy& decided_by, ItemReport& item) {
  item.left_out = decided_by.filter;
  item.of = decided_by.filter + decided_by.fallback();
  item.why = item.of == 0 ? "no pixel was decided"
             : decided_by.fallback() == 0
                 ? "doubles decide, within proved bounds on their errors"
                 : fmt::format("doubles leave {} undecided", decided_by.fallback());
}

}  // namespace

PlanReport make_plan(const PlanOptions& options, const properties::RunControl& control) {
  const scene::Interruptible interruptible(control.interrupted);
  scene::LoadedScene loaded = scene::load_scene(options.path, options.dialect);
  PlanReport report;
  report.path = options.path;
  report.warnings = std::move(loaded.warnings);
  report.scene = std::move(loaded.scene);
  report.dialect = loaded.dialect;
  report.not_needed = std::move(loaded.not_needed);
  report.top = options.top;
  if (!report.scene.camera) return report;
  const auto start = std::chrono::steady_clock::now();
  report.plan = scene::plan_scene(report.scene, report.scene.conventions, options.wanted);
  report.plan_ms =
      std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  report.items = Accountant(report.scene, *report.plan).items();
  try {
    time_plan(report);
  } catch (const std::invalid_argument& error) {
    report.warnings.push_back(fmt::format("nothing is timed: {}", error.what()));
  } catch (const scene::Interrupted&) {
    // The answer is what was timed so far.
  }
  report.interrupted = control.interrupted();
  constexpr auto kFilter = std::find_if(kPlanItems.begin(), kPlanItems.end(),
                                        [](const auto& item) { return item.name == "filter"; });
  count_filtered(report.decided_by,
                 report.items[static_cast<std::size_t>(kFilter - kPlanItems.begin())]);
  return report;
}

}  // namespace raycheck::tools
