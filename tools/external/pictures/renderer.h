#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "properties/candidate.h"
#include "tools/external/answer_store.h"
#include "tools/external/pictures/driver_form.h"
#include "tools/external/pictures/sphere_colours.h"
#include "tools/external/sandbox/process.h"
#include "tools/report/picture_file.h"

namespace raycheck::tools {

/// A candidate is dropped when its time-outs add up to this number of full time limits.
inline constexpr int kMostTimeouts = 3;

/// A picture may have at most this many pixels, whatever the size of the scene.
inline constexpr std::int64_t kMostPicturePixels = std::int64_t{1} << 26;

/// The name of the picture in the folder of a run.
inline constexpr const char* kImageFile = "image.ppm";

/// The exit code of a command whose input format cannot express the scene. It is Automake's code
/// for skipped tests.
inline constexpr int kCannotExpress = 77;

/// What the numbers of depth pictures mean.
struct DepthForm {
  properties::Depth depth = properties::Depth::kDistance;
  float miss = std::numeric_limits<float>::infinity();  ///< Of pixels without a sphere.

  bool is_miss(float number) const { return number == miss || (number != number && miss != miss); }
  /// "z miss 0": as depth_form() reads it.
  std::string text() const;
};
/// Errors: std::invalid_argument, which says what is expected.
DepthForm depth_form(std::string_view text);

/// A finished renderer. Its command line is run once per picture; {scene} stands for a scene
/// file, {image} for the picture to make (read_picture() lists the formats), {width} and {height}
/// for its size. Without {image}, the program chooses the name, or takes it from the scene file.
struct Renderer {
  Confined program;
  /// The command that confirms exit code kCannotExpress: if `program` exits with it and makes no
  /// picture, this command is run on the same scene and must exit with it, too. Without this
  /// command, exit code kCannotExpress is a failure.
  std::optional<Confined> wrapper = {};
  DriverForm driver = {};
  ColourHabit colours = {};
  double excused_change = properties::kExcusedImageChange;
  double threshold = 0;     ///< Wrong pixels with an exact s of at most this are excused.
  bool any_sample = false;  ///< Whether any point of a pixel's square may be its sample.
  std::optional<DepthForm> depth = {};  ///< Empty: its pictures show colours.
  /// The number of time-outs after which it is no longer started.
  int most_timeouts = kMostTimeouts;
  std::shared_ptr<AnswerStore> answers = std::make_shared<AnswerStore>();

  /// Whether its arguments contain the picture's name.
  bool is_told_name() const;
};

/// The driver file of a scene, with colours that identify the spheres if the renderer shows them;
/// if not, with white spheres: it might draw one in the colour of its background. Domain: the scene
/// has a camera.
std::string driver_text(const scene::Scene& scene, const DriverForm& form,
                        const ColourHabit& habit = {});

/// The sphere that each pixel shows: empty for the background colour; the sphere whose colour the
/// pixel nearly has; kUnclear for the unclear pixels; kSomeSphere for every other colour. Errors:
/// properties::OtherSize if the size is wrong.
properties::ImageAnswer image_answer(const ReadPicture& picture, const scene::Camera& camera,
                                     scene::Rows rows, std::size_t spheres,
                                     const ColourHabit& habit = {});

/// A renderer's picture.
struct MadePicture {
  ReadPicture picture;
  std::string other_name;  ///< The name of its file; empty: the requested file.
  std::string ended;       ///< "exited with 1"; empty: the program ended normally.
  std::string said;  ///< The output on standard error or, if there is none, on standard output.
};

/// Runs the program on a driver file, or takes the stored picture of the `nth` run. A complete
/// picture counts, whatever the program's exit code. A picture of the wrong size is returned
/// without pixels; in a depth picture, hits are white and misses black. The time to read a picture
/// is charged to the program. Errors: ProcessFailure (kCannotExpress if the wrapper confirms it);
/// std::runtime_error if the picture is invalid; properties::CannotBeSaid if raycheck lacks the
/// program to read it.
MadePicture rendered(const Renderer& renderer, const std::string& driver, PictureSize size,
                     int nth = 1);

/// The sphere of each pixel of an image, and its numbers if it is a depth picture.
struct DrawnImage {
  properties::ImageAnswer spheres;
  properties::DepthAnswer depths;
};

/// Draws a scene, and returns what its image shows by the conventions that the renderer is judged
/// by. Errors: as rendered() and image_answer().
DrawnImage render(const Renderer& renderer, const scene::Scene& scene,
                  const scene::Conventions& conventions);

}  // namespace raycheck::tools
