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

/// The number of silences after which an implementation is no longer asked.
inline constexpr int kMostSilences = 3;

/// Pixels that a picture has at most, whatever the size of the scene.
inline constexpr std::int64_t kMostPicturePixels = std::int64_t{1} << 26;

/// The names of the driver file and the picture in the folder of a run.
inline constexpr const char* kSceneFile = "scene.txt";
inline constexpr const char* kImageFile = "image.ppm";

/// The exit code of a command whose form of scene files cannot express the scene, as Automake has
/// tests skipped.
inline constexpr int kCannotSay = 77;

/// A finished renderer: its command line, run once per picture; {scene} stands for a driver file
/// and {image} for the picture to make (PPM or PNG).
struct Renderer {
  Confined program;
  /// The command whose exit code kCannotSay is believed: where `program` ends with it and makes no
  /// picture, this is run on the same scene and has to say so, too. Empty: it is a failure.
  std::optional<Confined> wrapper = {};
  DriverForm driver = {};
  ColourHabit colours = {};
  double excused_change = properties::kExcusedImageChange;
  double threshold = 0;                      ///< Hits with an s of at most this are not judged.
  std::optional<scene::Origin> origin = {};  ///< Where its rays start; empty: as asked.
  /// The number of pictures not made in time after which it is no longer started.
  int most_silences = kMostSilences;
  std::shared_ptr<AnswerStore> answers = std::make_shared<AnswerStore>();
};

/// The driver file of a scene for a renderer: the spheres' colours tell which is seen. Domain: a
/// scene with a camera.
std::string driver_text(const scene::Scene& scene, const DriverForm& form);

/// What the pixels show: nothing if they look like the background, a sphere if they have nearly its
/// colour, kSomeSphere otherwise. Errors: PictureError if the size is wrong.
properties::ImageAnswer image_answer(const ReadPicture& picture, const scene::Camera& camera,
                                     scene::Rows rows, std::size_t spheres,
                                     const ColourHabit& habit = {});

/// A picture that a renderer made, and how.
struct MadePicture {
  ReadPicture picture;
  std::string other_name;  ///< Where it was found; empty: where requested.
  std::string ended;       ///< "exited with 1"; empty: as it should.
  std::string said;        ///< On standard error, else on standard output.
};

/// Runs the program once for a driver file, or takes its stored picture: of the `nth` run. A
/// complete picture counts, whatever the program's exit code; one of the wrong size has no pixels.
/// Reading it counts as the program's time. Errors: ProcessFailure (kCannotSay where the wrapper
/// says so), and std::runtime_error with what is wrong with the picture.
MadePicture rendered(const Renderer& renderer, const std::string& driver, PictureSize size,
                     int nth = 1);

/// What the picture of a scene shows. Errors: as rendered() and image_answer().
properties::ImageAnswer render(const Renderer& renderer, const scene::Scene& scene,
                               scene::Rows rows);

}  // namespace raycheck::tools
