#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "properties/run_control.h"
#include "reference/visibility/visibility.h"
#include "scene/files/scene_file.h"
#include "scene/plan/plan.h"
#include "tools/report/view.h"

namespace raycheck::tools {

struct PlanOptions {
  std::string path;
  const scene::FileFormat* read_as = nullptr;
  scene::Wanted wanted = scene::Wanted::kNearest;
  std::size_t top = 20;  ///< The number of spheres in the text report.
};

/// An item of a plan: its name in reports, and what it leaves out.
struct PlanItem {
  std::string_view name;
  std::string_view sentence;
  bool scene::PlanItems::*member;
};

inline constexpr std::array<PlanItem, 11> kPlanItems = {{
    {"view", "spheres outside the view volume", &scene::PlanItems::view},
    {"behind", "spheres behind every ray's origin", &scene::PlanItems::behind},
    {"hidden", "spheres hidden by a nearer one", &scene::PlanItems::hidden},
    {"rectangles", "pixels outside a sphere's rectangle", &scene::PlanItems::rectangles},
    {"constants", "computing anew what all rays from the eye have in common",
     &scene::PlanItems::constants},
    {"far-root", "the far root", &scene::PlanItems::far_root},
    {"behind-test", "comparing roots with the origin", &scene::PlanItems::behind_test},
    {"scaling", "scaling by powers of two", &scene::PlanItems::scaling},
    {"filter", "exact arithmetic", &scene::PlanItems::filter},
    {"basis", "products with the camera's axes", &scene::PlanItems::basis},
    {"quantities", "quantities that are not wanted", &scene::PlanItems::quantities},
}};

/// Times of certified visibility, on one core: with the whole plan, and without one item of it.
struct PlanTime {
  double with_plan_ms = 0;
  double without_ms = 0;
  std::uint64_t pixels = 0;  ///< The number of pixels timed; times are scaled to the whole image.
};

/// The effect of an item: it leaves out `left_out` of `of` things; `noun` is their name.
struct ItemReport {
  std::uint64_t left_out = 0;
  std::uint64_t of = 0;
  std::string_view noun;
  std::string why;
  std::optional<PlanTime> time = {};  ///< Empty if nothing is left out, or if it was not measured.
};

struct PlanReport : scene::LoadedScene {
  std::string path;
  /// Only for scenes with a camera, because given rays have no computations in common.
  std::optional<scene::ScenePlan> plan;
  std::vector<ItemReport> items;   ///< In the order of kPlanItems.
  double plan_ms = 0;              ///< The time to make the plan.
  std::optional<double> image_ms;  ///< The time with the whole plan; empty if not timed.
  std::uint64_t pixels_timed = 0;
  reference::DecidedBy decided_by;  ///< How the timed pixels were decided.
  std::size_t top = 0;
  bool interrupted = false;  ///< If true, some items have no times.
};

/// Makes the plan of a scene file, and measures the time that each item saves. If the image is too
/// large (reference::kMostVisibleSide), adds a warning and measures nothing. Throws what the reader
/// of the file throws.
PlanReport make_plan(const PlanOptions& options, const properties::RunControl& control = {});

/// Fills in the times of a report that has a scene and a plan, and `decided_by`. Times the whole
/// image if that is quick, otherwise bands (or rows) spread over it.
/// Errors: std::invalid_argument if the image is too large (reference::kMostVisibleSide);
/// scene::Interrupted, which leaves the times so far in the report.
void time_plan(PlanReport& report);

std::string plan_text(const PlanReport& report, const ViewOptions& options);
std::string plan_json(const PlanReport& report, const ViewOptions& options);

inline constexpr View<PlanReport> kPlanViews[] = {
    {"text", plan_text},
    {"json", plan_json},
};

}  // namespace raycheck::tools
