#include "tools/grade/results/changes.h"

#include <algorithm>
#include <exception>
#include <fstream>
#include <map>

#include "tools/grade/results/record.h"

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
    if (json.contains("inputs")) grade.inputs = inputs_of_record(json.at("inputs"));
    return grade;
  } catch (const std::exception&) {
    return {};  // no record, then
  }
}

namespace {

/// The items whose digests differ, and those on one side only.
std::vector<std::string> changed_items(const GradeInputs& before, const GradeInputs& now) {
  std::vector<std::string> names;
  for (const auto& [item, digest] : now.items) {
    const auto found = before.items.find(item);
    if (found == before.items.end() || found->second != digest) names.push_back(item);
  }
  for (const auto& [item, digest] : before.items) {
    if (!now.items.contains(item)) names.push_back(item);
  }
  return names;
}

std::vector<ScoreChange> changed_points(const EarlierGrade& earlier, const SubmissionGrade& now) {
  std::vector<ScoreChange> changes;
  const auto named = [](const std::string& name) {
    return [&name](const ScoreChange& change) { return change.name == name; };
  };
  for (const auto& [item, score] : earlier.items) changes.push_back({item, score, {}});
  for (const ItemGrade& item : now.items) {
    const auto found = std::find_if(changes.begin(), changes.end(), named(item.name));
    if (found == changes.end()) {
      changes.push_back({item.name, {}, item.score});
    } else {
      found->now = item.score;
    }
  }
  std::erase_if(changes, [](const ScoreChange& change) { return change.before == change.now; });
  return changes;
}

}  // namespace

std::optional<SubmissionChange> change_of(const EarlierGrade& earlier, const SubmissionGrade& now) {
  SubmissionChange change;
  change.score = {now.name, earlier.score,
                  could_be_judged(now) ? std::optional(now.score) : std::nullopt};
  const bool both_judged = change.score.before && change.score.now;
  if (both_judged) change.items = changed_points(earlier, now);
  if (change.score.before == change.score.now && change.items.empty()) return {};
  const auto differs = [&](ChangeCause cause, bool does) {
    if (does) change.causes.push_back(cause);
  };
  if (earlier.inputs) {
    const GradeInputs& before = *earlier.inputs;
    change.rubric_items = changed_items(before, now.inputs);
    differs(ChangeCause::kSubmission, before.submission != now.inputs.submission);
    differs(ChangeCause::kItems, !change.rubric_items.empty());
    differs(ChangeCause::kRubric, before.rubric != now.inputs.rubric);
  }
  differs(ChangeCause::kSeed, earlier.seed != now.seed);
  differs(ChangeCause::kRaycheck,
          !earlier.inputs || earlier.inputs->raycheck != now.inputs.raycheck);
  differs(ChangeCause::kIsolation, earlier.isolation != now.isolation.text());
  return change;
}

}  // namespace raycheck::tools
