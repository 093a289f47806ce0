#include <fmt/core.h>

#include <algorithm>
#include <functional>

#include "properties/cases/case_text.h"
#include "properties/laws/law.h"
#include "scene/files/scene_file.h"
#include "tools/external/pictures/renderer.h"
#include "tools/grade/pages/views.h"
#include "tools/grade/results/result.h"
#include "tools/report/words.h"

namespace raycheck::tools {

using properties::Quantity;
using properties::Wrong;

std::string points_text(double points) {
  std::string text = fmt::format("{:.2f}", points);
  while (text.back() == '0') text.pop_back();
  if (text.back() == '.') text.pop_back();
  return text;
}

std::string origin_text(const CaseOrigin& origin) {
  return origin.scene.empty()
             ? fmt::format("random case {} of the source {}", origin.number, origin.source)
             : "the scene " + origin.scene;
}

std::string answer_text(const FailingCase& failing) {
  const properties::Discrepancy& answer = failing.answer;
  const std::string part = plain_text(answer.what);
  if (answer.wrong == Wrong::kFailed || answer.wrong == Wrong::kRefused) return part;
  std::string text(info(answer.quantity).name);
  if (has_place(answer.quantity)) text += ", " + place_text(answer.place);
  if (!part.empty()) text += ", " + part;
  if (answer.wrong != Wrong::kNot) return fmt::format("{}: {}", text, name(answer.wrong));
  if (failing.is_withheld) return text;
  return fmt::format("{}: off by {} {}", text, error_text(answer.error),
                     unit_name(answer.quantity, answer.precision));
}

std::string got_text(const FailingCase& failing) {
  const properties::Discrepancy& answer = failing.answer;
  if (answer.quantity == Quantity::kRefusal) return "";
  // The picture shows a sphere, but its colour does not identify it.
  const bool is_unidentified = answer.quantity == Quantity::kNearestSphere &&
                               answer.wrong == Wrong::kFalseHit && answer.got.empty();
  return is_unidentified ? "a sphere" : answer_text(answer.quantity, answer.symbol, answer.got);
}

std::string exact_text(const FailingCase& failing) {
  const bool has_none = failing.answer.quantity == Quantity::kRefusal || failing.is_withheld;
  return has_none ? "" : exact_text(failing.answer);
}

std::string step_text(const FailingCase& failing) {
  if (!failing.step) return "";
  const bool is_root = *failing.step == info(Quantity::kRoot).name;
  return is_root ? "the root (its choice or its value)" : *failing.step;
}

std::string reason_text(const ItemReason& reason) {
  using Kind = ItemReason::Kind;
  if (reason.item.empty() && reason.kind == Kind::kNeeds) {
    return "another item must have all points first";
  }
  if (reason.item.empty() && reason.kind == Kind::kFollows) {
    return "because of the mistake in another item";
  }
  if (!reason.function.empty()) return reason.function + " is missing: write it";
  const bool is_verb = reason.state == ItemState::kFails;
  return fmt::format(
      fmt::runtime(kReasons[static_cast<std::size_t>(reason.kind)].text),
      fmt::arg("item", reason.item), fmt::arg("seconds", reason.seconds),
      fmt::arg("law", reason.law), fmt::arg("said", reason.said),
      fmt::arg("quantity", reason.quantity),
      fmt::arg("is_state", (is_verb ? "" : "is ") + std::string(name(reason.state))));
}

std::string hint_text(const Item& item, const ItemGrade& grade) {
  if (grade.failing && grade.failing->answer.wrong == Wrong::kFailed) {
    return "Correct this failure first.";
  }
  const std::string& function = grade.reason.function;
  if (function.empty() || grade.failing) return item.hint;
  return fmt::format("Write {}, and add it to the functions that you give to raycheck.", function);
}

std::string mistake_text(const ItemGrade& grade, const ExplainingMistake& mistake) {
  if (mistake.wrong == 0) return mistake.sentence();
  return explained_text(mistake.sentence(), mistake.explained, mistake.wrong,
                        grade.pictures ? "pixels" : "answers");
}

std::string mistake_text(const SubmissionGrade& grade) {
  std::vector<MistakeStatistics> all = mistake_statistics({&grade, 1});
  std::ranges::stable_sort(all, std::greater{}, &MistakeStatistics::items);
  // The most frequent mistake comes first, then every other mistake that costs points.
  std::string text;
  for (const MistakeStatistics& one : all) {
    if (text.empty() || one.costs) text += (text.empty() ? "" : "; and ") + one.sentence;
  }
  return text;
}

std::string state_text(const ItemGrade& grade) {
  if (grade.unsaid > 0 && grade.cases > 0) {
    ItemGrade said = grade;
    said.unsaid = 0;
    return fmt::format("{}; {} cannot be written in the input format of the program",
                       state_text(said), count_text(grade.unsaid, "further case"));
  }
  if (grade.state == ItemState::kHolds) {
    return fmt::format("holds over {}, {}", count_text(grade.cases, "case"),
                       count_text(grade.comparisons, "comparison"));
  }
  const std::string reason = reason_text(grade.reason);
  if (grade.state == ItemState::kFollows) {
    return fmt::format("fails {} of {} only {}, which takes no points here",
                       grade.cases - grade.held, count_text(grade.cases, "case"), reason);
  }
  if (grade.state != ItemState::kFails) return fmt::format("{}: {}", name(grade.state), reason);
  const std::string text =
      fmt::format("fails {} of {}", grade.cases - grade.held, count_text(grade.cases, "case"));
  return reason.empty() ? text : fmt::format("{} ({})", text, reason);
}

std::string score_text(const SubmissionGrade& grade) {
  return could_be_judged(grade) || grade.score > 0 ? points_text(grade.score - grade.bonus) : "-";
}

std::string of_points_text(const SubmissionGrade& grade) {
  return " of " + points_text(grade.points) +
         (grade.bonus > 0 ? ", bonus " + points_text(grade.bonus) : "");
}

std::string of_points_text(const ItemGrade& grade) {
  return " of " + points_text(grade.points) + (grade.bonus ? " (bonus)" : "");
}

std::string not_judged_text(const SubmissionGrade& grade) {
  return "could not be judged: " + grade.refused->why;
}

std::string refusal_text(const Refusal& refused) {
  return refused.said.empty() ? refused.why : refused.why + "\n" + refused.said;
}

std::string unlisted_text(const StudentGrade& grade) {
  if (grade.unlisted == 0) return "";
  return "not shown, but in the score: " + count_text(grade.unlisted, "item");
}

std::string law_text(const FailingCase& failing) {
  return std::string(properties::find_law(failing.answer.law)->sentence);
}

std::string scene_text(const FailingCase& failing) {
  return failing.the_case.pixels.empty() ? scene::write_toml(failing.the_case.scene)
                                         : properties::scene_text(failing.the_case);
}

std::string driver_file_text(const FailingCase& failing, const Preparation& found) {
  const scene::Scene& shown = failing.the_case.scene;
  const ColourHabit colours = found.dry_run ? found.dry_run->colours : ColourHabit{};
  return shown.camera ? driver_text(shown, found.driver(), colours) : "";
}

std::string item_text(const StudentGrade& all, std::size_t k) {
  const Item& item = *all.items[k];
  const ItemGrade& grade = all.submission.items[k];
  std::string text;
  const auto line = [&](const std::string& before, const std::string& words) {
    if (!words.empty()) text += before + words + "\n";
  };
  line("asked: ", item.asks);
  line("why: ", item.why);
  line("", state_text(grade));
  for (const ExplainingMistake& one : grade.mistakes) line("mistake: ", mistake_text(grade, one));
  if (grade.failing) {
    line("the law: ", law_text(*grade.failing));
    line("", answer_text(*grade.failing));
    line("  got   ", got_text(*grade.failing));
    line("  exact ", exact_text(*grade.failing));
    line("", difference_text(*grade.failing));
    line("goes wrong at: ", step_text(*grade.failing));
  }
  if (grade.state == ItemState::kFails) line("hint: ", hint_text(item, grade));
  if (grade.failing) {
    const std::string name = file_name(item.name);
    text +=
        fmt::format("the smallest failing case found, from {}; to repeat it, save it as {}.toml:\n",
                    origin_text(grade.failing->origin), name);
    text += scene_text(*grade.failing);
    const std::string driver = driver_file_text(*grade.failing, all.submission.found);
    if (!driver.empty()) {
      text += fmt::format("the same case as a driver file; save it as {}.txt:\n", name) + driver;
    }
    for (const HomeCommand& one : commands_for_case(all, k)) {
      text += fmt::format("{}: {}\n", one.purpose, one.words);
    }
  }
  return text;
}

std::string isolation_text(const LayersHere& isolation) {
  std::string text = "isolated by: " + isolation.layers.text();
  for (const auto& [name, why] : isolation.missing) {
    text += fmt::format("; not by {}: {}", name, line_text(why));
  }
  if (!isolation.no_control_group.empty()) {
    text += "; no control group: " + line_text(isolation.no_control_group);
  }
  return text;
}

std::string times_text(const ClassGrade& graded) {
  if (!graded.isolation || graded.submissions.empty()) return "";
  double built = 0, judged = 0;
  int stored = 0;
  for (const SubmissionGrade& grade : graded.submissions) {
    built += grade.build_seconds;
    judged += grade.judge_seconds;
    stored += grade.build_is_stored ? 1 : 0;
  }
  return fmt::format("built in {:.1f} s{}, judged in {:.1f} s", built,
                     stored > 0 ? fmt::format(", {} from the store", stored) : "", judged);
}

std::string line_text(const std::string& name) {
  std::string text = plain_text(name);
  std::ranges::replace_if(
      text, [](char c) { return c == '\n' || c == '\t'; }, '?');
  return text;
}

namespace {

/// The dry run's remarks, one per line.
std::string notes_text(const SubmissionGrade& grade) {
  std::string text;
  for (const std::string& note : grade.notes) text += "  " + line_text(note) + "\n";
  return text;
}

}  // namespace

std::string submission_text(const SubmissionGrade& grade) {
  if (!could_be_judged(grade)) {
    const std::string score =
        grade.score > 0 ? score_text(grade) + of_points_text(grade) + ", " : "";
    return fmt::format("{}: {}could not be judged: {}\n{}", line_text(grade.name), score,
                       refusal_text(*grade.refused), notes_text(grade));
  }
  std::string text =
      line_text(grade.name) + ": " + score_text(grade) + of_points_text(grade) + "\n";
  const std::string mistake = mistake_text(grade);
  if (!mistake.empty()) text += "  " + mistake + "\n";
  std::size_t width = 0;
  for (const ItemGrade& item : grade.items) width = std::max(width, item.name.size());
  for (const ItemGrade& item : grade.items) {
    const bool is_asked = item.state != ItemState::kNotAsked;
    text += fmt::format("  {:<{}}  {:>5}{}  {}\n", item.name, width,
                        is_asked ? points_text(item.score) : "-",
                        is_asked ? of_points_text(item) : "", state_text(item));
  }
  return text + notes_text(grade);
}

}  // namespace raycheck::tools
