#include "tests/tools/gates/sarif_schema.h"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>

#include "tests/tools/program.h"

namespace raycheck::tests {
namespace {

using nlohmann::json;

bool matches(const std::string& text, const std::string& pattern) {
  static std::map<std::string, std::regex> known;
  return std::regex_search(text, known.try_emplace(pattern, pattern).first->second);
}

/// What in a JSON value is not as a schema has it, in words; empty where all is. Of JSON Schema it
/// knows the words that sarif.schema.json uses; a key that `properties` does not name is an error.
std::string defect_of(const json& value, const json& schema, const std::string& at = "") {
  const auto is = [&](const std::string& type) {
    return type == "object"    ? value.is_object()
           : type == "array"   ? value.is_array()
           : type == "integer" ? value.is_number_integer()
                               : value.is_string();
  };
  if (schema.contains("enum")) {
    const json& values = schema["enum"];
    return std::find(values.begin(), values.end(), value) != values.end() ? "" : at + ": other";
  }
  if (!is(schema.at("type"))) return at + ": not of type " + schema["type"].get<std::string>();
  if (value.is_string() && schema.contains("pattern") &&
      !matches(value.get<std::string>(), schema["pattern"].get<std::string>())) {
    return at + ": does not match";
  }
  if (value.is_number() && value < schema.value("minimum", 0)) return at + ": too small";
  if (value.is_array()) {
    if (value.size() < schema.value("minItems", std::size_t{0})) return at + ": too few";
    if (value.size() > schema.value("maxItems", value.size())) return at + ": too many";
    for (const json& item : value) {
      if (auto why = defect_of(item, schema.at("items"), at + "[]"); !why.empty()) return why;
    }
  }
  if (!value.is_object()) return "";
  for (const json& key : schema.at("required")) {
    if (!value.contains(key)) return at + "/" + key.get<std::string>() + ": is missing";
  }
  for (const auto& [key, member] : value.items()) {
    if (!schema.at("properties").contains(key)) return at + "/" + key + ": is not known";
    const std::string why = defect_of(member, schema["properties"][key], at + "/" + key);
    if (!why.empty()) return why;
  }
  return "";
}

}  // namespace

std::string defect_of_log(const json& log) {
  static const json schema =
      json::parse(contents(std::string(RAYCHECK_SOURCE_DIR) + "/tests/tools/gates/"
                                                              "sarif.schema.json"));
  if (std::string why = defect_of(log, schema); !why.empty()) return why;
  const json& run = log["runs"][0];
  for (const json& result : run["results"]) {
    const json& rules = run["tool"]["driver"]["rules"];
    if (result["ruleIndex"] >= rules.size()) return "a rule that is not there";
    if (rules[result["ruleIndex"].get<std::size_t>()]["id"] != result["ruleId"]) {
      return "another rule than its index says";
    }
  }
  return "";
}

}  // namespace raycheck::tests
