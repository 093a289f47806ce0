#pragma once

#include "tools/tradeoff/tradeoff.h"
#include "tools/view/document.h"

namespace raycheck::tools {

/// What a report has of all of its sources together, and of each.
std::vector<ChartFacet> tradeoff_facets(const TradeoffReport& report, bool with_each);

/// A report as a page: error against run time, on all of its sources together and on each.
ViewDocument tradeoff_document(const TradeoffReport& report);

}  // namespace raycheck::tools
