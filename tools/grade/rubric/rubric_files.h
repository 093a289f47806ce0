#pragma once

// The rubrics that come with raycheck and their scenes, in what scenes vary, and digests.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "properties/cases/varied_scene.h"
#include "scene/files/toml_fields.h"

namespace raycheck::tools {

/// Their names, without ".toml", in order.
std::vector<std::string> shipped_rubrics();

/// The path of the one with this name, with or without ".toml"; empty: there is none.
std::optional<std::filesystem::path> shipped_rubric(const std::filesystem::path& name);

/// The path of a scene that one of them names; empty: there is none.
std::optional<std::filesystem::path> shipped_scene(const std::filesystem::path& name);

/// The list `vary` of an item's pictures: how its scenes vary with the seed.
/// Errors: scene::SceneFileError naming file, line, field and value.
std::vector<properties::Variation> read_variations(const scene::TomlFields& fields,
                                                   const scene::TomlFields::Field& field);

/// SHA-256 of texts, in hexadecimal; different lists never hash the same bytes.
std::string digest(const std::vector<std::string>& texts);

/// The seed of a submission: the first 64 bits of HMAC-SHA-256 of its name under a secret,
/// unpredictable without the secret.
std::uint64_t secret_seed(std::string_view secret, std::string_view name);

}  // namespace raycheck::tools
