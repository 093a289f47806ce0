
#include "tools/grade/pages/views.h"
#include "tools/grade/results/record.h"
#include "tools/report/json.h"

namespace raycheck::tools {

std::string class_json(const ClassGrade& graded) {
  Json json = json_header("grade");
  json["rubric"] = graded.rubric.title;
  json["interrupted"] = graded.interrupted;
  json["not_graded"] = graded.not_graded;
  json["submissions"] = list_json(graded.submissions, record_json);
  return json_text(json);
}

}  // namespace raycheck::tools
