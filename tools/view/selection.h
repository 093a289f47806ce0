#pragma once

#include <vector>

#include "properties/case.h"
#include "properties/tally.h"
#include "tools/view/document.h"

namespace raycheck::tools {

/// The ray and the sphere of a place in a scene; neither pixel nor ray where the place has none.
Selection selection_of(const properties::Place& place, const scene::Scene& scene);

/// Whether it says which ray is meant.
bool is_of_ray(const Selection& selection);

/// What a page of one case has to show: where it was found wrong, then all that the case looks at.
std::vector<Selection> selections_of(const properties::Case& the_case,
                                     const properties::Place& found);

}  // namespace raycheck::tools
