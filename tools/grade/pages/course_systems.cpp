// The results files of courses' systems.

#include <fmt/core.h>

#include <algorithm>

#include "tools/grade/pages/views.h"
#include "tools/report/json.h"

namespace raycheck::tools {
namespace {

/// write(item k, its grade, k) for each item that was asked.
template <class Write>
Json tests_json(const StudentGrade& grade, const Write& write) {
  Json tests = Json::array();
  for (std::size_t k = 0; k < grade.items.size(); ++k) {
    const ItemGrade& graded = grade.submission.items[k];
    if (graded.state != ItemState::kNotAsked) tests.push_back(write(*grade.items[k], graded, k));
  }
  return tests;
}

}  // namespace

/// https://gradescope-autograders.readthedocs.io/en/latest/specs/
std::string gradescope_results(const StudentGrade& grade) {
  const SubmissionGrade& submission = grade.submission;
  const auto test = [&](const Item& item, const ItemGrade& graded, std::size_t k) -> Json {
    return {{"name",
             item.bonus ? fmt::format("{} (bonus, {} points)", item.name, item.points) : item.name},
            {"number", std::to_string(k + 1)},
            {"score", graded.score},
            {"max_score", item.bonus ? 0 : graded.points},
            {"status", graded.state == ItemState::kHolds ? "passed" : "failed"},
            {"output_format", "text"},
            {"output", item_text(grade, k)},
            {"visibility", kVisibilityNames[static_cast<std::size_t>(item.visibility)]}};
  };
  return json_text({{"score", submission.score},
                    {"visibility", "visible"},
                    {"stdout_visibility", "hidden"},
                    {"output_format", "text"},
                    {"output", submission.refused ? "your submission could not be judged:\n" +
                                                        refusal_text(*submission.refused)
                                                  : grade.title},
                    {"tests", tests_json(grade, test)}});
}

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
  json["tests"] =
      tests_json(grade, [&](const Item& item, const ItemGrade& graded, std::size_t k) -> Json {
        return {{"name", item.name},
                {"description", item.asks},
                {"points", graded.score},
                {"max_points", graded.points},
                {"message", name(graded.state)},
                {"output", item_text(grade, k)}};
      });
  return json_text(json);
}

}  // namespace raycheck::tools
