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

inline constexpr std::array<std::string_view, 3> kDialectNames = {"A", "B", "C"};

/// The light of a driver file, under which spheres reflect nothing.
enum class DriverLight {
  kBehind,  ///< One, behind the eye and not at the origin.
  kNone
};
inline constexpr std::array<std::string_view, 2> kDriverLightNames = {"behind", "none"};

/// How the numbers of a driver file are written: either reads back as the same double.
enum class DriverNumbers {
  kShortest,  ///< The shortest decimals, with an exponent where that is shorter.
  kFixed      ///< Never an exponent.
};
inline constexpr std::array<std::string_view, 2> kDriverNumberNames = {"shortest", "fixed"};

/// The numbers that a sphere's line may have, the likeliest first.
inline constexpr std::array<int, 7> kSphereNumbers = {16, 17, 20, 13, 19, 18, 21};

/// In which form a program reads driver files.
struct DriverForm {
  scene::Dialect dialect = scene::Dialect::kB;
  /// Of a sphere's line: centre, radius, ambient, diffuse and specular colour are 13, the share of
  /// reflected light makes them 16; what comes after these (opacity, index of refraction) is 1.
  int sphere_numbers = 16;
  std::vector<std::string> extra_lines = {};  ///< As they stand: "recursionlevel 0".
  DriverLight light = DriverLight::kBehind;
  DriverNumbers numbers = DriverNumbers::kShortest;
  /// The keywords in their order, `extra` standing for the extra lines; empty: the usual order.
  std::vector<std::string> order = {};

  friend bool operator==(const DriverForm&, const DriverForm&) = default;
  /// "B, spheres of 16 numbers, recursionlevel 0, a light"
  std::string text() const;
  /// All of it in one word or two, for command lines: "2020", "B:17:recursionlevel 0:no-light".
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

/// The form of that name, in either case; empty where there is none.
std::optional<DriverForm> driver_preset(std::string_view name);

/// Reads what DriverForm::name() writes: a preset, then parts behind colons, in any order: the
/// numbers of a sphere's line, `no-light` (or `light`), `fixed` (or `shortest`),
/// `order=eye,look,...`, and extra lines as they stand, which replace the preset's. In a line `%3A`
/// is a colon; %XX stands for any byte, so that a line may be like another part.
/// Errors: std::invalid_argument naming the part that is wrong.
DriverForm driver_form(std::string_view name);

/// In which form driver files are written for renderers.
struct DriverRule {
  DriverForm form = {};
  /// A renderer that does not read this one is given the others that are known.
  bool tries_others = true;
  bool is_asked_for = false;  ///< Otherwise it is only what is tried first.
};

/// By the name of a preset, `auto`, or what driver_form() takes.
/// Errors: std::invalid_argument that lists the names, or what driver_form() throws.
DriverRule driver_rule(std::string_view name);

/// The table [driver] of a rubric: a `preset`, as driver_rule() takes it, and whether `others` are
/// tried where it is not read. Errors: scene::SceneFileError naming file, line, field and value.
DriverRule read_driver(scene::TomlFields& fields, const scene::TomlFields::Table& from);

/// The form of a dialect.
DriverForm form_of(scene::Dialect dialect);

/// Every form that programs are known to read, those like `first` before others; `first` leads.
std::vector<DriverForm> known_forms(const DriverForm& first);

/// A driver file whose ambient light is 1, whose light (if any) nothing reflects, and whose spheres
/// have the ambient colours and no other. Domain: a scene with a camera, as many colours as
/// spheres, a form whose `order` is a permutation of the usual one.
std::string driver_text(const scene::Scene& scene, const DriverForm& form,
                        const std::vector<Colour>& colours);

}  // namespace raycheck::tools
