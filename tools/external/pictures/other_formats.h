#pragma once

#include <string_view>

#include "tools/external/sandbox/launch.h"
#include "tools/report/picture_file.h"

namespace raycheck::tools {

/// Whether a file name ends as the names of pictures do that are read here.
bool is_picture_name(std::string_view name);

/// Reads the picture that a program made, whatever the name of its file: PPM, PNG and PFM itself;
/// BMP, TGA, JPEG, HDR and EXR by ImageMagick, which is isolated like the program, has the default
/// limits, and whose time is charged to the program. Channels of HDR and EXR are clamped to [0, 1];
/// opacity is ignored. The colours of a JPEG are restored (restore_colours()), with the program's
/// background. If the picture has another size than `size`, the result has no pixels. Errors:
/// PictureError; properties::CannotBeSaid, which is also recorded in the program's `surroundings`,
/// if ImageMagick is missing or cannot read this format at all.
ReadPicture read_picture(const std::string& bytes, const Confined& program, const PictureSize& size,
                         const Colour& background);

}  // namespace raycheck::tools
