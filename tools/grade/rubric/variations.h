#pragma once

#include <vector>

#include "properties/cases/varied_scene.h"
#include "scene/files/toml_fields.h"

namespace raycheck::tools {

/// The list `vary` of an item's pictures: in what its scenes differ from seed to seed.
/// Errors: scene::SceneFileError naming file, line, field and value.
std::vector<properties::Variation> read_variations(const scene::TomlFields& fields,
                                                   const scene::TomlFields::Field& field);

}  // namespace raycheck::tools
