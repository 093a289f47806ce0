#pragma once

#include <optional>
#include <string>
#include <vector>

#include "properties/run_control.h"
#include "tools/external/pictures/driver_form.h"
#include "tools/external/pictures/renderer.h"
#include "tools/external/sandbox/launch.h"

namespace raycheck::tools {

/// How far a renderer came with a driver file, from nothing on.
enum class Progress {
  kNothing,    ///< It was not started.
  kFailed,     ///< It failed, whatever it had made.
  kNoPicture,  ///< It ended as it should, without a picture that can be read.
  kTimeUp,     ///< It did not end in time.
  kPicture,    ///< A picture.
  kSpheres     ///< A picture that shows the spheres.
};

/// What a renderer reads and shows, determined before anything is judged.
struct DryRun {
  DriverForm driver = {};    ///< The form that it reads, or the first if it reads none.
  ColourHabit colours = {};  ///< How it shows spheres.
  double seconds = 0;        ///< For the last picture that it made.
  Progress progress = Progress::kNothing;  ///< In that form.
  std::string picture_name = {};           ///< Where its picture is; empty: where it was told.
  std::string said = {};                   ///< Its output if it shows no sphere.
  /// Seconds per picture, if the rubric's reply_seconds are too few.
  std::optional<double> needed_seconds = {};
  std::vector<std::string> notes;  ///< Deviations from the rubric, a sentence each.
  /// Says that its pictures are black, or of one colour; not true of a submission that gets points
  /// on other scenes.
  std::string shows_nothing = {};
  std::optional<Refusal> refusal;  ///< Why nothing can be judged.

  bool shows_a_sphere() const { return progress == Progress::kSpheres; }
};

/// A picture shows the spheres of the dry run's scene if this share of what it or the truth shows
/// is shown by both: other samples, or a step too many, leave more.
inline constexpr double kShownAlike = 0.6;

/// Has a few small pictures made, of a scene on which most mistakes do not show: symmetric and
/// square, its numbers whole. The forms other than `rule`'s first are tried only where that one is
/// not read, or is not drawn alike twice; of forms that are read the one that leaves nothing unsaid
/// is preferred. Where the rule asks for that one, no other is taken, and a note says which one is
/// read. Where no form is read, what is said is of the one in which it came farthest. After three
/// pictures that are not made in time no further form is tried. What fails on ordinary scenes by
/// the light of its form alone is given none.
DryRun dry_run(Renderer renderer, const DriverRule& rule,
               const properties::RunControl& control = {});

}  // namespace raycheck::tools
