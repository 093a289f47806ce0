#include <nlohmann/json.hpp>

#include "tools/grade/pages/views.h"
#include "tools/grade/results/record.h"
#include "tools/report/json.h"
#include "tools/report/words.h"

namespace raycheck::tools {

namespace {

Json score_json(const ScoreChange& change) {
  const auto points = [](const std::optional<double>& score) {
    return score ? Json(*score) : Json(nullptr);
  };
  return {{"name", change.name}, {"before", points(change.before)}, {"now", points(change.now)}};
}

Json changes_json(const ClassChanges& changes) {
  Json json = {{"against", changes.against},
               {"compared", changes.compared},
               {"new", changes.new_ones},
               {"changed", Json::array()}};
  for (const SubmissionChange& change : changes.changed) {
    Json one = score_json(change.score);
    one["items"] = Json::array();
    for (const ScoreChange& item : change.items) one["items"].push_back(score_json(item));
    one["causes"] = Json::array();
    for (const ChangeCause cause : change.causes) one["causes"].push_back(name(cause));
    one["rubric_items"] = change.rubric_items;
    json["changed"].push_back(std::move(one));
  }
  return json;
}

}  // namespace

std::string class_json(const ClassGrade& graded) {
  Json json = json_header("grade");
  json["rubric"] = graded.rubric.title;
  json["interrupted"] = graded.interrupted;
  json["reused"] = graded.reused;
  json["not_graded"] = graded.not_graded;
  json["submissions"] = Json::array();
  for (const SubmissionGrade& grade : graded.submissions) {
    json["submissions"].push_back(Json::parse(record_text(grade)));
  }
  json["changes"] = graded.changes ? changes_json(*graded.changes) : Json(nullptr);
  return json_text(json);
}

}  // namespace raycheck::tools
