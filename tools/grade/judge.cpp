#include "tools/grade/judge.h"

#include <fmt/core.h>

#include <algorithm>
#include <memory>
#include <utility>

#include "properties/cases/random.h"
#include "tools/grade/failure.h"
#include "tools/grade/item_cases.h"
#include "tools/grade/submission.h"
#include "tools/methods/methods.h"
#include "tools/report/words.h"

namespace raycheck::tools {
namespace {

using properties::Candidate;
using properties::Case;
using properties::Discrepancy;
using properties::Law;
using properties::Trial;
using properties::Truth;
using properties::Verdict;

/// So many failing cases of an item are kept to find the mistake that explains them.
constexpr std::size_t kKeptCases = 8;

/// After so many cases of an item on which a program fails altogether, the others are not asked.
constexpr int kMostFailures = 8;

/// The rubric's conventions in place of the candidate's.
properties::DeclaredConventions over(const properties::DeclaredConventions& rubric,
                                     properties::DeclaredConventions declared) {
  const auto set = [](auto& own, const auto& given) {
    if (given) own = given;
  };
  set(declared.rows, rubric.rows);
  set(declared.samples, rubric.samples);
  set(declared.origin, rubric.origin);
  set(declared.root, rubric.root);
  set(declared.tangent, rubric.tangent);
  return declared;
}

/// The candidate held to what an item tolerates.
Candidate tolerated(Candidate candidate, const Tolerance& tolerance) {
  if (tolerance.conditioning) {
    candidate.max_error.fill(properties::kModerateCondition * *tolerance.conditioning);
    candidate.max_error_end_to_end.fill({});
    candidate.unit_roundoff = properties::kDoubleRoundoff * *tolerance.conditioning;
  } else if (tolerance.ulp) {
    candidate.unit_roundoff = properties::kDoubleRoundoff * *tolerance.ulp *
                              (properties::kDoubleRoundoff / properties::kExcusedChange);
  }
  return candidate;
}

/// The candidate of whose pictures only the mask counts.
Candidate masked(Candidate candidate) {
  candidate.image = [image = candidate.image](const scene::Scene& scene,
                                              const scene::Conventions& conventions) {
    properties::ImageAnswer answer = image(scene, conventions);
    for (auto& sphere : answer) {
      if (sphere) sphere = properties::kSomeSphere;
    }
    return answer;
  };
  return candidate;
}

/// What a case shows of a candidate.
struct Shown {
  bool answers = false;  ///< There was something to ask.
  std::uint64_t compared = 0;
  std::string unanswered;  ///< Why less was answered than asked.
  const Law* broken = nullptr;
  std::optional<Discrepancy> discrepancy;
  bool holds() const { return broken == nullptr && unanswered.empty(); }
};

/// Whether an answer may be missing: decisions about the case are excused, and where one goes the
/// other way there is a hit less to compare.
bool may_miss_answers(Trial& trial) {
  for (const Law& law : properties::laws()) {
    if (!judges_decisions(law) || law.per == properties::Per::kImage) continue;
    if (apply(law, trial).excused() > 0) return true;
  }
  return false;
}

Shown show(const std::vector<const Law*>& laws, const Case& the_case, const Asking& asking) {
  Candidate own = candidate_of(kDefaultMethods);
  own.declared = asking.candidate.declared;
  const auto truth =
      std::make_shared<Truth>(the_case, own.declared.over(the_case.scene.conventions));
  Trial trial(the_case, asking.candidate, asking.options(truth));
  Trial own_trial(the_case, own, asking.options(truth));
  Shown shown;
  for (const Law* law : laws) {
    const Verdict verdict = apply(*law, trial);
    // raycheck's own methods draw no pictures, of which every pixel is compared.
    const std::uint64_t expected = asking.pictures ? 0 : apply(*law, own_trial).compared();
    shown.compared += verdict.compared();
    shown.answers = shown.answers || verdict.compared() > 0 || expected > 0;
    // Who shows colours of its own does not tell which sphere it sees.
    const bool is_untold =
        asking.pictures && !asking.masks_only && the_case.scene.spheres.size() > 1;
    if (!verdict.holds()) {
      if (shown.broken != nullptr) continue;
      shown.broken = law;
      shown.discrepancy = verdict.worst(1).front();
    } else if (is_untold && !verdict.reason_left_out().empty()) {
      shown.unanswered = "its colours are not those of the driver file";
    } else if (verdict.compared() < expected && shown.unanswered.empty() &&
               !may_miss_answers(trial)) {
      const std::string& reason = verdict.reason_left_out();
      shown.unanswered =
          fmt::format("{}: {}", law->name, reason.empty() ? "answers are missing" : reason);
    }
  }
  return shown;
}

}  // namespace

double score_of(const Item& item, std::uint64_t held, std::uint64_t cases) {
  if (cases == 0) return 0;
  const double share = static_cast<double>(held) / static_cast<double>(cases);
  if (item.credit == Credit::kAll) return held == cases ? item.points : 0;
  if (item.credit == Credit::kShare) return share * item.points;
  double credit = 0;
  for (const CreditStep& step : item.steps) {
    if (share >= step.share) credit = std::max(credit, step.credit);
  }
  return credit * item.points;
}

Judge::Judge(const Rubric& rubric, Candidate candidate, bool is_renderer, std::uint64_t seed,
             const properties::RunControl& control)
    : rubric_(rubric),
      candidate_(std::move(candidate)),
      control_(control),
      is_renderer_(is_renderer),
      seed_(seed),
      end_(Clock::now() + std::chrono::duration_cast<Clock::duration>(
                              std::chrono::duration<double>(rubric.seconds))) {
  candidate_.declared = over(rubric.conventions, candidate_.declared);
}

ItemGrade Judge::item(std::size_t index, const std::vector<ItemGrade>& before) {
  const Item& item = rubric_.items[index];
  ItemGrade grade;
  grade.name = item.name;
  grade.bonus = item.bonus;
  const auto& questions = is_renderer_ ? item.pictures : item.functions;
  if (!questions) {
    grade.state = kNotAsked;
    grade.reason = is_renderer_ ? "a picture does not show it" : "it is asked of renderers only";
    return grade;
  }
  grade.points = item.points;
  for (const std::string& needed : item.needs) {
    const auto found = std::find_if(before.begin(), before.end(),
                                    [&](const ItemGrade& other) { return other.name == needed; });
    if (found->state == kNotAsked || found->score >= found->points) continue;
    grade.state = kLeftOut;
    grade.reason = fmt::format("it needs '{}', which {}", needed,
                               found->state == kFails ? "fails" : "is " + found->state);
    return grade;
  }
  const auto is_late = [this] { return Clock::now() > end_ || control_.interrupted(); };
  // Which sphere is shown tells more about a mistake than whether there is one.
  Candidate telling = tolerated(candidate_, item.tolerance);
  telling.excused_image_change = questions->image_change.value_or(telling.excused_image_change);
  const Candidate candidate = questions->masks_only ? masked(telling) : telling;
  const Asking asking{candidate, item.tolerance, is_renderer_, questions->masks_only,
                      rubric_.dialect};
  properties::Random seeds(seed_);
  for (std::size_t k = 0; k < index; ++k) seeds.bits();
  const ItemCases cases(*questions, is_renderer_, seeds.bits(), candidate.declared);
  std::vector<Case> wrong;
  int failures = 0;
  std::optional<std::pair<Asked, Shown>> first;
  for (std::size_t k = 0; k < cases.size(); ++k) {
    if (is_late()) {
      grade.state = kNotJudged;
      grade.reason = control_.interrupted() ? "interrupted"
                                            : fmt::format(
                                                  "time is up: a submission has {} s for all that "
                                                  "it is asked",
                                                  rubric_.seconds);
      return grade;
    }
    std::optional<Asked> asked = cases[k];
    if (!asked) continue;
    Shown shown = show(questions->laws, asked->the_case, asking);
    if (!shown.answers) continue;
    ++grade.cases;
    grade.comparisons += shown.compared;
    if (shown.holds()) {
      ++grade.held;
      continue;
    }
    if (!shown.unanswered.empty() && grade.reason.empty()) grade.reason = shown.unanswered;
    if (shown.broken == nullptr) continue;
    if (wrong.size() < kKeptCases) wrong.push_back(asked->the_case);
    const bool failed = shown.discrepancy->wrong == properties::Wrong::kFailed;
    if (!first) first.emplace(std::move(*asked), std::move(shown));
    if (failed && ++failures == kMostFailures) {
      grade.cases += cases.size() - k - 1;
      break;
    }
  }
  if (grade.cases == 0) grade.reason = "there was nothing to compare";
  grade.score = score_of(item, grade.held, grade.cases);
  grade.state = grade.cases > 0 && grade.held == grade.cases ? kHolds : kFails;
  if (!first) return grade;
  const auto& [asked, shown] = *first;
  grade.first_wrong = plain_text(asked.origin + ": " + head(*shown.discrepancy));
  if (!shown.discrepancy->got.empty()) {
    grade.first_wrong += ", " + numbers_text(shown.discrepancy->got);
  }
  grade.sentences = mistake_sentences(wrong, telling, is_renderer_);
  const Case smallest =
      simplest(asked.the_case, *shown.broken, *shown.discrepancy, asking, is_late);
  if (auto failing =
          failing_case(smallest, asked.origin, *shown.broken, *shown.discrepancy, asking)) {
    grade.failing.push_back(std::move(*failing));
  }
  return grade;
}

}  // namespace raycheck::tools
