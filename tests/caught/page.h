#pragma once

#include "properties/cases/case_source.h"
#include "tests/caught/first_severity.h"
#include "tests/caught/known_reports.h"
#include "tests/caught/resolution.h"
#include "tests/standard.h"

namespace raycheck::caught {

/// The part of a table of the page that belongs to one source.
template <class Row>
struct OfSource {
  const properties::CaseSource* source;
  std::vector<Row> rows;
};

/// The text of a cell of the tables of mutants, or of resolutions.
std::string cell_of(const FirstCaught& row, const properties::CaseSource& source);
std::string cell_of(const Resolution& row);
std::string line_of(const KnownReport& report, const FoundReport& found);

// The parts of docs/what-is-caught.md, each for a `{{NAME}}` of its template.
std::string degenerate_table();                                                 // degenerate
std::string excused_table();                                                    // excused
std::string mutant_tables(const std::vector<OfSource<FirstCaught>>& found);     // mutants
std::string reports_table();                                                    // reports
std::string summary_table(const std::vector<OfSource<Resolution>>& found);      // summary
std::string resolution_tables(const std::vector<OfSource<Resolution>>& found);  // resolution
std::string severity_tables(const std::vector<OfSource<Resolution>>& found);    // severities

/// The cell of a page in the table below a heading, by the first words of its row and by its
/// column; throws std::invalid_argument if it does not exist.
std::string cell_in(const std::string& page, const std::string& heading,
                    const std::vector<std::string>& row, std::string_view column);

}  // namespace raycheck::caught
