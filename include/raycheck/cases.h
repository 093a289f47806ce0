#ifndef RAYCHECK_CASES_H_
#define RAYCHECK_CASES_H_

// The rays, spheres and cameras that raycheck tests with. A seed gives the same case on every
// machine. C++17; link raycheck::raycheck.

#include <raycheck/api.h>
#include <raycheck/scene.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace raycheck {

/// A test case: all rays of a scene, or some pixels of its camera.
struct Case {
  Scene scene;                ///< It has a camera or rays.
  std::vector<Pixel> pixels;  ///< Pixels of its camera; empty without a camera.
};

/// A source of cases. If it has severities, a higher one makes its cases harder in one respect.
struct Source {
  std::string name;         ///< "distance"
  std::string sentence;     ///< Describes its cases.
  bool has_camera = false;  ///< Whether its cases have a camera and pixels instead of rays.
  /// What severity measures: "log10 of the distance over the radius". Empty without severities.
  std::string dial;
  /// Severities are 0..highest: ordinary up to `ordinary`, demanding up to `demanding`, then
  /// extreme.
  int highest = 0, ordinary = 0, demanding = 0;
};

/// Every source, those with a camera first.
[[nodiscard]] RAYCHECK_API std::vector<Source> sources();

/// Case k of the series that a seed starts, from one source and severity. Domain: the name of a
/// source, 0 <= severity <= its highest; otherwise throws std::invalid_argument.
[[nodiscard]] RAYCHECK_API Case make_case(const std::string& source, std::uint64_t seed,
                                          std::uint64_t k = 0, int severity = 0);

/// Valid cases that are simpler in one respect, the simplest first: one sphere, pixel or ray fewer,
/// or a number with fewer digits. Errors: std::invalid_argument if `from` is not valid.
[[nodiscard]] RAYCHECK_API std::vector<Case> simpler(const Case& from);

/// A case made from bytes. The bytes choose a source and a severity, and replace numbers of the
/// case by numbers that they encode. Empty if the result is invalid, for example has a direction of
/// 0.
[[nodiscard]] RAYCHECK_API std::optional<Case> case_of_bytes(const std::uint8_t* bytes,
                                                             std::size_t count);

/// A case as a scene file for `raycheck check`, its pixels in a comment. Reading the file gives the
/// same numbers to the bit.
[[nodiscard]] RAYCHECK_API std::string scene_text(const Case& the_case);

/// Reads the text of a scene file (TOML). Errors: std::runtime_error naming line, field and value.
[[nodiscard]] RAYCHECK_API Scene read_scene(const std::string& text);

}  // namespace raycheck

#endif  // RAYCHECK_CASES_H_
