#pragma once

#include "tools/report/json.h"
#include "tools/view/chart/chart.h"

namespace raycheck::tools {

/// What the page's script draws a chart of.
Json chart_json(const ChartView& chart);

}  // namespace raycheck::tools
