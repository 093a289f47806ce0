#include "tools/plan/plan.h"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <stdexcept>
#include <utility>

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

template <class Condition>
std::vector<std::size_t> which(const scene::ScenePlan& plan, const Condition& has) {
  std::vector<std::size_t> indices;
  for (std::size_t k = 0; k < plan.spheres.size(); ++k) {
    if (has(plan.spheres[k])) indices.push_back(k);
  }
  return indices;
}

ItemReport left_out(const scene::ScenePlan& plan, scene::LeftOut how, const char* why,
                    const char* why_none) {
  const auto found = which(plan, [how](const SpherePlan& s) { return s.left_out == how; });
  return {found.size(), plan.spheres.size(), "spheres",
          found.empty() ? why_none : spheres_text(found) + ": " + why};
}

ItemReport far_root(const scene::ScenePlan& plan, std::size_t asked) {
  const auto inside =
      which(plan, [](const SpherePlan& s) { return !s.left_out && s.origin_inside; });
  return {asked - inside.size(), asked, "spheres",
          plan.conventions.root == scene::Root::kSmaller
              ? "never the answer, since the smaller root is wanted"
          : inside.empty() ? "no ray starts inside a sphere"
                           : "rays may start inside " + spheres_text(inside)};
}

ItemReport behind_test(const scene::ScenePlan& plan, std::size_t asked) {
  const auto behind =
      which(plan, [](const SpherePlan& s) { return !s.left_out && s.reaches_behind; });
  return {asked - behind.size(), asked, "spheres",
          behind.empty() ? "every sphere lies in front of where rays start"
                         : spheres_text(behind) + " may reach behind where rays start"};
}

ItemReport scaling(const scene::ScenePlan& plan) {
  const scene::Scaling& scaling = plan.eye.scaling();
  const bool is_plain = scaling == scene::Scaling{};
  return {
      is_plain ? 1u : 0u, 1, "scene",
      is_plain
          ? fmt::format(
                "not needed: all lengths are between 2^-{0} and 2^{0}, or the largest is about 1",
                scene::kPlainExponent)
          : fmt::format("lengths are divided by 2^{}, those of the image plane by 2^{}",
                        scaling.lengths, scaling.plane)};
}

ItemReport quantities(scene::Wanted wanted) {
  constexpr std::array<std::pair<std::uint64_t, const char*>, 4> kLeftOut = {
      {{3, "only hit or miss is wanted, not the nearest sphere, s or Q"},
       {1, "s is wanted, not Q"},
       {0, "Q is wanted, which needs all others"},
       {2, "only the nearest sphere is wanted, not s or Q"}}};
  const auto& [count, why] = kLeftOut[static_cast<std::size_t>(wanted)];
  return {count, kLeftOut.size(), "quantities", why};
}

/// The effects of items, in the order of kPlanItems. The filter's count is set later, when pixels
/// are decided.
std::vector<ItemReport> items_of(const scene::Scene& scene, const scene::ScenePlan& plan) {
  const std::size_t asked = which(plan, [](const SpherePlan& s) { return !s.left_out; }).size();
  const auto all = asked * static_cast<std::uint64_t>(scene.camera->width) *
                   static_cast<std::uint64_t>(scene.camera->height);
  std::uint64_t pairs = 0;
  for (const SpherePlan& sphere : plan.spheres) {
    pairs += static_cast<std::uint64_t>(sphere.pixels.count());
  }
  ItemReport hidden =
      left_out(plan, scene::LeftOut::kHidden,
               "every ray that meets it meets another sphere first or at the same point",
               "no sphere is hidden by others");
  if (plan.wanted != scene::Wanted::kNearest) {
    hidden.why = "applies only if the nearest sphere is wanted and nothing else";
  }
  const bool is_aligned = plan.eye.axis_aligned();
  return {left_out(plan, scene::LeftOut::kOutsideView, "no ray of the image meets it",
                   "no sphere is outside the view"),
          left_out(plan, scene::LeftOut::kBehind, "entirely behind where rays start",
                   "no sphere is entirely behind where rays start"),
          std::move(hidden),
          {all - pairs, all, "pairs", "proved bounds of the spheres' outlines in the image"},
          {pairs - std::min<std::uint64_t>(pairs, asked), pairs, "pairs",
           "C - E along the axes, and |C - E|^2 - r^2, are computed once for each sphere"},
          far_root(plan, asked),
          behind_test(plan, asked),
          scaling(plan),
          {0, 0, plan.wanted == scene::Wanted::kClass ? "classes" : "pixels", ""},
          {is_aligned ? 1u : 0u, 1, "camera",
           is_aligned ? "U, V and W are parallel to the axes of the world"
                      : "U, V and W are not known to be parallel to the axes of the world"},
          quantities(plan.wanted)};
}

void count_filtered(const reference::DecidedBy& decided_by, ItemReport& item) {
  item.left_out = decided_by.filter;
  item.of = decided_by.filter + decided_by.fallback();
  item.why = item.of == 0 ? "no pixel was decided"
             : decided_by.fallback() == 0
                 ? "doubles decide, since their errors are below proved bounds"
                 : fmt::format("doubles leave {} undecided", decided_by.fallback());
}

}  // namespace

PlanReport make_plan(const PlanOptions& options, const properties::RunControl& control) {
  const scene::Interruptible interruptible(control.interrupted);
  PlanReport report;
  static_cast<scene::LoadedScene&>(report) = scene::load_scene(options.path, options.read_as);
  report.path = options.path;
  report.top = options.top;
  if (!report.scene.camera) return report;
  const auto start = std::chrono::steady_clock::now();
  report.plan = scene::plan_scene(report.scene, report.scene.conventions, options.wanted);
  report.plan_ms =
      std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  report.items = items_of(report.scene, *report.plan);
  try {
    time_plan(report);
  } catch (const std::invalid_argument& error) {
    report.warnings.push_back(fmt::format("nothing is timed: {}", error.what()));
  } catch (const scene::Interrupted&) {
    // The report contains the times so far.
  }
  report.interrupted = control.interrupted();
  constexpr auto kFilter = std::ranges::find(kPlanItems, "filter", &PlanItem::name);
  count_filtered(report.decided_by,
                 report.items[static_cast<std::size_t>(kFilter - kPlanItems.begin())]);
  return report;
}

}  // namespace raycheck::tools
