#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "tools/external/pictures/renderer.h"

namespace raycheck::tools {

/// A picture that a program made, and whether it has the requested name.
struct FoundPicture {
  std::filesystem::path path;
  bool is_named = true;
};

/// The picture that a program left in its folder, which held the driver file `scene` and no
/// picture: the one with the requested name; else one of a usual name (that of the driver file,
/// out, output, image, picture, result); else the newest. PPM and PNG count, links do not. Empty if
/// there is none.
std::optional<FoundPicture> found_picture(const std::filesystem::path& folder,
                                          const std::string& named, const std::string& scene);

/// A picture as text, stored between runs, and read back; empty if a text is not one.
std::string stored_text(const MadePicture& made);
std::optional<MadePicture> stored_picture(std::string_view text);

}  // namespace raycheck::tools
