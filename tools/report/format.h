#ifndef RAYCHECK_TOOLS_REPORT_FORMAT_H_
#define RAYCHECK_TOOLS_REPORT_FORMAT_H_

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "properties/verdict.h"
#include "reference/visibility/visibility.h"
#include "scene/conventions.h"

namespace raycheck::tools {

using Json = nlohmann::ordered_json;

/// An error for people: three significant digits, "0", "inf", or "-" where there is none.
std::string error_text(std::optional<double> error);

/// An error for programs: a number, null where there is none, the string "infinity".
Json error_json(std::optional<double> error);

/// Numbers as 17 digits and hexfloat, one after the other; "miss" where there are none.
std::string numbers_text(const std::vector<double>& numbers);

/// Doubles for programs: hexfloat strings, so that no reader rounds them.
Json hexfloats(const std::vector<double>& numbers);
Json hexfloat_or_null(std::optional<double> number);

/// False for what belongs to the scene as a whole.
bool has_place(properties::Quantity quantity);
/// "pixel (3, 4), sphere 0" or "ray 2".
std::string place_text(const properties::Place& place);

/// "rows bottom-first, samples edges, ..."
std::string conventions_text(const scene::Conventions& conventions);
Json conventions_json(const scene::Conventions& conventions);

/// What a discrepancy is, got, should have been, by how much and with what excuse; lines indented
/// by `indent`, the first one too.
std::string discrepancy_text(const properties::Discrepancy& discrepancy, std::string_view indent,
                             bool colours);
Json discrepancy_json(const properties::Discrepancy& discrepancy);

/// What a verdict compared, by quantity, with what its errors are worth.
Json weighed_json(const properties::Verdict& verdict);

/// "250 by the filter, 6 exactly (6 by intervals)"
std::string decided_by_text(const reference::DecidedBy& decided_by);
Json decided_by_json(const reference::DecidedBy& decided_by);

/// `text` in red, where colours are taken.
std::string red(std::string_view text, bool colours);

/// "1 sphere", "2 spheres"
std::string count_text(std::uint64_t count, std::string_view noun);

/// A name in front of a report's JSON, the same for every command.
Json json_header(std::string_view command);

}  // namespace raycheck::tools

#endif  // RAYCHECK_TOOLS_REPORT_FORMAT_H_
