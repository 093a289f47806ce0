#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

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

/// What the driver file and the picture are called in the folder of a run.
inline constexpr const char* kSceneFile = "scene.txt";
inline constexpr const char* kImageFile = "image.ppm";

/// A finished renderer: words that start it once a picture, {scene} standing for a driver file and
/// {image} for the picture that it is to make (PPM or PNG).
struct Renderer {
  Confined program;
  DriverForm driver = {};
  ColourHabit colours = {};
  double excused_change = properties::kExcusedImageChange;
  double threshold = 0;  ///< Hits with an s of at most this are not judged.
  /// The number of pictures not made in time after which it is no longer started.
  int most_silences = kMostSilences;
  std::shared_ptr<AnswerStore> answers = {};  ///< Null: it is started for every picture.
};

/// The driver file that a renderer is given for a scene: spheres have the colours that tell which
/// is seen. Domain: a scene with a camera.
std::string driver_text(const scene::Scene& scene, const DriverForm& form);

/// What the pixels show: none where they are as the background, a sphere where they have nearly its
/// colour, kSomeSphere otherwise. Errors: PictureError where the size is another.
properties::ImageAnswer image_answer(const ReadPicture& picture, const scene::Camera& camera,
                                     scene::Rows rows, std::size_t spheres,
                                     const ColourHabit& habit = {});

/// A picture that a renderer made, and how.
struct MadePicture {
  ReadPicture picture;
  std::string other_name;  ///< Where it was found; empty: under the name that was asked for.
  std::string ended;       ///< "exited with 1"; empty: as it should.
  std::string said;        ///< On its error output, else on its standard output.
};

/// Runs the program once for a driver file, or takes what it made of it before. A whole picture
/// counts, whatever the program's exit code; one of another size has no pixels. What it takes to
/// read it counts as the program's time. Errors: ProcessFailure, and std::runtime_error with
/// what is wrong with the picture.
MadePicture rendered(const Renderer& renderer, const std::string& driver, PictureSize size);

/// What the picture of a scene shows. Errors: as rendered() and image_answer().
properties::ImageAnswer render(const Renderer& renderer, const scene::Scene& scene,
                               scene::Rows rows);

}  // namespace raycheck::tools
