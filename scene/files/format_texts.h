#pragma once

#include <span>
#include <string_view>

namespace raycheck::scene {

/// A file of scene/formats/.
struct FormatText {
  std::string_view name, text;
};
extern const std::span<const FormatText> kFormatTexts;

}  // namespace raycheck::scene
