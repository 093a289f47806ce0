#pragma once

#include "tools/stress/stress.h"
#include "tools/view/document.h"

namespace raycheck::tools {

/// The methods of one stage that are judged in one format, on a family.
ChartFacet stress_facet(const FamilyReport& family, properties::Stage stage,
                        scene::Precision precision);

/// All that a report has.
std::vector<ChartFacet> stress_facets(const StressReport& report);

/// A report as a page: error against severity, on each of its families.
ViewDocument stress_document(const StressReport& report);

}  // namespace raycheck::tools
