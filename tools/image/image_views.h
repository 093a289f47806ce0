#pragma once

// The views of `image`, each in the file of its name.

#include "tools/image/image.h"
#include "tools/report/view.h"

namespace raycheck::tools {

std::string image_text(const ImageReport& report, const ViewOptions& options);
std::string image_json(const ImageReport& report, const ViewOptions& options);

inline constexpr View<ImageReport> kImageViews[] = {
    {"text", image_text},
    {"json", image_json},
};

}  // namespace raycheck::tools
