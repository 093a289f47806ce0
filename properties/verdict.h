#pragma once

#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "properties/failures.h"
#include "properties/quantile_sketch.h"
#include "properties/quantity.h"
#include "reference/account/nearby_answer.h"
#include "scene/camera.h"
#include "scene/scene.h"

namespace raycheck::properties {

/// The verdict on an answer that differs from the truth. Only a defect counts against the
/// candidate; of the others, only an excused answer counts as right.
enum class Standing {
  kDefect,
  kUndecided,  ///< Neither a witness nor a refutation was found.
  kExcused,
  kNotJudged,  ///< Outside the candidate's stated domain.
};
inline constexpr std::size_t kStandingCount = 4;
inline constexpr std::array<std::string_view, kStandingCount> kStandingNames = {
    "defect", "undecided", "excused", "not judged"};
constexpr std::string_view name(Standing standing) {
  return kStandingNames[static_cast<std::size_t>(standing)];
}

enum class ExcuseKind {
  kNone,
  kUndecided,
  kWitness,
  kThreshold,
  kIllConditioned,
  kOutsideDomain,
};
/// A kind's name, and the standing that it gives an answer.
struct ExcuseInfo {
  std::string_view name;
  Standing standing;
};
inline constexpr std::array<ExcuseInfo, 6> kExcuses = {
    {{"", Standing::kDefect},
     {"undecided", Standing::kUndecided},
     {"witness", Standing::kExcused},
     {"threshold", Standing::kExcused},
     {"ill-conditioned", Standing::kExcused},
     {"outside the domain", Standing::kNotJudged}}};
constexpr const ExcuseInfo& info(ExcuseKind kind) {
  return kExcuses[static_cast<std::size_t>(kind)];
}
constexpr std::string_view name(ExcuseKind kind) { return info(kind).name; }

/// Why a discrepancy does not count against the candidate, if there is a reason.
struct Excuse {
  ExcuseKind kind = ExcuseKind::kNone;
  /// Depends on the kind: the relative change of the inputs within which a witness was found, or a
  /// refutation (kNone; 0 where no excuse applies), or neither; the threshold that the exact s does
  /// not exceed; the condition number that allows the error. 0 for other kinds.
  double amount = 0;
  /// The changed inputs for which the answer is right, if there is a witness.
  reference::InputChange witness = {};

  Standing standing() const { return info(kind).standing; }
  bool operator==(const Excuse&) const = default;
  template <class Archive>
  void serialize(Archive& archive) {
    archive(kind, amount, witness);
  }
};

/// The quality of an answer, given the conditioning of its question.
enum class Outcome {
  kExact,              ///< The double nearest to the truth, or the right decision.
  kAccurate,           ///< Off by at most kAccurateError.
  kIllConditioned,     ///< Off by more, but explained by kappa.
  kUnstable,           ///< Off by more than kappa explains.
  kExcusedDecision,    ///< A witness shows that a small change of the inputs makes it right.
  kUndecidedDecision,  ///< Neither a witness nor a refutation was found.
  kWrongDecision,      ///< A defect: no small change of the inputs makes it right.
  kOutsideDomain,      ///< Off by more than kAccurateError, or wrong, outside the stated domain.
};
inline constexpr std::size_t kOutcomeCount = 8;
inline constexpr std::array<std::string_view, kOutcomeCount> kOutcomeNames = {
    "exact",
    "accurate",
    "ill-conditioned",
    "unstable",
    "wrong decision, excused",
    "wrong decision, undecided",
    "wrong decision",
    "outside the stated domain"};
constexpr std::string_view name(Outcome outcome) {
  return kOutcomeNames[static_cast<std::size_t>(outcome)];
}

/// Errors up to these count as exact and as accurate. They are in the unit of the quantity (ulp or
/// u), times the ratio of the candidate's unit roundoff to that of the format in which it is
/// judged.
inline constexpr double kExactError = 0.5;
inline constexpr double kAccurateError = 4;

/// A candidate is stable on a source if, at all severities, its stability ratio rho = error / ((1 +
/// kappa) u) is at most this and no decision is wrong without an excuse.
inline constexpr double kStableRatio = 16;

/// The error of an answer, relative to its conditioning.
struct Stability {
  double condition = 0;  ///< kappa
  /// rho; if kappa is infinite (at an exact tangent), the backward error in units of u instead.
  double ratio = 0;
  Outcome outcome = Outcome::kExact;
};

/// The way in which a decision was wrong.
enum class Wrong {
  kNot,
  kMissed,
  kFalseHit,
  kWrongSphere,
  kWrongRoot,
  kRefused,
  kAnswered,
  kFailed
};
inline constexpr std::size_t kWrongCount = 8;
inline constexpr std::array<std::string_view, kWrongCount> kWrongNames = {
    "",
    "missed",
    "false hit",
    "wrong sphere",
    "wrong root",
    "refused",
    "answered what is not a problem",
    "failed"};
constexpr std::string_view name(Wrong wrong) {
  return kWrongNames[static_cast<std::size_t>(wrong)];
}

/// The kind of the right answer. If a kind was expected and never answered right, a law has shown
/// nothing about it.
enum class Expected {
  kHit,
  kMiss,
  kSmallerRoot,
  kLargerRoot,
  kNearestOfSeveral,  ///< Among several spheres that a ray meets.
  kOnlySphere,
  kNoSphere,
  kRefusal,
  kValue,  ///< A number or a vector: right if within its bound.
};
inline constexpr std::size_t kExpectedCount = 9;
inline constexpr std::array<std::string_view, kExpectedCount> kExpectedNames = {
    "hit",         "miss",      "smaller root", "larger root", "nearest of several",
    "only sphere", "no sphere", "refusal",      "value"};
constexpr std::string_view name(Expected expected) {
  return kExpectedNames[static_cast<std::size_t>(expected)];
}

/// The number of questions, and of answers that are right without an excuse.
struct Answered {
  std::uint64_t asked = 0;
  std::uint64_t right = 0;
  template <class Archive>
  void serialize(Archive& archive) {
    archive(asked, right);
  }
};

/// The part of a case about which an answer is: a ray (a camera's pixel, or the index of a given
/// ray), and a sphere if the quantity has one.
struct Place {
  std::size_t ray = 0;
  std::optional<scene::Pixel> pixel;
  std::optional<std::size_t> sphere;
  template <class Archive>
  void serialize(Archive& archive) {
    archive(ray, pixel, sphere);
  }
};

/// An answer that is right or wrong: the place, the expected kind, and how the answer differs.
struct Decision {
  Quantity quantity;
  Expected expected;
  Place place;
  Wrong wrong;
};

/// The order of places by the ray, then the sphere, then the pixel.
bool is_earlier(const Place& a, const Place& b);

/// The comparisons of one quantity. They do not depend on the order of counting and merging; the
/// memory does not grow with their number (properties/quantile_sketch.h).
struct Tally {
  std::uint64_t cases = 0;  ///< The number of right decisions, wrong decisions and errors.
  std::uint64_t right = 0;
  std::map<Wrong, std::uint64_t> wrong;
  std::array<std::uint64_t, kStandingCount> wrong_by_standing = {};
  std::array<Answered, kExpectedCount> answered = {};  ///< By Expected.
  QuantileSketch errors;                               ///< Empty for decisions.
  /// The least and the greatest bound with which errors were compared.
  double least_bound = std::numeric_limits<double>::infinity();
  double greatest_bound = -std::numeric_limits<double>::infinity();
  /// Errors above the flat bound but within the grown bound: no discrepancies.
  std::uint64_t ill_conditioned = 0;
  /// The largest error. For decisions, 2 if one is a defect, 1 if others are wrong.
  double worst = -1;
  Place worst_place;  ///< The place of the worst; of equally bad ones, the earliest.
  // Only for trials with TrialOptions::conditioning.
  QuantileSketch conditions;              ///< One for each error.
  std::optional<double> worst_condition;  ///< At worst_place.
  /// The largest stability ratio within the stated domain.
  std::optional<double> worst_ratio;
  std::array<std::uint64_t, kOutcomeCount> outcomes = {};
  /// The largest finite error divided by the factor by which its documented bound grows. The
  /// documented bound limits this quotient.
  std::optional<double> max_over_growth;

  void merge(const Tally& other);
  /// Stores an error, or the rank of a wrong answer, if it is the worst.
  void note_worst(double badness, const Place& place, std::optional<double> condition = {});

  /// The bound with which all errors were compared; empty if bounds differ or there are no errors.
  std::optional<double> bound() const {
    return least_bound == greatest_bound ? std::optional(greatest_bound) : std::nullopt;
  }
  std::uint64_t wrong_answers() const;
  std::uint64_t count(Wrong kind) const;
  std::uint64_t count(Standing standing) const {
    return wrong_by_standing[static_cast<std::size_t>(standing)];
  }
  Answered& answers_to(Expected expected) { return answered[static_cast<std::size_t>(expected)]; }
  std::uint64_t count(Outcome outcome) const { return outcomes[static_cast<std::size_t>(outcome)]; }
  template <class Archive>
  void serialize(Archive& archive) {
    archive(cases, right, wrong, wrong_by_standing, answered, errors, least_bound, greatest_bound,
            ill_conditioned, worst, worst_place, conditions, worst_condition, worst_ratio, outcomes,
            max_over_growth);
  }
  /// Whether every error counted was weighed by its condition number.
  bool is_weighed() const { return errors.count() == conditions.count(); }
  /// The smallest number that this share of all errors does not exceed, up to kSketchResolution;
  /// the maximum is exact. Empty if no error was measured.
  std::optional<double> quantile(double share) const { return errors.quantile(share); }
  std::optional<double> median() const { return quantile(0.5); }
  std::optional<double> max() const { return errors.max(); }
  /// A quantile of the condition numbers.
  std::optional<double> condition_quantile(double share) const {
    return conditions.quantile(share);
  }
};

/// The questions to blame for a failure.
enum class Blame {
  kNone,      ///< The answer is not a failure, or the questions were not searched for.
  kQuestion,  ///< One question, which fails when it is asked separately.
  kAmong,     ///< One of several questions, which was not searched for.
  kTogether,  ///< Several questions asked at once; in parts, they are answered.
  kAnything   ///< It fails on every question.
};
inline constexpr std::array<std::string_view, 5> kBlameNames = {"none", "question", "among",
                                                                "together", "anything"};
constexpr std::string_view name(Blame blame) {
  return kBlameNames[static_cast<std::size_t>(blame)];
}

/// Where a candidate failed.
struct FailureSite {
  Blame blame = Blame::kNone;
  std::uint64_t count = 0;  ///< The number of questions to blame, from the discrepancy's place on.
  /// The single question as a scene; empty unless there is exactly one.
  std::optional<scene::Scene> scene;
  std::optional<CodeLine> line = {};  ///< The line in the candidate's source, if known.
  bool timed_out = false;             ///< Whether it gave no reply in time.
  template <class Archive>
  void serialize(Archive& archive) {
    archive(blame, count, scene, line, timed_out);
  }
};

/// An answer that differs from the truth by more than allowed.
struct Discrepancy {
  std::string law;
  Quantity quantity = Quantity::kFrame;
  Place place;
  std::string what;  ///< Which part: "U", "corner (0, 0)", "scaled by 2^40".
  /// The symbol of the numbers got and exact: "s", "Q"; empty if `what` says what they are.
  std::string symbol;
  std::vector<double> got;    ///< Empty for a miss, or if the answer has no numbers.
  std::vector<double> exact;  ///< Correctly rounded to `precision`; empty like got.
  /// Whether a picture shows an unknown sphere, or the answer is a hit without a point.
  bool got_some_sphere = false;
  double error = 0;  ///< In the quantity's unit; infinite for decisions.
  scene::Precision precision = scene::Precision::kDouble;  ///< The format of that unit.
  Wrong wrong = Wrong::kNot;
  std::optional<double> condition;  ///< The condition number, if it was computed.
  Excuse excuse;
  /// The interval by which the answered s is judged, if s lies outside it.
  std::optional<scene::ValidRoots> excluded_by;
  FailureSite failed;  ///< Where it failed.
  template <class Archive>
  void serialize(Archive& archive) {
    archive(law, quantity, place, what, symbol, got, exact, got_some_sphere, error, precision,
            wrong, condition, excuse, excluded_by, failed);
  }
};

/// The quantity of a wrong answer and the way in which it is wrong, without its place.
struct DefectKind {
  Quantity quantity = Quantity::kFrame;
  Wrong wrong = Wrong::kNot;  ///< kNot for an error above its bound.
  auto operator<=>(const DefectKind&) const = default;
  template <class Archive>
  void serialize(Archive& archive) {
    archive(quantity, wrong);
  }
};

/// Whether a discrepancy breaks a law; if `strictly`, excused and undecided discrepancies do, too.
bool is_held_against(const Discrepancy& discrepancy, bool strictly);

/// Sorts discrepancies for reports: by standing, defects first. Within a standing, the worst of
/// each quantity come first, then the second worst of each, and so on, so that no quantity hides
/// the others. A larger error is worse; if errors are equal, the earlier place, the law's name and
/// the part's name decide.
std::vector<Discrepancy> worst_first(std::vector<Discrepancy> discrepancies);

/// A verdict keeps at most this many discrepancies, because a bad candidate has one in every pixel.
inline constexpr std::size_t kKeptDiscrepancies = 1000;

/// A law's verdict on a case, or on several cases, merged. Either the case was left out, with a
/// reason; or the verdict has the comparisons and the discrepancies found. The law holds if none of
/// these is a defect.
class Verdict {
 public:
  /// A verdict without a law, into which verdicts of several laws are merged.
  Verdict() = default;
  /// A verdict of the law with this name, which its discrepancies get.
  explicit Verdict(std::string_view law) : law_(law) {}

  /// Records that the case, or a part of it, was left out.
  void leave_out(std::string reason) { left_out_ = std::move(reason); }

  /// Counts a measured error, and the bound with which it is compared.
  void measured(Quantity quantity, const Place& place, double error, double bound);
  /// Counts the stability of the error that was just measured.
  void weighed(Quantity quantity, const Place& place, double error, const Stability& stability);
  /// Counts an error, already measured, that only its condition number allows.
  void count_ill_conditioned(Quantity quantity) {
    ++tallies_[quantity].ill_conditioned;
    ++tallies_[quantity].answers_to(Expected::kValue).right;
  }
  /// Counts answers that are right.
  void judged_right(Quantity quantity, Expected expected, std::uint64_t count);
  /// Counts a question that is not answered right, without adding a discrepancy.
  void not_right(Quantity quantity, Expected expected) {
    ++tallies_[quantity].answers_to(expected).asked;
  }
  /// Counts an answer that is wrong.
  void judged_wrong(const Decision& decision, Standing standing);
  /// Adds a discrepancy under this verdict's law.
  void add(Discrepancy discrepancy);
  void merge(const Verdict& other);
  /// Drops the discrepancies, but keeps their counts.
  void drop_discrepancies() { kept_ = {}; }
  /// Drops the discrepancies, the errors and the condition numbers, but keeps their counts.
  void keep_counts();
  /// Adds `first` to every ray index, because this verdict's case was the part of a larger case
  /// that begins at this ray.
  void shift_rays(std::size_t first);
  /// Changes every place, for example from a ray to its pixel.
  void relocate(const std::function<Place(const Place&)>& new_place);

  const std::map<Quantity, Tally>& tallies() const { return tallies_; }
  /// The tally of a quantity; empty if nothing was compared.
  const Tally& tally(Quantity quantity) const;
  /// The worst discrepancies kept, in the order of worst_first().
  std::vector<Discrepancy> worst(std::size_t count) const;
  std::uint64_t discrepancies() const;
  std::uint64_t count(Standing standing) const {
    return by_standing_[static_cast<std::size_t>(standing)];
  }
  std::uint64_t compared() const;
  /// Whether there is no defect; if `strictly`, no judged answer that differs from the truth.
  bool holds(bool strictly = false) const;
  /// The first kind of question that was asked but answered right, without an excuse, fewer than
  /// `fewest` times: too few for the law to hold. Values of all quantities are one kind.
  /// `wants_hits`: whether hits must be among the hit classes judged, if there are any.
  std::optional<std::pair<Quantity, Expected>> too_few_right(std::uint64_t fewest,
                                                             bool wants_hits = false) const;
  /// The distinct kinds of the kept discrepancies that break the law, in order.
  std::vector<DefectKind> defects(bool strictly = false) const;
  /// The kinds of the kept discrepancies that are undecided.
  std::vector<DefectKind> undecided() const;
  /// The first known line at which the candidate failed, in kept discrepancies that break the law.
  std::optional<CodeLine> failed_at(bool strictly = false) const;
  const std::string& reason_left_out() const { return left_out_; }
  /// The archive does not contain the law.
  template <class Archive>
  void serialize(Archive& archive) {
    archive(left_out_, tallies_, kept_, by_standing_);
  }

 private:
  void prune();
  std::vector<DefectKind> kinds_of(const std::function<bool(const Discrepancy&)>& is_meant) const;

  std::string_view law_;
  std::string left_out_;
  std::map<Quantity, Tally> tallies_;
  std::vector<Discrepancy> kept_;
  std::array<std::uint64_t, kStandingCount> by_standing_ = {};
};

}  // namespace raycheck::properties
