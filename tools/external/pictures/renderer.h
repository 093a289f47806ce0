#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "properties/candidate.h"
#include "tools/external/answer_store.h"
#include "tools/external/pictures/driver_form.h"
#include "tools/external/pictures/sphere_colours.h"
#include "tools/external/sandbox/process.h"
#include "tools/report/picture_file.h"

namespace raycheck::tools {

/// A candidate is dropped when its time-outs add up to this number of full time limits.
inline constexpr int kMostTimeouts = 3;

/// The most pixels of a picture, whatever the size of the scene.
inline constexpr std::int64_t kMostPicturePixels = std::int64_t{1} << 26;

/// The names of the driver file and the picture in the folder of a run.
inline constexpr const char* kSceneFile = "scene.txt";
inline constexpr const char* kImageFile = "image.ppm";

/// The exit code of a command whose input format cannot express the scene: Automake's code for
/// skipped tests.
inline constexpr int kCannotSay = 77;

/// A finished renderer: its command line, run once per picture; {scene} stands for a driver file
/// and {image} for the picture to make (PPM or PNG).
struct Renderer {
  Confined program;
  /// The command whose exit code kCannotSay is trusted: if `program` exits with it and makes no
  /// picture, this command is run on the same scene and must exit with it, too. Empty: this exit
  /// code is a failure like others.
  std::optional<Confined> wrapper = {};
  DriverForm driver = {};
  ColourHabit colours = {};
  double excused_change = properties::kExcusedImageChange;
  double threshold = 0;  ///< Wrong pixels with an exact s of at most this are excused.
  std::optional<scene::Origin> origin = {};  ///< Where its rays start; empty: as the scene says.
  /// The number of time-outs after which it is no longer started.
  int most_timeouts = kMostTimeouts;
  std::shared_ptr<AnswerStore> answers = std::make_shared<AnswerStore>();
};

/// The driver file of a scene, with colours that identify the spheres. Domain: it has a camera.
std::string driver_text(const scene::Scene& scene, const DriverForm& form);

/// The sphere that each pixel shows: empty for the background colour; the sphere whose colour the
/// pixel nearly has; else kSomeSphere. Errors: properties::OtherSize if the size is wrong.
properties::ImageAnswer image_answer(const ReadPicture& picture, const scene::Camera& camera,
                                     scene::Rows rows, std::size_t spheres,
                                     const ColourHabit& habit = {});

/// A renderer's picture.
struct MadePicture {
  ReadPicture picture;
  std::string other_name;  ///< The file name; empty: the requested one.
  std::string ended;       ///< "exited with 1"; empty: normally.
  std::string said;        ///< On standard error, else on standard output.
};

/// Runs the program on a driver file, or takes the stored picture of the `nth` run. A complete
/// picture counts, whatever the program's exit code; one of the wrong size has no pixels. The time
/// to read it is charged to the program. Errors: ProcessFailure (kCannotSay if the wrapper confirms
/// it), and std::runtime_error with the fault of the picture.
MadePicture rendered(const Renderer& renderer, const std::string& driver, PictureSize size,
                     int nth = 1);

/// Draws a scene and returns the sphere of each pixel. Errors: as rendered() and image_answer().
properties::ImageAnswer render(const Renderer& renderer, const scene::Scene& scene,
                               scene::Rows rows);

}  // namespace raycheck::tools
