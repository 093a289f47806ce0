#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scene/files/format.h"
#include "scene/files/scene_file.h"
#include "scene/files/toml_fields.h"
#include "tools/report/picture_file.h"

namespace raycheck::tools {

/// The light in a driver file. The spheres do not reflect it.
enum class DriverLight {
  kBehind,  ///< One light, behind the eye and not at the world's origin.
  kNone
};
inline constexpr std::array<std::string_view, 2> kDriverLightNames = {"behind", "none"};

/// The format of numbers in driver files. In both formats, a number reads back as the same double.
enum class DriverNumbers {
  kShortest,  ///< The shortest decimals, with an exponent if that is shorter.
  kFixed      ///< Never an exponent.
};
inline constexpr std::array<std::string_view, 2> kDriverNumberNames = {"shortest", "fixed"};

/// Whether the folder of a run may have a scene file of this name.
bool is_scene_file(std::string_view name);

/// The form of the scene files that a renderer reads: a format, and how its files deviate from it,
/// which is possible if the format has forms.
struct DriverForm {
  const scene::FileFormat* format = scene::format_named("B");  ///< Never null.
  /// The count of numbers in a sphere's line.
  std::int64_t sphere_numbers = format->has_forms() ? format->sphere_numbers.front() : 0;
  std::vector<std::string> extra_lines = {};  ///< Verbatim: "recursionlevel 0".
  DriverLight light = DriverLight::kBehind;
  DriverNumbers numbers = DriverNumbers::kShortest;
  /// The order of the keywords, with `extra` for the extra lines; empty: the usual order.
  std::vector<std::string> order = {};

  friend bool operator==(const DriverForm&, const DriverForm&) = default;
  /// What the names of its files end in: ".txt".
  std::string ending() const;
  /// The name of its file in the folder of a run.
  std::string file_name() const;
  /// "B, spheres of 16 numbers, recursionlevel 0, a light"
  std::string text() const;
  /// The whole form as one command line argument: "2020", "B:17:recursionlevel 0:no-light".
  std::string name() const;
};

/// The keywords of a format's lines in the usual order, each at most once.
std::vector<std::string> usual_order(const scene::FileFormat& format);

/// A named form: of a format with forms (A, B, C), or one of its presets (2017 to 2020).
struct DriverPreset {
  std::string_view name;
  DriverForm form;
};
const std::vector<DriverPreset>& driver_presets();

/// The form with this name, in upper or lower case; empty if there is none.
std::optional<DriverForm> driver_preset(std::string_view name);

/// Parses DriverForm::name(): a preset or a format, followed by parts in any order, separated by
/// colons. A part is the count of numbers of a sphere, `no-light` (or `light`), `fixed` (or
/// `shortest`), `order=eye,look,...`, or an extra line without colons. Extra lines replace those of
/// the preset. Errors: std::invalid_argument naming the part that is wrong.
DriverForm driver_form(std::string_view name);

/// The forms of driver files to try on a renderer.
struct DriverRule {
  DriverForm form = {};
  /// Whether to try the other known forms if the renderer does not read `form`.
  bool tries_others = true;
  bool is_asked_for = false;  ///< Whether the user chose `form`. If not, it is only tried first.
};

/// Parses a preset, a format's name or file (*.toml, relative to a folder), `auto`, or a text for
/// driver_form(). Errors: std::invalid_argument, which lists the names or is that of driver_form();
/// scene::SceneFileError about the format's file.
DriverRule driver_rule(std::string_view name, const std::filesystem::path& folder = {});

/// Reads the table [driver] of a rubric: `preset`, as for driver_rule(), and `others`, whether to
/// try other forms.
/// Errors: scene::SceneFileError naming file, line, field and value.
DriverRule read_driver(scene::TomlFields& fields, const scene::TomlFields::Table& from,
                       const std::filesystem::path& folder);

/// For a form without extra lines: the form with the extra lines and sphere numbers of each preset
/// of its format, the most complete first. Empty for a form with extra lines.
std::vector<DriverForm> fuller_forms(const DriverForm& form);

/// All known forms: `first`, then similar ones, then the others.
std::vector<DriverForm> known_forms(const DriverForm& first);

/// A scene file with spheres of these colours. Domain: a scene that the format expresses, one
/// colour for each sphere, a form whose `order` is a permutation of the usual order.
std::string driver_text(const scene::Scene& scene, const DriverForm& form,
                        const std::vector<Colour>& colours);

}  // namespace raycheck::tools
