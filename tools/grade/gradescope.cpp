#include <fmt/core.h>

#include <algorithm>

#include "tools/grade/pages.h"
#include "tools/grade/words.h"
#include "tools/report/format.h"

namespace raycheck::tools {
namespace {

constexpr const char* kNothingAsked = "nothing of your submission could be run";

}  // namespace

std::string gradescope_results(const Rubric& rubric, const SubmissionGrade& grade) {
  Json json;
  json["score"] = grade.score;
  json["visibility"] = "visible";
  json["stdout_visibility"] = "hidden";
  json["output_format"] = "text";
  json["output"] =
      grade.refused.empty() ? rubric.title : fmt::format("{}:\n{}", kNothingAsked, grade.refused);
  json["tests"] = Json::array();
  for (std::size_t k = 0; k < grade.items.size(); ++k) {
    const Item& item = rubric.items[k];
    const ItemGrade told = thinned(rubric, item, grade.items[k]);
    if (told.state == kNotAsked) continue;
    Json test;
    test["name"] = item.name;
    test["number"] = std::to_string(k + 1);
    test["score"] = told.score;
    test["max_score"] = item.bonus ? 0 : told.points;
    if (item.bonus) test["name"] = fmt::format("{} (bonus, {} points)", item.name, item.points);
    test["status"] = told.state == kHolds ? "passed" : "failed";
    test["output_format"] = "text";
    test["output"] = item_text(item, told);
    test["visibility"] = kVisibilityNames[static_cast<std::size_t>(item.visibility)];
    json["tests"].push_back(std::move(test));
  }
  return json.dump(2) + "\n";
}

std::string prairielearn_results(const Rubric& rubric, const SubmissionGrade& grade) {
  Json json;
  // What cannot be run costs no attempt.
  json["gradable"] = grade.refused.empty();
  if (!grade.refused.empty()) json["format_errors"] = Json::array({grade.refused});
  json["score"] = grade.points > 0 ? std::min(grade.score / grade.points, 1.0) : 0.0;
  json["message"] = fmt::format("{}: {} of {} points", rubric.title, points_text(grade.score),
                                points_text(grade.points));
  json["output"] = grade.refused;
  json["tests"] = Json::array();
  for (std::size_t k = 0; k < grade.items.size(); ++k) {
    const Item& item = rubric.items[k];
    const ItemGrade told = thinned(rubric, item, grade.items[k]);
    if (told.state == kNotAsked || item.visibility != Visibility::kVisible) continue;
    json["tests"].push_back({{"name", item.name},
                             {"description", item.asks},
                             {"points", told.score},
                             {"max_points", told.points},
                             {"message", told.state},
                             {"output", item_text(item, told)}});
  }
  return json.dump(2) + "\n";
}

std::string class_json(const ClassGrade& graded) {
  Json json = json_header("grade");
  json["rubric"] = graded.rubric.title;
  json["interrupted"] = graded.interrupted;
  json["reused"] = graded.reused;
  json["submissions"] = Json::array();
  for (const SubmissionGrade& grade : graded.submissions) {
    json["submissions"].push_back(Json::parse(
        nlohmann::json(grade).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace)));
  }
  return json.dump(2) + "\n";
}

}  // namespace raycheck::tools
