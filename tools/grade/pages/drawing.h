#pragma once

// A failing case in a drawing that a report has in it.

#include <string>

#include "tools/grade/results/result.h"
#include "tools/view/document.h"

namespace raycheck::tools {

/// The wrong answer and the exact one, `figure` being what the page of figures has of the case: in
/// the plane through the ray and the sphere's centre, to scale or, where nothing would be seen,
/// magnified; of vectors and points in the plane of both. Empty where neither shows the difference.
std::string drawing_html(const FailingCase& failing, const SceneView& figure);

}  // namespace raycheck::tools
