#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scene/conventions.h"
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

/// The quality of code that is right on a case, as measured for the severities of
/// properties/cases/. A level includes all levels before it.
enum class Level {
  kOrdinary,   ///< Any plain, careful code in doubles.
  kDemanding,  ///< A stable method: far, grazing, nearly tied; no square over- or underflows.
  kExtreme     ///< All that doubles can express.
};
inline constexpr std::array<std::string_view, 3> kLevelNames = {"ordinary", "demanding", "extreme"};
constexpr auto& names_of(Level /*of*/) { return kLevelNames; }
using scene::name;

/// The numbers that a candidate accepts: those of a format and, if it needs unit directions, only
/// rays with directions of length 1 up to rounding.
struct InputFormat {
  constexpr InputFormat(scene::Precision its_precision = scene::Precision::kDouble,
                        bool demands_unit_directions = false)
      : precision(its_precision), unit_directions(demands_unit_directions) {}
  scene::Precision precision;
  bool unit_directions;
  bool operator==(const InputFormat&) const = default;
};
inline constexpr std::array<InputFormat, 4> kInputFormats = {{{scene::Precision::kDouble, false},
                                                              {scene::Precision::kDouble, true},
                                                              {scene::Precision::kSingle, false},
                                                              {scene::Precision::kSingle, true}}};
/// The index of a format in kInputFormats.
constexpr std::size_t index_of(InputFormat format) {
  return 2 * static_cast<std::size_t>(format.precision) + (format.unit_directions ? 1 : 0);
}

/// A case with all numbers rounded to those that a candidate accepts. Truth, law and candidate all
/// get this case instead of the original.
struct RoundedCase {
  std::optional<Case> the_case;  ///< Empty if the case is left out.
  std::string reason;            ///< Why the case is left out.
  std::size_t changed = 0;       ///< The count of numbers that were rounded.
  std::size_t made_unit = 0;     ///< The count of given directions that were normalised.
};

/// Normalises given directions if the format requires unit directions, then rounds every number of
/// the scene to the format, to nearest, ties to even. The case is left out if a number becomes
/// infinite or 0, or if the rounded scene is invalid.
RoundedCase rounded_case(Case the_case, InputFormat format);

/// The ray with its direction normalised if the format requires it, and all numbers rounded.
scene::Ray rounded_ray(scene::Ray ray, InputFormat format);

/// Whether rounded_case() leaves the scene as it is.
bool is_of_format(const scene::Scene& scene, InputFormat format);

}  // namespace raycheck::properties
