#pragma once

#include <optional>
#include <span>
#include <string>

#include "scene/scene.h"

namespace raycheck::properties {

/// A scene with a camera, and whether a program failed on it: gave no picture.
struct TriedScene {
  const scene::Scene* scene = nullptr;
  bool failed = false;
};

/// How many scenes it must fail on, and how many not, at least.
inline constexpr std::size_t kFewestOfEachOutcome = 2;

/// A property of scenes, and that a program fails only where they have it.
struct ShapeCause {
  std::string sentence;
  bool (*is)(const scene::Scene&) = nullptr;
};

/// What is common to all scenes on which a program fails, and to none of the others: "it fails only
/// where the picture is not square". Empty if there is no such property, or more than one.
std::optional<ShapeCause> shape_cause(std::span<const TriedScene> tried);

}  // namespace raycheck::properties
