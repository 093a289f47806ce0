#pragma once

// Figures of failing cases of functions.

#include <cstddef>
#include <string>

#include "tools/grade/results/redaction.h"
#include "tools/view/document.h"

namespace raycheck::tools {

/// Whether item k has a figure: it asks for functions, and fails on a case whose exact answer the
/// student is told.
bool has_figure(const StudentGrade& grade, std::size_t k);
bool has_figures(const StudentGrade& grade);

/// A scene and a finding for every item that has a figure, in order, with the submission's answers:
/// nothing is run.
ViewDocument figures_document(const StudentGrade& grade);

/// The link to an item's figure, by its index among those with figures.
std::string figure_address(std::size_t finding);

}  // namespace raycheck::tools
