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
  kNoPicture,  ///< It ended normally, but made no readable picture.
  kTimeUp,     ///< It timed out.
  kPicture,    ///< It made a picture that does not show the spheres.
  kSpheres     ///< It made a picture that shows the spheres.
};

/// The driver form and the colours of a renderer, determined before it is judged.
struct DryRun {
  DriverForm driver = {};    ///< The form that it reads; if it reads none, the first one.
  ColourHabit colours = {};  ///< How it shows spheres.
  double seconds = 0;        ///< CPU time of the last picture.
  Progress progress = Progress::kNothing;  ///< The progress in that form.
  std::string picture_name = {};           ///< The file of its picture; empty: the requested file.
  std::string said = {};                   ///< The program's output if it shows no sphere.
  /// The seconds that a picture needs, if they exceed the rubric's reply_seconds.
  std::optional<double> needed_seconds = {};
  std::vector<std::string> notes;  ///< Deviations from the rubric, a sentence each.
  /// A note that its pictures are black or of one colour; dropped if the submission gets points.
  std::string shows_nothing = {};
  std::optional<Refusal> refusal;  ///< Why it cannot be judged; empty if it can.

  bool shows_a_sphere() const { return progress == Progress::kSpheres; }
};

/// A picture shows the spheres of the dry run's scene if its likeness() is at least this. The
/// likeness is larger even with other sample positions, or if the picture is off by one pixel.
inline constexpr double kShownAlike = 0.6;

/// Draws a few small pictures of a symmetric, square scene with integer numbers, in which most
/// mistakes do not show. Other forms than that of `rule` are tried only if the renderer does not
/// read this form, or if two of its pictures in this form differ. Of the forms that it reads, the
/// most complete is preferred. If the user chose the form of `rule` and the renderer reads it, no
/// fuller form is used; if the renderer reads another form instead, a note names that. If it reads
/// no form, the result is for the form with the most progress. After three time-outs, no further
/// form is tried. If a renderer fails on ordinary scenes only because of the light, its form has no
/// light.
DryRun dry_run(Renderer renderer, const DriverRule& rule,
               const properties::RunControl& control = {});

/// Whether a renderer makes any picture of the dry run's scene, in one of the likeliest forms.
bool makes_a_picture(const Renderer& renderer, const DriverRule& rule);

}  // namespace raycheck::tools
