#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scene/files/scene_file.h"
#include "scene/files/toml_fields.h"
#include "tools/report/picture_file.h"

namespace raycheck::tools {

/// The light of a driver file, by which spheres reflect nothing.
enum class DriverLight {
  kBehind,  ///< One, behind the eye and not at the origin.
  kNone
};
inline constexpr std::array<std::string_view, 2> kDriverLightNames = {"behind", "none"};

/// How the numbers of a driver file are written; both read back as the same double.
enum class DriverNumbers {
  kShortest,  ///< The shortest decimals, with an exponent where that is shorter.
  kFixed      ///< Never an exponent.
};
inline constexpr std::array<std::string_view, 2> kDriverNumberNames = {"shortest", "fixed"};

/// How many numbers a sphere's line may have, the likeliest first.
inline constexpr std::array<int, 7> kSphereNumbers = {16, 17, 20, 13, 19, 18, 21};

/// The form in which a program reads driver files.
struct DriverForm {
  scene::Dialect dialect = scene::Dialect::kB;
  /// How many numbers a sphere's line has: centre, radius, ambient, diffuse and specular colour are
  /// 13, reflected light makes them 16; each further one (opacity, index of refraction) is 1.
  int sphere_numbers = 16;
  std::vector<std::string> extra_lines = {};  ///< As they stand: "recursionlevel 0".
  DriverLight light = DriverLight::kBehind;
  DriverNumbers numbers = DriverNumbers::kShortest;
  /// The keywords in order, `extra` standing for the extra lines; empty: the usual order.
  std::vector<std::string> order = {};

  friend bool operator==(const DriverForm&, const DriverForm&) = default;
  /// "B, spheres of 16 numbers, recursionlevel 0, a light"
  std::string text() const;
  /// All of it as one argument of a command line: "2020", "B:17:recursionlevel 0:no-light".
  std::string name() const;
};

/// The keywords of a dialect's lines in the usual order, each at most once.
std::vector<std::string> usual_order(scene::Dialect dialect);

/// A form by a name: a dialect (A, B, C) or a year of the course (2017 to 2020).
struct DriverPreset {
  std::string_view name;
  DriverForm form;
};
std::span<const DriverPreset> driver_presets();

/// The form of this name, in upper or lower case; empty if there is none.
std::optional<DriverForm> driver_preset(std::string_view name);

/// Reads what DriverForm::name() writes: a preset, then parts behind colons, in any order: the
/// numbers of a sphere's line, `no-light` (or `light`), `fixed` (or `shortest`),
/// `order=eye,look,...`, and extra lines as they stand, which replace the preset's and have no
/// colon.
/// Errors: std::invalid_argument naming the part that is wrong.
DriverForm driver_form(std::string_view name);

/// The form in which driver files are written for renderers.
struct DriverRule {
  DriverForm form = {};
  /// A renderer that does not read this form is given the other known ones.
  bool tries_others = true;
  bool is_asked_for = false;  ///< Otherwise it is merely tried first.
};

/// Named by a preset, `auto`, or a text for driver_form().
/// Errors: std::invalid_argument that lists the names, or as driver_form().
DriverRule driver_rule(std::string_view name);

/// The table [driver] of a rubric: a `preset`, as driver_rule() takes it, and whether `others` are
/// tried where it is not read. Errors: scene::SceneFileError naming file, line, field and value.
DriverRule read_driver(scene::TomlFields& fields, const scene::TomlFields::Table& from);

/// The form of a dialect.
DriverForm form_of(scene::Dialect dialect);

/// Of a form without extra lines those of its dialect that leave nothing unsaid that a year's
/// driver files say, the one that says most first.
std::vector<DriverForm> fuller_forms(const DriverForm& form);

/// All forms that programs are known to read: `first`, then those like it, then the others.
std::vector<DriverForm> known_forms(const DriverForm& first);

/// A driver file with ambient light 1, a light (if any) that nothing reflects, and spheres that
/// have these ambient colours and no others. Domain: a scene with a camera, as many colours as
/// spheres, a form whose `order` is a permutation of the usual one.
std::string driver_text(const scene::Scene& scene, const DriverForm& form,
                        const std::vector<Colour>& colours);

}  // namespace raycheck::tools
