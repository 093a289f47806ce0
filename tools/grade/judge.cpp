#include "tools/grade/judge.h"

#include <fmt/core.h>

#include <algorithm>
#include <memory>
#include <stdexcept>
#include <utility>

#include "properties/answer_explanation.h"
#include "properties/campaign.h"
#include "properties/image_explanation.h"
#include "properties/random.h"
#include "properties/shrink.h"
#include "properties/stress.h"
#include "scene/number.h"
#include "tools/candidates/process.h"
#include "tools/candidates/renderer.h"
#include "tools/format.h"
#include "tools/grade/submission.h"
#include "tools/methods.h"
#include "tools/scene_cases.h"
#include "tools/terminal.h"

namespace raycheck::tools {
namespace {

using properties::Candidate;
using properties::Case;
using properties::Discrepancy;
using properties::Law;
using properties::Trial;
using properties::TrialOptions;
using properties::Truth;
using properties::Verdict;
using properties::Wrong;

/// Simpler cases tried in place of a failing one: of functions, of programs that fail altogether,
/// and of pictures, for each of which a program is started.
constexpr int kTries = 400;
constexpr int kTriesOfFailures = 40;
constexpr int kTriesOfPictures = 60;

/// So many failing cases of an item are kept to find the mistake that explains them.
constexpr std::size_t kKeptCases = 8;

/// The steps from a scene to what is seen, and the laws by which each is judged, in order.
constexpr std::pair<std::string_view, std::string_view> kSteps[] = {
    {"frame", "frame"},
    {"pixel-point", "pixel point"},
    {"unit-direction", "direction"},
    {"direction", "direction"},
    {"ray-origin", "ray origin"},
    {"class", "discriminant"},
    {"nearest-root", "root"},
    {"parameter", "root"},
    {"hit-point", "hit point"},
    {"nearest-sphere", "nearest sphere"}};

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

/// A case, and where it comes from.
struct Asked {
  Case the_case;
  std::string origin;
};

/// The cases of an item, by their numbers.
class Cases {
 public:
  Cases(const Questions& questions, bool pictures, std::uint64_t seed,
        const properties::DeclaredConventions& declared)
      : questions_(questions), pictures_(pictures), declared_(declared) {
    properties::Random random(seed);
    for (int k = 0; k < questions.cases; ++k) seeds_.push_back(random.bits());
  }

  std::size_t size() const { return questions_.scenes.size() + seeds_.size(); }

  /// Empty where there is nothing to ask.
  std::optional<Asked> operator[](std::size_t k) const {
    std::optional<Asked> asked = k < questions_.scenes.size()
                                     ? of_scene(questions_.scenes[k])
                                     : of_source(k - questions_.scenes.size());
    if (!asked || !questions_.given_rays) return asked;
    asked->the_case.scene.conventions = declared_.over(asked->the_case.scene.conventions);
    auto alone = properties::alone(asked->the_case, properties::Stage::kIntersection,
                                   candidate_of(kDefaultMethods));
    if (!alone) return {};
    asked->the_case = std::move(*alone);
    return asked;
  }

 private:
  std::optional<Asked> of_scene(const RubricScene& scene) const {
    const std::optional<std::uint64_t> at_most =
        pictures_ ? std::nullopt : std::optional(kMostGradedRays);
    const SceneCases cases(scene.scene, at_most);
    return Asked{cases.from(0, cases.rays_judged()), "scene " + scene.name};
  }

  /// A submission that heeds no conventions is right under the default ones.
  std::optional<Asked> of_source(std::size_t k) const {
    const properties::ChosenSource& source = questions_.sources[k % questions_.sources.size()];
    Asked asked{source.make(seeds_[k]), fmt::format("{}, random case {}", source.name(), k + 1)};
    asked.the_case.scene.conventions = {};
    if (!pictures_) return asked;
    const auto& camera = asked.the_case.scene.camera;
    if (!camera || camera->width > kMostGradedPixels / camera->height) return {};
    asked.the_case.pixels = properties::all_pixels(*camera);
    return asked;
  }

  const Questions& questions_;
  bool pictures_;
  const properties::DeclaredConventions& declared_;
  std::vector<std::uint64_t> seeds_;
};

TrialOptions options_of(const Tolerance& tolerance, std::shared_ptr<Truth> truth = nullptr) {
  return {.max_error = tolerance.ulp, .truth = std::move(truth)};
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

Shown show(const Questions& questions, const Item& item, const Case& the_case,
           const Candidate& candidate, bool pictures) {
  Candidate own = candidate_of(kDefaultMethods);
  own.declared = candidate.declared;
  const auto truth =
      std::make_shared<Truth>(the_case, candidate.declared.over(the_case.scene.conventions));
  Trial trial(the_case, candidate, options_of(item.tolerance, truth));
  Trial own_trial(the_case, own, options_of(item.tolerance, truth));
  Shown shown;
  for (const Law* law : questions.laws) {
    const Verdict verdict = apply(*law, trial);
    const std::uint64_t expected = pictures ? 0 : apply(*law, own_trial).compared();
    shown.compared += verdict.compared();
    shown.answers = shown.answers || verdict.compared() > 0 || expected > 0;
    if (!verdict.holds() && shown.broken == nullptr) {
      shown.broken = law;
      shown.discrepancy = verdict.worst(1).front();
    } else if (verdict.compared() < expected && shown.unanswered.empty()) {
      const std::string& reason = verdict.reason_left_out();
      shown.unanswered = reason.empty() ? fmt::format("{}: answers are missing", law->name)
                                        : fmt::format("{}: {}", law->name, reason);
    }
  }
  return shown;
}

/// Whether a camera still looks the way in which another does, its bounds in the same order: what
/// programs may rely on.
bool is_alike(const scene::Scene& now, const scene::Scene& before) {
  if (!before.camera) return true;
  const auto& [a, b] = std::pair(*now.camera, *before.camera);
  return (a.near < 0) == (b.near < 0) && (a.left < a.right) == (b.left < b.right) &&
         (a.bottom < a.top) == (b.bottom < b.top);
}

/// A failing case that is simpler and fails in the same way.
Case simplest(const Case& from, const Shown& shown, const Candidate& candidate,
              const Tolerance& tolerance, bool pictures, const std::function<bool()>& is_late) {
  const Discrepancy& first = *shown.discrepancy;
  const bool failed = first.wrong == Wrong::kFailed;
  if (failed && first.what.find(kSilent) != std::string::npos) return from;
  const int tries = failed ? kTriesOfFailures : pictures ? kTriesOfPictures : kTries;
  // A picture is judged in every pixel.
  const auto whole = [pictures](Case the_case) {
    if (pictures) the_case.pixels = properties::all_pixels(*the_case.scene.camera);
    return the_case;
  };
  Case start = from;
  if (pictures) start.pixels.clear();
  return whole(properties::smallest(std::move(start), tries, [&](const Case& next) {
    if (is_late() || !is_alike(next.scene, from.scene)) return false;
    const Case judged = whole(next);
    Trial trial(judged, candidate, options_of(tolerance));
    const Verdict verdict = apply(*shown.broken, trial);
    if (verdict.holds()) return false;
    const Discrepancy now = verdict.worst(1).front();
    return now.wrong == first.wrong && now.quantity == first.quantity;
  }));
}

std::string step_of(const Case& the_case, const Candidate& candidate, const Tolerance& tolerance) {
  Trial trial(the_case, candidate, options_of(tolerance));
  for (const auto& [law, step] : kSteps) {
    if (!apply(*properties::find_law(law), trial).holds()) return std::string(step);
  }
  return "";
}

std::string head(const Discrepancy& d) {
  if (d.wrong == Wrong::kFailed || d.wrong == Wrong::kRefused) return d.what;
  std::string text(info(d.quantity).name);
  if (has_place(d.quantity)) text += ", " + place_text(d.place);
  if (!d.what.empty()) text += ", " + d.what;
  return text + ": " +
         (d.wrong != Wrong::kNot
              ? std::string(name(d.wrong))
              : fmt::format("off by {} {}", error_text(d.error), info(d.quantity).unit));
}

FailingCase failing_case(const Case& the_case, const std::string& origin, const Law& law,
                         const Candidate& candidate, const Item& item, bool pictures,
                         scene::Dialect dialect) {
  FailingCase failing;
  failing.law = law.sentence;
  failing.origin = origin;
  Trial trial(the_case, candidate, options_of(item.tolerance));
  const Verdict verdict = apply(law, trial);
  if (verdict.holds()) return failing;
  const Discrepancy d = verdict.worst(1).front();
  failing.what = plain_text(head(d));
  if (d.quantity != properties::Quantity::kRefusal) {
    failing.actual = numbers_text(d.got);
    failing.expected = numbers_text(d.exact);
  }
  Case told = the_case;
  told.scene.conventions = trial.conventions();
  failing.scene = properties::text(told);
  if (told.scene.camera) failing.driver = driver_text(told.scene, dialect);
  if (!pictures && d.wrong != Wrong::kFailed) {
    failing.step = step_of(the_case, candidate, item.tolerance);
  }
  return failing;
}

std::vector<std::string> sentences(const std::vector<Case>& cases, const Candidate& candidate,
                                   bool pictures) {
  std::vector<std::string> result;
  std::vector<properties::Explanation> found;
  try {
    if (!pictures) found = properties::explanations(cases, candidate);
    for (std::size_t k = 0; pictures && found.empty() && k < cases.size(); ++k) {
      const auto& scene = cases[k].scene;
      const auto conventions = candidate.declared.over(scene.conventions);
      found = properties::explanations(scene, conventions, candidate.image(scene, conventions));
    }
  } catch (const std::runtime_error&) {
    return {};  // it fails, as the verdict says
  }
  for (const properties::Explanation& one : found) {
    result.push_back(fmt::format("{}: {} of {} wrong {} are right that way", one.sentence,
                                 one.explained, one.errors, pictures ? "pixels" : "answers"));
  }
  return result;
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

Judge::Judge(const Rubric& rubric, Candidate candidate, bool is_renderer, std::uint64_t seed)
    : rubric_(rubric),
      candidate_(std::move(candidate)),
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
    if (found->state == kHolds || found->state == kNotAsked) continue;
    grade.state = kLeftOut;
    grade.reason = fmt::format("it needs '{}', which {}", needed,
                               found->state == kFails ? "fails" : "is " + found->state);
    return grade;
  }
  const auto is_late = [this] { return Clock::now() > end_ || interrupted(); };
  Candidate candidate = tolerated(candidate_, item.tolerance);
  if (questions->masks_only) candidate = masked(std::move(candidate));
  properties::Random seeds(seed_ + index);
  const Cases cases(*questions, is_renderer_, seeds.bits(), candidate.declared);
  std::vector<Case> wrong;
  std::optional<std::pair<Asked, Shown>> first;
  for (std::size_t k = 0; k < cases.size(); ++k) {
    if (is_late()) {
      grade.state = kNotJudged;
      grade.reason = interrupted() ? "interrupted"
                                   : fmt::format(
                                         "time is up: a submission has {} s for all that "
                                         "it is asked",
                                         rubric_.seconds);
      return grade;
    }
    std::optional<Asked> asked = cases[k];
    if (!asked) continue;
    Shown shown = show(*questions, item, asked->the_case, candidate, is_renderer_);
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
    if (!first) first.emplace(std::move(*asked), std::move(shown));
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
  // Which sphere is shown tells more about a mistake than whether there is one.
  grade.sentences = sentences(
      wrong, is_renderer_ ? tolerated(candidate_, item.tolerance) : candidate, is_renderer_);
  const Case smallest =
      simplest(asked.the_case, shown, candidate, item.tolerance, is_renderer_, is_late);
  grade.failing.push_back(failing_case(smallest, asked.origin, *shown.broken, candidate, item,
                                       is_renderer_, rubric_.dialect));
  if (grade.failing.back().what.empty()) grade.failing.clear();
  return grade;
}

}  // namespace raycheck::tools
