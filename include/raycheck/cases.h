#ifndef RAYCHECK_CASES_H_
#define RAYCHECK_CASES_H_

// The rays, spheres and cameras that raycheck asks about: every case by its seed, the same on every
// machine. C++17; link raycheck::raycheck.

#include <raycheck/api.h>
#include <raycheck/scene.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace raycheck {

/// What is asked about: all rays of a scene, or these pixels of its camera.
struct Case {
  Scene scene;                ///< With a camera or rays.
  std::vector<Pixel> pixels;  ///< Of its camera; empty where there is none.
};

/// Where cases come from. A source with a dial is a stress family, whose cases become harder in one
/// respect.
struct Source {
  std::string name;         ///< "distance"
  std::string sentence;     ///< What its cases are.
  bool has_camera = false;  ///< Whether they ask about pixels, not about given rays.
  /// What severity counts, "log10 of the distance over the radius"; empty: it has none.
  std::string dial;
  /// Severities are 0..highest; those up to `ordinary` are ordinary, up to `demanding` demanding.
  int highest = 0, ordinary = 0, demanding = 0;
};

/// Every source, those with a camera first.
RAYCHECK_API std::vector<Source> sources();

/// Case k of a seed. Domain: the name of a source, 0 <= severity <= its highest; otherwise throws
/// std::invalid_argument.
RAYCHECK_API Case make_case(const std::string& source, std::uint64_t seed, std::uint64_t k = 0,
                            int severity = 0);

/// Valid cases that are simpler in one respect, the simplest first: a sphere, a pixel or a ray
/// fewer, a number with fewer digits. Errors: std::invalid_argument where the case is not valid.
RAYCHECK_API std::vector<Case> simpler(const Case& from);

/// A case made of bytes: of a source and severity that they choose, numbers of it exchanged for
/// those that the bytes spell. Empty where that is no problem any more: a direction of 0, say.
RAYCHECK_API std::optional<Case> case_of_bytes(const std::uint8_t* bytes, std::size_t count);

/// A case as a scene file for `raycheck check`, its pixels in a comment. Numbers read back
/// bit-identically.
RAYCHECK_API std::string scene_text(const Case& the_case);

/// Reads a scene file's text, TOML. Errors: std::runtime_error naming line, field and value.
RAYCHECK_API Scene read_scene(const std::string& text);

}  // namespace raycheck

#endif  // RAYCHECK_CASES_H_
