#pragma once

// The rubrics that come with raycheck, and their scenes.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace raycheck::tools {

/// Their names, without ".toml", in order.
std::vector<std::string> shipped_rubrics();

/// Where the one of that name lies, with or without ".toml"; empty: there is none.
std::optional<std::filesystem::path> shipped_rubric(const std::filesystem::path& name);

/// Where a scene lies that one of them names so; empty: there is none.
std::optional<std::filesystem::path> shipped_scene(const std::filesystem::path& name);

}  // namespace raycheck::tools
