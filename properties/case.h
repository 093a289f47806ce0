#pragma once

#include <cstddef>
#include <deque>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "contract/declarations.h"
#include "scene/precision.h"
#include "scene/scene.h"

namespace raycheck::properties {

// The nouns of the theory, as in scene/.
using scene::Camera;
using scene::Conventions;
using scene::Pixel;
using scene::Point3;
using scene::Precision;
using scene::Ray;
using scene::Scene;
using scene::Sphere;
using scene::Vector3;

/// The input of a law: a scene and, if it has a camera, the pixels to judge. Given rays are all
/// judged.
struct Case {
  Scene scene;
  std::vector<Pixel> pixels;
};

/// The number of rays of a case that are judged.
std::size_t count_rays(const Case& the_case);

/// All pixels of a camera, row by row.
std::vector<Pixel> all_pixels(const Camera& camera);

using contract::kLevelNames;
using contract::Level;
using contract::name;

/// The inputs that a candidate accepts: numbers of a format and, if it needs unit directions, only
/// rays with directions of length 1 up to rounding; if it is given segments, only rays whose point
/// at s = 1 is of the format, too; spheres with this placement; cameras with these windows and, if
/// it is given view directions, only cameras for which A - E is of the format, or if it always
/// looks at a sphere, only cameras whose A is the centre of the first one. Without corners, pixels
/// are sampled at centres instead. Picks are asked for the middle pixel, too.
struct InputFormat {
  constexpr InputFormat(Precision its_precision = Precision::kDouble,
                        const contract::Interface& interface = {}, bool has_corners = true)
      : precision(its_precision),
        corners(has_corners),
        unit_directions(interface.directions == contract::Directions::kUnit),
        segments(interface.rays == contract::RayForm::kEnd),
        placement(interface.placement),
        windows(interface.windows),
        view(interface.view) {
    if (segments) unit_directions = false;  // the direction follows from the ends
  }
  Precision precision;
  bool corners, unit_directions, segments;
  contract::Placement placement;
  contract::Windows windows;
  contract::View view;
  bool middle_pixel = false;
  bool operator==(const InputFormat&) const = default;
};

/// A value for each of some formats.
template <class Value>
class ByFormat {
 public:
  /// The value of a format, which is added if it is missing. References stay valid.
  Value& operator[](InputFormat format) {
    for (auto& [one, value] : all_) {
      if (one == format) return value;
    }
    return all_.emplace_back(format, Value{}).second;
  }
  /// Domain: the format was added; otherwise throws std::out_of_range.
  const Value& at(InputFormat format) const {
    for (const auto& [one, value] : all_) {
      if (one == format) return value;
    }
    throw std::out_of_range("no value for this format");
  }
  auto begin() const { return all_.begin(); }
  auto end() const { return all_.end(); }

 private:
  std::deque<std::pair<InputFormat, Value>> all_;
};

/// A case with all numbers rounded to those that a candidate accepts. Truth, law and candidate all
/// get this case instead of the original.
struct RoundedCase {
  std::optional<Case> the_case;  ///< Empty if the case is left out.
  std::string reason;            ///< Why the case is left out.
  std::size_t changed = 0;       ///< The count of numbers that were rounded.
  std::size_t made_unit = 0;     ///< The count of given directions that were normalised.
  /// What was replaced because the candidate does not accept it: the camera's window, or spheres;
  /// as what it accepts.
  std::string replaced = {};
};

/// Moves and scales the scene so that its first sphere is one that the candidate accepts, and
/// leaves out the others; samples at centres in place of corners that the candidate is not asked
/// for, and adds the middle pixel if the format has it. Then it normalises given directions if the
/// format needs that, and rounds every number of the scene to the format, to nearest, ties to even,
/// and for segments the ends of given rays. Last it replaces a window that the candidate does not
/// accept, moves E and A so that A - E is of the format, or A to a sphere's centre, if that is
/// needed. The case is left out if a number leaves the format's range (becomes infinite, or 0), or
/// if the scene is then invalid or not of the format.
RoundedCase rounded_case(Case the_case, InputFormat format);

/// The same for a scene that a user gives: it is left out if something would be replaced.
RoundedCase rounded_scene(Scene scene, InputFormat format);

/// The ray with a direction of length 1, up to rounding.
Ray with_unit_direction(Ray ray, Precision precision);

/// The ray, rounded to the format.
Ray rounded_ray(Ray ray, InputFormat format);

/// Whether rounded_case() leaves the scene as it is.
bool is_of_format(const Scene& scene, InputFormat format);

}  // namespace raycheck::properties
