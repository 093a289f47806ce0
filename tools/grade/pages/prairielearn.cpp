#include <algorithm>

#include "tools/grade/pages/views.h"
#include "tools/report/json.h"

namespace raycheck::tools {

/// https://prairielearn.readthedocs.io/en/latest/externalGrading/ : hidden items count, but are not
/// listed.
std::string prairielearn_results(const StudentGrade& grade) {
  const SubmissionGrade& submission = grade.submission;
  const std::string refused = submission.refused ? refusal_text(*submission.refused) : "";
  Json json;
  // A submission that cannot run does not use up an attempt, unless the rubric gives it points,
  // which would be lost.
  json["gradable"] = !submission.refused || submission.score > 0;
  if (!json["gradable"]) json["format_errors"] = Json::array({refused});
  json["score"] = submission.points > 0 ? std::min(submission.score / submission.points, 1.0) : 0.0;
  json["message"] = grade.title + ": " +
                    (could_be_judged(submission) ? "" : "could not be judged, ") +
                    score_text(submission) + of_points_text(submission) + " points";
  json["output"] = refused;
  json["tests"] = Json::array();
  for (std::size_t k = 0; k < grade.items.size(); ++k) {
    const Item& item = *grade.items[k];
    const ItemGrade& graded = submission.items[k];
    if (graded.state == ItemState::kNotAsked) continue;
    json["tests"].push_back({{"name", item.name},
                             {"description", item.asks},
                             {"points", graded.score},
                             {"max_points", graded.points},
                             {"message", name(graded.state)},
                             {"output", item_text(grade, k)}});
  }
  return json_text(json);
}

}  // namespace raycheck::tools
