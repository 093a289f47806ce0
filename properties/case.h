#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scene/precision.h"
#include "scene/scene.h"

namespace raycheck::properties {

/// What a law is applied to: a scene and, if it has a camera, the pixels to look at (given rays are
/// all looked at). A law does not know where its cases come from.
struct Case {
  scene::Scene scene;
  std::vector<scene::Pixel> pixels;
};

/// How many rays a case looks at.
std::size_t count_rays(const Case& the_case);

/// All pixels of a camera, row by row.
std::vector<scene::Pixel> all_pixels(const scene::Camera& camera);

/// What it takes to be right on a case, as measured at the dials of properties/cases/. A level
/// includes all levels before it.
enum class Level {
  kOrdinary,   ///< Any plain, careful code in doubles.
  kDemanding,  ///< A stable method: far, grazing, nearly tied; no square over- or underflows.
  kExtreme     ///< All that doubles can express.
};
inline constexpr std::array<std::string_view, 3> kLevelNames = {"ordinary", "demanding", "extreme"};
constexpr std::string_view name(Level level) {
  return kLevelNames[static_cast<std::size_t>(level)];
}

/// Which numbers a candidate is asked about: those of a format and, if it demands unit directions,
/// with rays whose directions are unit but for rounding.
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
/// Its place among them.
constexpr std::size_t index_of(InputFormat format) {
  return 2 * static_cast<std::size_t>(format.precision) + (format.unit_directions ? 1 : 0);
}

/// A case in the numbers that a candidate is asked about. It replaces the case before truth, law
/// and candidate see it, so that all three use the same numbers.
struct RoundedCase {
  std::optional<Case> the_case;  ///< Empty where it is left out.
  std::string reason;            ///< Why it is left out.
  std::size_t changed = 0;       ///< How many numbers of the scene had to be rounded.
  std::size_t made_unit = 0;     ///< And how many given directions to be made unit.
};

/// Every number of the scene rounded to the format, to nearest, ties to even, after given
/// directions have been made unit where they have to be and are not. Left out if a number leaves
/// the format's range (becomes infinite, or 0), or if the rounded scene has a defect.
RoundedCase rounded_case(Case the_case, InputFormat format);

/// The ray, rounded to the format.
scene::Ray rounded_ray(scene::Ray ray, InputFormat format);

/// Whether rounded_case() leaves the scene as it is.
bool is_of_format(const scene::Scene& scene, InputFormat format);

}  // namespace raycheck::properties
