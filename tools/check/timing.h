#pragma once

#include <vector>

#include "scene/scene.h"
#include "tools/check/check.h"

namespace raycheck::tools {

/// Times a candidate's methods through fast/'s batch interface on the scene's own rays.
Timing time_methods(const MethodPair& methods, const scene::Scene& scene,
                    const scene::Conventions& conventions, const std::vector<scene::Pixel>& pixels);

}  // namespace raycheck::tools
