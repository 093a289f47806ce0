#include "tools/grade/judging/item_trial.h"

#include <algorithm>
#include <string>
#include <utility>

#include "properties/cases/random.h"
#include "properties/cases/scene_cases.h"
#include "properties/cases/varied_scene.h"
#include "properties/laws/law.h"
#include "properties/search/stress.h"
#include "properties/trial.h"
#include "tools/external/pictures/sphere_colours.h"
#include "tools/implementations/built_in.h"

namespace raycheck::tools {

ItemCases::ItemCases(const ItemTask& task, bool pictures, std::uint64_t seed,
                     const properties::DeclaredConventions& declared,
                     properties::InputFormat format)
    : task_(task), pictures_(pictures), declared_(declared), format_(format) {
  properties::Random random(seed);
  properties::Random of_scenes(random.bits());
  for (std::size_t k = 0; k < task.scenes.size(); ++k) scene_seeds_.push_back(of_scenes.bits());
  for (int k = 0; k < task.cases; ++k) seeds_.push_back(random.bits());
}

std::optional<ItemCase> ItemCases::operator[](std::size_t k) const {
  const std::size_t scenes = task_.scenes.size();
  std::optional<ItemCase> found = k < scenes ? of_scene(k) : of_source(k - scenes);
  const auto round = [&]() -> bool {
    auto rounded = properties::rounded_case(std::move(found->the_case), format_).the_case;
    if (rounded) found->the_case = *std::move(rounded);
    return rounded.has_value();
  };
  if (!found || !round()) return {};
  if (!task_.given_rays) return found;
  found->the_case.scene.conventions = declared_.over(found->the_case.scene.conventions);
  auto alone = properties::case_of_stage(found->the_case, properties::Stage::kIntersection,
                                         candidate_of(kDefaultMethods));
  if (!alone) return {};
  found->the_case = std::move(*alone);
  if (!round()) return {};
  return found;
}

ItemCase ItemCases::of_scene(std::size_t k) const {
  const RubricScene& scene = task_.scenes[k];
  const std::optional<std::uint64_t> at_most =
      pictures_ ? std::nullopt : std::optional(kMostGradedRays);
  const properties::SceneCases cases(
      pictures_ ? properties::varied_scene(scene.scene, task_.vary, scene_seeds_[k]) : scene.scene,
      at_most);
  return {cases.from(0, cases.rays_judged()), {.scene = scene.name}};
}

/// With default conventions, so that a submission that ignores conventions can be right.
std::optional<ItemCase> ItemCases::of_source(std::size_t k) const {
  const properties::ChosenSource& source = properties::chosen_by(task_.sources, seeds_[k]);
  ItemCase found{source.make(seeds_[k]), {.source = std::string(source.name()), .number = k + 1}};
  found.the_case.scene.conventions = {};
  if (!pictures_) return found;
  const auto& camera = found.the_case.scene.camera;
  if (!camera || camera->width > kMostGradedPixels / camera->height) return {};
  // With more spheres not every renderer's colours identify the spheres.
  auto& spheres = found.the_case.scene.spheres;
  if (spheres.size() > kMostSaturated) spheres.resize(kMostSaturated);
  found.the_case.pixels = properties::all_pixels(*camera);
  return found;
}

namespace {

using properties::Case;
using properties::Law;
using properties::Needs;
using properties::ShownPicture;
using properties::Trial;
using properties::Verdict;
using properties::Wrong;

/// The outcome of a case.
struct CaseOutcome {
  bool answers = false;           ///< The case has something to ask.
  bool is_inexpressible = false;  ///< The candidate's form of input cannot express the case.
  std::uint64_t compared = 0;
  properties::Verdict verdict;  ///< By all laws.
  ItemReason unanswered;        ///< Why some questions were not answered.
  const properties::Law* broken = nullptr;
  std::optional<properties::Discrepancy> discrepancy;
  std::optional<FailureKind> failure;   ///< The candidate's failure, if it breaks the law.
  std::optional<ShownPicture> picture;  ///< Of a renderer.
  bool is_unidentified = false;         ///< Its colours do not identify the spheres.

  bool failed() const { return discrepancy && discrepancy->wrong == Wrong::kFailed; }
  bool timed_out() const { return failure == FailureKind::kTimeUp; }
  bool is_answered() const { return unanswered.kind == ItemReason::Kind::kNone; }
  bool holds() const { return broken == nullptr && is_answered(); }
};

/// Whether the candidate misses hits or returns the other root without an excuse, so that laws
/// about hits have less to compare.
bool misses_hits(Trial& trial) {
  for (const Law& law : properties::laws()) {
    if (!judges_decisions(law) || !needs_any(law.needs, Needs::kIntersect)) continue;
    if (!what_is_missing(law.needs, trial).empty()) continue;
    for (const properties::DefectKind& defect : apply(law, trial).defects()) {
      if (defect.wrong == Wrong::kMissed || defect.wrong == Wrong::kWrongRoot) return true;
    }
  }
  return false;
}

bool has_hits(Trial& trial) {
  for (std::size_t sphere = 0; sphere < trial.scene().spheres.size(); ++sphere) {
    for (const properties::Meeting& meeting : trial.exact_meetings(sphere)) {
      const bool is_judged =
          !properties::is_unjudged(meeting.intersection, trial.conventions().tangent);
      if (is_judged && trial.exact_hit(meeting.ray, sphere)) return true;
    }
  }
  return false;
}

/// The first function that a law needs and the candidate lacks, "frame()"; empty if there is none.
std::string missing_function(const Law& law, const Trial& trial) {
  const Candidate& candidate = trial.candidate();
  const bool from_pixel = trial.conventions().origin == scene::Origin::kPixel;
  const auto lacks = [&](Needs need, const auto& function) {
    return needs_any(law.needs, need) && !function;
  };
  if (lacks(Needs::kFrame, candidate.frame)) return "frame()";
  if (lacks(Needs::kPixelPoints, candidate.pixel_points)) return "pixel_point()";
  if (lacks(Needs::kBothOrigins, candidate.pixel_rays)) return "pixel_ray()";
  if (lacks(Needs::kBothOrigins, candidate.focal_rays)) return "focal_ray()";
  if (trial.scene().camera && needs_any(law.needs, Needs::kRays | Needs::kMadeRays) &&
      !trial.has_rays()) {
    return from_pixel ? "pixel_ray()" : "focal_ray()";
  }
  if (lacks(Needs::kIntersect, candidate.intersect)) return "intersect()";
  if (lacks(Needs::kNearest, candidate.nearest)) return "nearest()";
  return {};
}

/// Why the candidate's answers give a law less to compare than the scene offers, if they do.
ItemReason why_unanswered(const Law& law, Trial& trial) {
  if (law.per == properties::Per::kImage || !scene_suits(law.needs, trial)) return {};
  ItemReason reason = {.kind = ItemReason::Kind::kUnanswered,
                       .law = std::string(law.name),
                       .said = std::string(what_is_missing(law.needs, trial)),
                       .function = missing_function(law, trial)};
  const bool lacks_functions = !reason.said.empty();
  // The law "class" also compares misses; laws without a stage compare hits if there are any.
  const bool is_of_class = judges_decisions(law) && law.quantity == properties::Quantity::kClass;
  const bool compares_hits =
      needs_any(law.needs, Needs::kIntersect) || (needs_any(law.needs, Needs::kRays) && !law.stage);
  if (is_of_class || !compares_hits) return lacks_functions ? reason : ItemReason{};
  if (!has_hits(trial) || !(lacks_functions || misses_hits(trial))) return {};
  if (!lacks_functions) {
    reason.said =
        law.quantity == properties::Quantity::kRoot
            ? "some hits are missed; only the roots of the others were compared"
            : "some hits are missed or have the wrong root; only the others were compared";
  }
  return reason;
}

/// Tries the laws on a case.
CaseOutcome try_case(const std::vector<const Law*>& laws, const Case& the_case,
                     const GradedCandidate& graded) {
  Trial trial(the_case, graded.candidate, graded.options());
  CaseOutcome outcome;
  if (graded.last_failure) graded.last_failure->reset();
  for (const Law* law : laws) {
    Verdict verdict = apply(*law, trial);
    // In pictures every pixel is compared.
    ItemReason unanswered;
    if (!graded.pictures && verdict.holds()) unanswered = why_unanswered(*law, trial);
    const bool is_unanswered = unanswered.kind != ItemReason::Kind::kNone;
    outcome.compared += verdict.compared();
    outcome.answers = outcome.answers || verdict.compared() > 0 || is_unanswered;
    // A renderer with its own colours does not identify the spheres.
    const bool is_unidentified =
        graded.pictures && !graded.masks_only && the_case.scene.spheres.size() > 1;
    if (!verdict.holds()) {
      if (outcome.broken != nullptr) continue;
      outcome.broken = law;
      outcome.discrepancy = verdict.worst(1).front();
      if (outcome.discrepancy->wrong == properties::Wrong::kFailed && graded.last_failure) {
        outcome.failure = *graded.last_failure;
      }
    } else if (is_unidentified && !verdict.reason_left_out().empty()) {
      outcome.unanswered = {.kind = ItemReason::Kind::kOtherColours};
    } else if (is_unanswered && outcome.is_answered()) {
      outcome.unanswered = std::move(unanswered);
    }
    outcome.verdict.merge(std::move(verdict));
  }
  outcome.is_inexpressible =
      graded.last_failure && *graded.last_failure == FailureKind::kCannotExpress;
  return outcome;
}

/// The most failing cases kept of an item of functions, to find the mistake behind them.
constexpr std::size_t kKeptCases = 8;

/// After this many cases of an item on which a program fails entirely, or does not end in time, the
/// others are skipped.
constexpr int kMostFailures = 8;
constexpr int kMostTimedOut = 3;

/// A quantity whose answers are all excused and never right: they earn nothing.
std::optional<properties::Quantity> never_right(const Verdict& verdict) {
  for (const auto& [quantity, tally] : verdict.tallies()) {
    properties::Answered all;
    for (const properties::Answered& answers : tally.answered) {
      all.asked += answers.asked;
      all.right += answers.right;
    }
    if (all.asked > 0 && all.right == 0) return quantity;
  }
  return std::nullopt;
}

/// Whether the candidate finds none of the hits, for example because it always answers "miss".
bool never_hits(const Verdict& verdict) {
  const auto& hits = verdict.tally(properties::Quantity::kClass)
                         .answered[static_cast<std::size_t>(properties::Expected::kHit)];
  return hits.asked > 0 && hits.right == 0;
}

/// Whether most pixels that show a sphere identify it.
bool tells_spheres(const ShownPicture& picture) {
  const auto shows = [](const auto& pixel) { return pixel.has_value(); };
  return 2 * std::ranges::count(picture.image, std::optional(properties::kSomeSphere)) <=
         std::ranges::count_if(picture.image, shows);
}

/// Tries the laws on a case; of a renderer, also gets its picture.
CaseOutcome ask(const std::vector<const Law*>& laws, const Case& the_case,
                const GradedCandidate& graded) {
  CaseOutcome outcome = try_case(laws, the_case, graded);
  if (!graded.pictures || !outcome.answers) return outcome;
  // The picture was just drawn and is reused; a time-out is not repeated.
  if (!outcome.timed_out()) {
    outcome.picture = properties::shown_picture(the_case.scene, graded.unmasked);
  }
  if (outcome.broken == nullptr && outcome.unanswered.kind == ItemReason::Kind::kOtherColours) {
    outcome.is_unidentified = !tells_spheres(*outcome.picture);
    outcome.unanswered = {};
  }
  return outcome;
}

/// Counts a case, and keeps it if it broke a law.
void count(ItemCase item_case, CaseOutcome outcome, std::size_t most_kept, ItemTrial& trial) {
  ItemGrade& grade = trial.grade;
  ++grade.cases;
  grade.comparisons += outcome.compared;
  if (outcome.holds()) {
    ++grade.held;
    return;
  }
  if (grade.reason.kind == ItemReason::Kind::kNone) grade.reason = outcome.unanswered;
  if (outcome.broken == nullptr || trial.failed.size() >= most_kept) return;
  trial.failed.push_back({std::move(item_case), outcome.broken, *outcome.discrepancy,
                          outcome.failure, std::move(outcome.picture)});
}

/// The outcome of all cases. `is_unidentified`: in some cases the colours do not identify the
/// spheres.
void finish(const Verdict& all, bool is_unidentified, ItemGrade& grade) {
  if (grade.cases == 0 && (is_unidentified || grade.unsaid > 0)) {
    // The item can be neither right nor wrong.
    grade.points = 0;
    grade.state = ItemState::kNotAsked;
    grade.reason.kind =
        is_unidentified ? ItemReason::Kind::kOtherColours : ItemReason::Kind::kCannotBeSaid;
    return;
  }
  if (grade.cases == 0) grade.reason = {.kind = ItemReason::Kind::kNothingToCompare};
  if (const auto quantity = never_right(all); quantity && all.holds()) {
    grade.held = 0;
    grade.reason = {.kind = ItemReason::Kind::kNeverRight,
                    .quantity = std::string(info(*quantity).name)};
  }
  // A bonus is not earned by misses.
  if (grade.bonus && never_hits(all)) grade.held = 0;
  grade.state =
      grade.cases > 0 && grade.held == grade.cases ? ItemState::kHolds : ItemState::kFails;
}

}  // namespace

ItemTrial try_item(const ItemTask& task, const ItemCases& cases, const GradedCandidate& graded,
                   const std::function<ItemReason()>& reason_to_stop, ItemGrade given) {
  ItemTrial trial{std::move(given), {}, {}, {}};
  ItemGrade& grade = trial.grade;
  Verdict all;
  int failures = 0, timed_out = 0;
  bool is_unidentified = false;
  std::size_t k = 0;
  for (; k < cases.size() && failures < kMostFailures && timed_out < kMostTimedOut; ++k) {
    if (ItemReason reason = reason_to_stop(); reason.kind != ItemReason::Kind::kNone) {
      grade.state = ItemState::kNotJudged;
      grade.reason = std::move(reason);
      trial.failed.clear();
      return trial;
    }
    std::optional<ItemCase> item_case = cases[k];
    if (!item_case) continue;
    CaseOutcome outcome = ask(task.laws, item_case->the_case, graded);
    all.merge(std::move(outcome.verdict));
    if (outcome.is_inexpressible) ++grade.unsaid;
    if (outcome.failed()) ++failures;
    if (outcome.timed_out()) ++timed_out;
    if (outcome.picture) trial.pictures.push_back(*outcome.picture);
    if (outcome.is_unidentified) is_unidentified = true;
    if (!outcome.answers || outcome.is_unidentified) continue;
    count(std::move(*item_case), std::move(outcome), graded.pictures ? cases.size() : kKeptCases,
          trial);
  }
  grade.cases += cases.size() - k;
  for (; k < cases.size(); ++k) {
    if (auto next = cases[k]) trial.not_asked.push_back(std::move(next->the_case.scene));
  }
  finish(all, is_unidentified, grade);
  return trial;
}

}  // namespace raycheck::tools
