#pragma once

#include "tools/report/json.h"
#include "tools/view/document.h"

namespace raycheck::tools {

/// What every figure draws between, at and beside named places.
Json parts_json();

/// What a scene's figure is drawn of.
Json figure_json(const SceneView& view);

Json drawing_json(const PanelDrawing& drawing);

}  // namespace raycheck::tools
