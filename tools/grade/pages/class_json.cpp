
#include "tools/grade/pages/views.h"
#include "tools/grade/results/record.h"
#include "tools/report/json.h"
#include "tools/report/words.h"

namespace raycheck::tools {

namespace {

Json score_json(const ScoreChange& change) {
  return {{"name", change.name}, {"before", or_null(change.before)}, {"now", or_null(change.now)}};
}

Json change_json(const SubmissionChange& change) {
  Json json = score_json(change.score);
  json["items"] = list_json(change.items, score_json);
  json["causes"] = list_json(change.causes, [](ChangeCause cause) { return name(cause); });
  json["rubric_items"] = change.rubric_items;
  return json;
}

Json changes_json(const ClassChanges& changes) {
  return {{"against", changes.against},
          {"compared", changes.compared},
          {"new", changes.new_ones},
          {"changed", list_json(changes.changed, change_json)}};
}

}  // namespace

std::string class_json(const ClassGrade& graded) {
  Json json = json_header("grade");
  json["rubric"] = graded.rubric.title;
  json["interrupted"] = graded.interrupted;
  json["reused"] = graded.reused;
  json["not_graded"] = graded.not_graded;
  json["submissions"] = list_json(graded.submissions, record_json);
  json["changes"] = or_null(graded.changes, changes_json);
  return json_text(json);
}

}  // namespace raycheck::tools
