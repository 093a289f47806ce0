#pragma once

// The failing cases of functions, to look at.

#include <cstddef>
#include <string>

#include "tools/grade/results/redaction.h"
#include "tools/view/document.h"

namespace raycheck::tools {

/// Whether item k has a figure: it was asked for functions, and fails on a case of which the
/// student is told what is exact.
bool has_figure(const StudentGrade& grade, std::size_t k);
bool has_figures(const StudentGrade& grade);

/// A scene and a finding for every item that has a figure, in their order, with what the submission
/// answered: nothing is run.
ViewDocument figures_document(const StudentGrade& grade);

/// Where the page has the figure of an item, by its place among those that have one.
std::string figure_address(std::size_t finding);

}  // namespace raycheck::tools
