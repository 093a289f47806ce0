#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "contract/declarations.h"
#include "scene/precision.h"
#include "scene/scene.h"

namespace raycheck::properties {

/// The input of a law: a scene and, if it has a camera, the pixels to judge. Given rays are all
/// judged.
struct Case {
  scene::Scene scene;
  std::vector<scene::Pixel> pixels;
};

/// The number of rays of a case that are judged.
std::size_t count_rays(const Case& the_case);

/// All pixels of a camera, row by row.
std::vector<scene::Pixel> all_pixels(const scene::Camera& camera);

using contract::kLevelNames;
using contract::Level;
using contract::name;

/// The numbers that a candidate accepts: those of a format and, if it needs unit directions, only
/// rays with directions of length 1 up to rounding; if it is given segments, only rays whose point
/// at s = 1 is of the format, too. Without corners, pixels are sampled at centres instead.
struct InputFormat {
  constexpr InputFormat(scene::Precision its_precision = scene::Precision::kDouble,
                        const contract::Interface& interface = {}, bool has_corners = true)
      : precision(its_precision),
        corners(has_corners),
        unit_directions(interface.directions == contract::Directions::kUnit),
        segments(interface.rays == contract::RayForm::kEnd) {}
  scene::Precision precision;
  bool corners, unit_directions, segments;
  bool operator==(const InputFormat&) const = default;
};
/// Segments have no unit directions.
inline constexpr contract::Interface kUnitDirections = {.directions = contract::Directions::kUnit};
inline constexpr contract::Interface kSegments = {.rays = contract::RayForm::kEnd};
inline constexpr std::array<InputFormat, 12> kInputFormats = {
    {{scene::Precision::kDouble},
     {scene::Precision::kDouble, kUnitDirections},
     {scene::Precision::kDouble, kSegments},
     {scene::Precision::kSingle},
     {scene::Precision::kSingle, kUnitDirections},
     {scene::Precision::kSingle, kSegments},
     {scene::Precision::kDouble, {}, false},
     {scene::Precision::kDouble, kUnitDirections, false},
     {scene::Precision::kDouble, kSegments, false},
     {scene::Precision::kSingle, {}, false},
     {scene::Precision::kSingle, kUnitDirections, false},
     {scene::Precision::kSingle, kSegments, false}}};
/// Its index among them.
constexpr std::size_t index_of(InputFormat format) {
  return (format.corners ? 0 : 6) + 3 * static_cast<std::size_t>(format.precision) +
         (format.unit_directions ? 1
          : format.segments      ? 2
                                 : 0);
}

/// A case with all numbers rounded to those that a candidate accepts. Truth, law and candidate all
/// get this case instead of the original.
struct RoundedCase {
  std::optional<Case> the_case;  ///< Empty if the case is left out.
  std::string reason;            ///< Why the case is left out.
  std::size_t changed = 0;       ///< The count of numbers that were rounded.
  std::size_t made_unit = 0;     ///< The count of given directions that were normalised.
};

/// Normalises given directions if the format needs that, then rounds every number of the scene to
/// the format, to nearest, ties to even, and for segments the ends of given rays. The case is left
/// out if a number leaves the format's range (becomes infinite, or 0), or if the rounded scene is
/// invalid.
RoundedCase rounded_case(Case the_case, InputFormat format);

/// The ray with a direction of length 1, up to rounding.
scene::Ray with_unit_direction(scene::Ray ray, scene::Precision precision);

/// The ray, rounded to the format.
scene::Ray rounded_ray(scene::Ray ray, InputFormat format);

/// Whether rounded_case() leaves the scene as it is.
bool is_of_format(const scene::Scene& scene, InputFormat format);

}  // namespace raycheck::properties
