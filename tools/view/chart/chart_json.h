#ifndef RAYCHECK_TOOLS_VIEW_CHART_CHART_JSON_H_
#define RAYCHECK_TOOLS_VIEW_CHART_CHART_JSON_H_

#include "tools/report/json.h"
#include "tools/view/chart/chart.h"

namespace raycheck::tools {

/// What the page's script draws a chart of.
Json chart_json(const ChartView& chart);

}  // namespace raycheck::tools

#endif  // RAYCHECK_TOOLS_VIEW_CHART_CHART_JSON_H_
