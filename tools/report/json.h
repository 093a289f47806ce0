#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "properties/mistakes/explanation.h"
#include "properties/verdict.h"
#include "reference/visibility/visibility.h"
#include "scene/conventions.h"
#include "scene/files/scene_file.h"

namespace raycheck::tools {

using Json = nlohmann::ordered_json;

/// The version of the reports in docs/json.md. It increases with every change that can break a
/// reader (a key or value is removed or changes its meaning), not with additions.
inline constexpr int kSchemaVersion = 6;

/// A report as text, on several lines or on one. Bytes that are not UTF-8 become U+FFFD, and no
/// character controls a terminal.
std::string json_text(const Json& json);
std::string json_line(const Json& json);

/// The start of every command's report.
Json json_header(std::string_view command);
/// The report of a command that was interrupted before it had results.
std::string interrupted_json_text(std::string_view command);

/// An error: a number, null, or the string "infinity".
Json error_json(std::optional<double> error);

/// write(value), or null if there is no value.
template <class Value, class Write = std::identity>
Json or_null(const std::optional<Value>& value, const Write& write = {}) {
  return value ? Json(write(*value)) : Json(nullptr);
}
inline Json text_or_null(const std::string& text) {
  return text.empty() ? Json(nullptr) : Json(text);
}

/// The list of write(value) for each value.
template <class Values, class Write>
Json list_json(const Values& values, const Write& write) {
  Json list = Json::array();
  for (const auto& value : values) list.push_back(write(value));
  return list;
}

/// Doubles as hexfloat strings, so that no reader rounds them.
Json hexfloats(const std::vector<double>& numbers);
Json hexfloat_or_null(std::optional<double> number);

Json conventions_json(const scene::Conventions& conventions);
Json pixel_json(const scene::Pixel& pixel);
Json place_json(const properties::Place& place);
/// Adds the file of a scene, and the size of its image (null if it has no camera).
void add_scene(Json& json, const std::string& path, const scene::Scene& scene);
/// The quantity and the kind of question on which too little was judged.
Json too_few_json(const std::pair<properties::Quantity, properties::Expected>& too_few);
/// Null for a defect.
Json excuse_json(const properties::Discrepancy& discrepancy);
Json discrepancy_json(const properties::Discrepancy& discrepancy);

Json explanations_json(const std::vector<properties::Explanation>& explanations);

/// The comparisons of one quantity, as the object that all reports use.
Json tally_json(properties::Quantity quantity, const properties::Tally& tally,
                scene::Precision precision = scene::Precision::kDouble);
/// All tallies of a verdict.
Json tallies_json(const properties::Verdict& verdict,
                  scene::Precision precision = scene::Precision::kDouble);
/// The numbers of a verdict's discrepancies that are defects, undecided, excused and not judged.
Json standings_json(const properties::Verdict& verdict);

Json decided_by_json(const reference::DecidedBy& decided_by);

}  // namespace raycheck::tools
