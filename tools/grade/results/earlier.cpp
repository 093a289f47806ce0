#include "tools/grade/results/earlier.h"

#include <exception>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

namespace raycheck::tools {

std::optional<EarlierGrade> earlier_grade(const std::filesystem::path& folder) {
  std::ifstream file(folder / kRecordFile, std::ios::binary);
  if (!file) return {};
  try {
    const Json json = Json::parse(file);
    if (!json.at("finished").get<bool>()) return {};
    EarlierGrade grade;
    if (json.at("refused").is_null()) grade.score = json.at("score").get<double>();
    for (const Json& item : json.at("items")) {
      grade.items.emplace_back(item.at("name").get<std::string>(), item.at("score").get<double>());
    }
    grade.seed = json.at("seed");
    grade.isolation = json.at("isolated_by");
    if (json.contains("inputs")) grade.inputs = inputs_of(json.at("inputs"));
    return grade;
  } catch (const std::exception&) {
    return {};  // no record, then
  }
}

Json inputs_json(const GradeInputs& inputs) {
  Json items = Json::array();
  for (const auto& [item, digest] : inputs.items) {
    items.push_back({{"name", item}, {"digest", digest}});
  }
  return {{"raycheck", inputs.raycheck},
          {"submission", inputs.submission},
          {"rubric", inputs.rubric},
          {"items", std::move(items)}};
}

GradeInputs inputs_of(const Json& json) {
  GradeInputs inputs{json.at("raycheck"), json.at("submission"), json.at("rubric"), {}};
  for (const Json& item : json.at("items")) inputs.items[item.at("name")] = item.at("digest");
  return inputs;
}

}  // namespace raycheck::tools
