#pragma once

// Forms of scene files, as data: a template in which the numbers of a scene have names. Files are
// written by filling it, and read by matching its statements.

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scene/files/nested_text.h"
#include "scene/files/scene_file.h"
#include "scene/scene.h"

namespace raycheck::scene {

/// A part of a statement: a literal word, or a slot.
struct FormatPart {
  std::string word;  ///< A literal word; empty: a slot.
  std::string slot;  ///< "eye"; "_": any word; "*": any number of words.
  /// What is written in a slot that has no meaning: {_:1}; kUnit: a vector of length 1, {up:unit}.
  std::string written;
  std::size_t numbers = 0;  ///< How many numbers a slot has; 0: words.
};
inline constexpr std::string_view kUnit = "unit";
/// A sphere's colour that files may leave out with all after it, {colour:optional}.
inline constexpr std::string_view kOptional = "optional";

/// What separates the words of all formats.
inline constexpr std::string_view kBlanks = " \t\v\f\r\n";

/// The slot of the word for the side of an angle of view.
inline constexpr std::string_view kAxis = "fov_axis";

/// A keyword, and what comes after it.
struct FormatStatement {
  std::vector<FormatPart> parts;  ///< If the first is not a literal word, it is only written.
  std::string text;               ///< As in the template, with its line end.
  bool is_of_sphere = false;      ///< Whether it is repeated for each sphere.
  /// What it is read by: all parts, or the rows of a nested format, whose first begins a block.
  std::vector<std::vector<FormatPart>> rows = {};
  bool has(std::string_view slot) const {
    return std::ranges::any_of(parts, [&](const FormatPart& part) { return part.slot == slot; });
  }
  /// Its first word, or the name of its first slot: "light", "extra"; empty if it has neither.
  std::string_view keyword() const {
    if (parts.empty()) return "";
    return parts.front().word.empty() ? parts.front().slot : parts.front().word;
  }
};

/// A form of scene files (scene/formats/NAME.toml).
struct FileFormat {
  std::string name;  ///< "cse5607"; of a variant "cse5607-hfov".
  std::string title;
  std::filesystem::path path;         ///< The file, if it is a user's.
  std::vector<std::string> variants;  ///< Their names: "hfov".
  std::vector<std::string> endings;   ///< Of file names: ".nff".
  std::string comments;               ///< What begins a comment, up to the end of the line.
  std::string separators;             ///< Characters that separate words, besides blanks.
  std::string joint = " ";            ///< What is written between the numbers of a vector.
  bool by_lines = true;               ///< Whether a statement ends with its line, or row.
  Nesting nesting = Nesting::kNone;   ///< How its statements contain others.
  std::string transformation;         ///< If nested, the word before translate and scale.
  /// If nested: the word before a name and its meaning, that before more of it, what begins the
  /// name where it stands for its meaning, and another word before more of it. Of several
  /// definitions the last counts; in tags the first.
  std::array<std::string, 4> definition = {};
  /// Words that are read as others.
  std::map<std::string, std::string, std::less<>> synonyms;
  bool is_left_handed = false;  ///< Whether x has the opposite sign.
  /// Whether its programs leave U and V as long as the sine of the angle between A - E and the up
  /// vector, which widens the window by its inverse.
  bool up_widens = false;
  bool has_exponents = true;  ///< Whether numbers may be written with an exponent.
  int digits = 0;             ///< To which numbers are rounded; 0: none is rounded.
  std::vector<FormatStatement> statements;
  /// Keywords that are left out, and what they are called in reports; keywords of what raycheck
  /// cannot read, and what that is.
  std::map<std::string, std::string, std::less<>> ignored, refused;
  /// The numbers of slots that its files do not contain, as all programs have them; and those of
  /// files that leave them out to their program.
  std::map<std::string, std::vector<double>, std::less<>> fixed, defaults;
  /// For programs that read other forms of the format: the counts of numbers in a sphere's line and
  /// the lines in the place of {extra} to try, the likeliest first; and similar formats.
  std::vector<std::int64_t> sphere_numbers;
  std::vector<std::string> extra_lines, similar;
  /// The names of some forms: "2017", of "A:16:recursionLevel 0".
  std::map<std::string, std::string, std::less<>> presets;
  /// What it implies; otherwise empty. If its programs differ in it, only files are read so.
  bool is_of_programs = true;
  std::optional<Rows> rows = {};
  std::optional<Samples> samples = {};
  std::optional<Origin> origin = {};

  bool has(std::string_view slot) const;
  /// Whether it is a user's file; then its name is "ours.toml", that of a variant "ours.toml:hfov".
  bool is_of_user() const { return !path.empty(); }
  /// Whether its files have an angle of view in place of a window.
  bool has_angle() const { return !has("left") && !fixed.contains("left"); }
  /// Whether programs may read other forms of it.
  bool has_forms() const { return !sphere_numbers.empty(); }
  bool is_nested() const { return nesting != Nesting::kNone; }
};

/// Reads a format, and, if a variant is named, makes that variant's replacements in its template.
/// Errors: SceneFileError naming file, line, field and value.
FileFormat read_format(std::string_view text, std::string_view file, std::string_view variant = {});

/// The formats that come with raycheck, by name.
const std::map<std::string, FileFormat, std::less<>>& formats();

/// A format that comes with raycheck, or, if the name ends in ".toml", that of this file, which is
/// read once, or one of its variants. Null if there is none. Errors: SceneFileError.
const FileFormat* format_named(const std::filesystem::path& name, const std::string& variant = "");

/// The variants of a format: of other years of a course, say.
std::vector<const FileFormat*> variants_of(const FileFormat& format);

/// The format of a file, told by the keywords of its camera and the signs of their numbers or by
/// the ending of its name; otherwise the format with most of its camera's keywords in the file.
/// Null if no format has one.
const FileFormat* format_of(std::string_view file, std::string_view text);

/// Reads a scene file of a format; `file` is its name in errors and warnings.
/// Errors: SceneFileError naming file, line, field and value.
LoadedScene read_formatted(const FileFormat& format, std::string_view text, std::string_view file);

/// Reads a scene file of the asked format, or, if none is asked, of that which format_of() finds.
/// Errors: as of read_formatted(); also if the file is of no known format.
LoadedScene read_any_format(std::string_view text, std::string_view file,
                            const FileFormat* asked = nullptr);

/// Why files of a format cannot express a scene; empty if they can.
/// Domain: a valid scene with a camera.
std::string why_not_expressed(const FileFormat& format, const Scene& scene);

/// A file of the format; sphere k has the colour `colours[k]`, each part from 0 to 1, or white. If
/// the format's camera has a fixed eye, view direction or up vector, the scene is moved so that its
/// camera has them, which changes no picture.
/// Domain: why_not_expressed() is empty. Error: an angle is rounded, and so are A - E in a format
/// with view directions, vectors of length 1, centres that are moved, and all numbers in a format
/// with fewer digits.
std::string write_formatted(const FileFormat& format, const Scene& scene,
                            std::span<const std::array<double, 3>> colours = {});

/// A scene with a camera whose points and vectors have -x in place of x; its camera's U is then
/// mirrored, too.
Scene mirrored(Scene scene);

/// A text without its byte order mark, if it begins with one.
inline std::string_view without_mark(std::string_view text) {
  constexpr std::string_view kMark = "\xEF\xBB\xBF";
  return text.starts_with(kMark) ? text.substr(kMark.size()) : text;
}

/// The sine of the angle between two vectors. Error: a few roundings.
double sine_between(const Vector3& a, const Vector3& b);

/// Whether a slot is a number of pixels, and whether a number can be one: doubles have it exactly.
bool is_pixels(std::string_view slot);
bool is_whole(double number);

/// Whether a slot is of the camera, not of spheres.
bool is_of_camera(std::string_view slot);

/// The sign that the number of a slot must have; 0: any.
int sign_of_slot(std::string_view slot);

/// Whether a number has another sign, in the words that follow a statement's keyword.
bool has_wrong_sign(const FormatStatement& statement, std::string_view words);

/// An angle of view: of which side, and how it is given.
struct AngleSlot {
  enum class Side { kVertical, kHorizontal, kLarger, kSmaller } side;
  double half;  ///< The radians of half the angle, for a number of 1.
  /// Whether half the angle is that of half the image's height, not of half its width.
  bool is_vertical(const Camera& camera) const {
    if (side == Side::kVertical || side == Side::kHorizontal) return side == Side::kVertical;
    return (side == Side::kLarger) == (camera.height > camera.width);
  }
};
/// "fovy", "fov_larger", "fovx_half", "fovy_radians"; empty for other slots.
std::optional<AngleSlot> angle_slot(std::string_view slot);

}  // namespace raycheck::scene
