#pragma once

#include "properties/cases/case_source.h"
#include "tests/caught/first_severity.h"
#include "tests/caught/known_reports.h"
#include "tests/caught/resolution.h"
#include "tests/standard.h"

namespace raycheck::caught {

/// The rows of a table that belong to one source.
template <class Row>
struct OfSource {
  const properties::CaseSource* source;
  std::vector<Row> rows;
};

/// The text of a cell in the tables of mutants or of resolutions.
std::string cell_of(const FirstCaught& row, const properties::CaseSource& source);
std::string cell_of(const Resolution& row);
std::string line_of(const KnownReport& report, const FoundReport& found);

// The parts of docs/what-is-caught.md; each replaces a mark `{{NAME}}` in the template.
std::string degenerate_table();                                                 // degenerate
std::string excused_table();                                                    // excused
std::string mutant_tables(const std::vector<OfSource<FirstCaught>>& found);     // mutants
std::string reports_table();                                                    // reports
std::string summary_table(const std::vector<OfSource<Resolution>>& found);      // summary
std::string resolution_tables(const std::vector<OfSource<Resolution>>& found);  // resolution
std::string severity_tables(const std::vector<OfSource<Resolution>>& found);    // severities

/// A cell of the table below a heading, found by the first words of its row and by its column.
/// Throws std::invalid_argument if it does not exist.
std::string cell_in(const std::string& page, const std::string& heading,
                    const std::vector<std::string>& row, std::string_view column);

}  // namespace raycheck::caught
