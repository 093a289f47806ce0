#ifndef RAYCHECK_TOOLS_EXTERNAL_RENDERER_H_
#define RAYCHECK_TOOLS_EXTERNAL_RENDERER_H_

#include <memory>
#include <string>
#include <vector>

#include "properties/candidate.h"
#include "scene/files/scene_file.h"
#include "tools/external/sandbox/process.h"
#include "tools/report/picture_reader.h"

namespace raycheck::tools {

/// A finished renderer: words that start it once a picture, {scene} standing for a driver file and
/// {image} for the picture that it is to make (PPM or PNG).
struct Renderer {
  Confined program;
  scene::Dialect dialect = scene::Dialect::kB;
  double excused_change = properties::kExcusedImageChange;
  double threshold = 0;  ///< Hits with an s of at most this are not judged.
};

/// A driver file whose ambient light is 1, whose one light is black, and whose spheres have the
/// ambient colours id_colours() and no other.
std::string driver_text(const scene::Scene& scene, scene::Dialect dialect);

/// As many colours, none near black, as far from each other as their number allows.
std::vector<Colour> id_colours(std::size_t count);

/// What the pixels show: none where they are black, a sphere where they have nearly its colour,
/// kSomeSphere otherwise. Errors: PictureError where the size is another.
properties::ImageAnswer image_answer(const ReadPicture& picture, const scene::Camera& camera,
                                     scene::Rows rows, std::size_t spheres);

/// Runs the program once for a scene.
/// Errors: ProcessFailure, and std::runtime_error with what is wrong with the picture.
properties::ImageAnswer render(const Renderer& renderer, const scene::Scene& scene,
                               scene::Rows rows);

}  // namespace raycheck::tools

#endif  // RAYCHECK_TOOLS_EXTERNAL_RENDERER_H_
