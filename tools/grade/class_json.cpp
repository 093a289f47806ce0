#include <nlohmann/json.hpp>

#include "tools/grade/record.h"
#include "tools/grade/views.h"
#include "tools/report/json.h"
#include "tools/report/words.h"

namespace raycheck::tools {

std::string class_json(const ClassGrade& graded) {
  Json json = json_header("grade");
  json["rubric"] = graded.rubric.title;
  json["interrupted"] = graded.interrupted;
  json["reused"] = graded.reused;
  json["submissions"] = Json::array();
  for (const SubmissionGrade& grade : graded.submissions) {
    json["submissions"].push_back(Json::parse(record_text(grade)));
  }
  return json.dump(2) + "\n";
}

}  // namespace raycheck::tools
