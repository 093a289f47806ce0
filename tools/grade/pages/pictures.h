#pragma once

// The pictures of a failing case, as pages show them.

#include <string>
#include <string_view>

#include "tools/grade/results/result.h"

namespace raycheck::tools {

/// "12 of 441 pixels differ: yours is the expected picture mirrored left to right", `whose` being
/// "yours"; empty where there are no pictures, or what is exact is withheld.
std::string difference_text(const FailingCase& failing, std::string_view whose = "yours");

/// What the submission drew, what is expected and where they differ, beside each other: spheres in
/// colours that the colour-blind tell apart, differences by marks. What is withheld is not there;
/// empty where there are no pictures.
std::string pictures_html(const FailingCase& failing, std::string_view whose = "yours");

}  // namespace raycheck::tools
