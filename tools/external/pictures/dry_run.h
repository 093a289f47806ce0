#pragma once

#include <optional>
#include <string>
#include <vector>

#include "properties/run_control.h"
#include "tools/external/pictures/driver_form.h"
#include "tools/external/pictures/renderer.h"
#include "tools/external/sandbox/launch.h"

namespace raycheck::tools {

/// How far a renderer came with a driver file, in increasing order.
enum class Progress {
  kNothing,    ///< It was not started.
  kFailed,     ///< It failed.
  kNoPicture,  ///< It ended normally, without a readable picture.
  kTimeUp,     ///< It timed out.
  kPicture,    ///< A picture.
  kSpheres     ///< A picture that shows the spheres.
};

/// The driver form and the colours of a renderer, determined before it is judged.
struct DryRun {
  DriverForm driver = {};                  ///< The form that it reads; else the first one.
  ColourHabit colours = {};                ///< How it shows spheres.
  double seconds = 0;                      ///< CPU time of the last picture.
  Progress progress = Progress::kNothing;  ///< In that form.
  std::string picture_name = {};           ///< The file of its picture; empty: the requested one.
  std::string said = {};                   ///< The program's messages if it shows no sphere.
  /// Seconds per picture, if the rubric's reply_seconds are too few.
  std::optional<double> needed_seconds = {};
  std::vector<std::string> notes;  ///< Deviations from the rubric, a sentence each.
  /// A note that its pictures are black or of one colour; dropped if it gets points elsewhere.
  std::string shows_nothing = {};
  std::optional<Refusal> refusal;  ///< Why it cannot be judged.

  bool shows_a_sphere() const { return progress == Progress::kSpheres; }
};

/// A picture shows the spheres of the dry run's scene if its likeness() is at least this. With
/// other sample positions, or off by one pixel, the likeness is still larger.
inline constexpr double kShownAlike = 0.6;

/// Draws a few small pictures of a scene on which most mistakes do not show: symmetric, square,
/// with integer numbers. Other forms than `rule`'s are tried only if that one is not read, or if
/// two pictures of it differ. Among forms that are read the most complete one is preferred. If the
/// user chose `rule`'s form and it is read, no fuller form is used; if another form is read
/// instead, a note names it. If no form is read, the result is that of the form with the most
/// progress. After three time-outs no further form is tried. If a renderer fails on ordinary scenes
/// only because of the light, its form has none.
DryRun dry_run(Renderer renderer, const DriverRule& rule,
               const properties::RunControl& control = {});

}  // namespace raycheck::tools
