#include <fmt/core.h>

#include "tools/grade/pages/views.h"
#include "tools/report/json.h"

namespace raycheck::tools {

/// https://gradescope-autograders.readthedocs.io/en/latest/specs/
std::string gradescope_results(const StudentGrade& grade) {
  const SubmissionGrade& submission = grade.submission;
  Json json;
  json["score"] = submission.score;
  json["visibility"] = "visible";
  json["stdout_visibility"] = "hidden";
  json["output_format"] = "text";
  json["output"] = grade.title;
  if (submission.refused) {
    json["output"] = "your submission could not be judged:\n" + refusal_text(*submission.refused);
  }
  json["tests"] = Json::array();
  for (std::size_t k = 0; k < grade.items.size(); ++k) {
    const Item& item = *grade.items[k];
    const ItemGrade& graded = submission.items[k];
    if (graded.state == ItemState::kNotAsked) continue;
    Json test;
    test["name"] = item.name;
    test["number"] = std::to_string(k + 1);
    test["score"] = graded.score;
    test["max_score"] = item.bonus ? 0 : graded.points;
    if (item.bonus) test["name"] = fmt::format("{} (bonus, {} points)", item.name, item.points);
    test["status"] = graded.state == ItemState::kHolds ? "passed" : "failed";
    test["output_format"] = "text";
    test["output"] = item_text(grade, k);
    test["visibility"] = kVisibilityNames[static_cast<std::size_t>(item.visibility)];
    json["tests"].push_back(std::move(test));
  }
  return json_text(json);
}

}  // namespace raycheck::tools
