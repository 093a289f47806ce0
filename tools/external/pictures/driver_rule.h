#pragma once

#include <string_view>

#include "scene/files/toml_fields.h"
#include "tools/external/pictures/driver_form.h"

namespace raycheck::tools {

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

}  // namespace raycheck::tools
