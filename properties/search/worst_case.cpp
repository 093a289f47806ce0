#include "properties/search/worst_case.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "properties/cases/random.h"
#include "properties/cases/shrink.h"
#include "scene/fields.h"
#include "scene/interruption.h"
#include "scene/validate.h"

namespace raycheck::properties {
namespace {

/// The number of random cases from which the search climbs.
constexpr std::size_t kClimbs = 4;

/// x with its significand, exponent or sign changed, in a format.
double changed(double x, Precision precision, Random& random) {
  const auto kind = random.integer(0, 9);
  if (kind == 0) return -x;
  if (kind <= 3) return std::ldexp(x, static_cast<int>(random.integer(-3, 3)));
  if (x == 0) return random.signed_power_of_ten(-3, 3);
  const double sign = random.sign();
  const int most = scene::format_of(precision).digits - 2;
  const double ulps = std::ldexp(sign, static_cast<int>(random.integer(0, most)));
  const double ulp =
      scene::next_after(precision, std::abs(x), std::numeric_limits<double>::infinity()) -
      std::abs(x);
  return x + ulps * ulp;
}

/// The case with one or two numbers changed; empty if a number leaves the format's range, or the
/// case becomes invalid.
std::optional<Case> neighbour(const Case& the_case, InputFormat format, Random& random) {
  Case result = the_case;
  std::int64_t count = 0;
  for_each_number(result.scene, [&](double&) { ++count; });
  for (auto changes = random.integer(1, 2); changes > 0; --changes) {
    const std::int64_t target = random.integer(0, count - 1);
    std::int64_t at = 0;
    for_each_number(result.scene, [&](double& x) {
      if (at++ == target) x = changed(x, format.precision, random);
    });
  }
  if (!scene::defects(result.scene).empty()) return std::nullopt;
  return rounded_case(std::move(result), format).the_case;
}

/// Keeps only the first ray and the first sphere, so that error, kappa and outcome belong to one
/// answer.
void keep_first(Case& the_case) {
  const auto keep = [](auto& list) { list.resize(std::min<std::size_t>(list.size(), 1)); };
  keep(the_case.pixels);
  keep(the_case.scene.rays);
  keep(the_case.scene.spheres);
}

/// Searches for the case on which the quantity of one law is worst.
class Climber {
 public:
  Climber(const Candidate& candidate, Stage stage, const SearchOptions& options,
          const RunControl& control)
      : candidate_(candidate),
        stage_(stage),
        law_(*law_of(stage, options.quantity)),
        options_(options),
        control_(control),
        random_(options.seed) {}

  /// The worst kClimbs of the random cases.
  std::vector<WorstCase> random_phase() {
    std::vector<WorstCase> best;
    for (int k = 0; k < options_.cases && !control_.interrupted(); ++k) {
      const auto& source = options_.sources[static_cast<std::size_t>(k) % options_.sources.size()];
      std::optional<Case> one =
          case_of_stage(source.make(random_.bits()), stage_, candidate_, candidate_.input_format())
              .the_case;
      if (!one) continue;
      keep_first(*one);
      std::optional<WorstCase> seen = look(*one);
      if (!seen) continue;
      best.push_back(std::move(*seen));
      std::stable_sort(best.begin(), best.end(),
                       [](const WorstCase& a, const WorstCase& b) { return a.height > b.height; });
      best.resize(std::min(best.size(), kClimbs));
    }
    return best;
  }

  void climb(WorstCase& at, int steps) {
    for (int step = 0; step < steps && !control_.interrupted(); ++step) {
      const std::optional<Case> next = neighbour(at.the_case, candidate_.input_format(), random_);
      if (!next) continue;
      std::optional<WorstCase> seen = look(*next);
      if (seen && seen->height > at.height) at = std::move(*seen);
    }
  }

  void shrink(WorstCase& at) {
    const double least = at.height / 2;
    ShrinkBudget budget;
    smallest(at.the_case, budget, [&](const Case& next) {
      if (control_.interrupted() || !is_of_format(next.scene, candidate_.input_format()))
        return false;
      std::optional<WorstCase> seen = look(next);
      if (!seen || seen->height < least || seen->stability.outcome != at.stability.outcome) {
        return false;
      }
      at = std::move(*seen);
      return true;
    });
  }

 private:
  /// Judges a case. Empty if nothing was measured in the candidate's domain, if the maximised value
  /// is NaN, or on an interrupt.
  std::optional<WorstCase> look(const Case& the_case) const try {
    if (!is_problem(the_case, candidate_.declared)) return std::nullopt;
    // With a bound of 0, every error is a discrepancy, which stores its place and numbers.
    Trial trial(the_case, candidate_, {.max_error = 0, .conditioning = true});
    if (!trial.inside_domain()) return std::nullopt;
    const Verdict verdict = apply(law_, trial);
    const Tally& tally = verdict.tally(options_.quantity);
    if (tally.errors.empty()) return std::nullopt;
    if (!std::isfinite(tally.worst)) return std::nullopt;
    WorstCase result;
    result.the_case = the_case;
    result.error = tally.worst;
    result.stability.condition = tally.worst_condition.value();
    result.stability.ratio = tally.worst_ratio.value_or(-1);
    for (std::size_t k = 0; k < kOutcomeCount; ++k) {
      if (tally.outcomes[k] > 0) result.stability.outcome = static_cast<Outcome>(k);
    }
    result.height = height_of(result);
    for (Discrepancy& discrepancy : verdict.worst(1)) result.shown = std::move(discrepancy);
    return result;
  } catch (const scene::Interrupted&) {
    return std::nullopt;
  }

  double height_of(const WorstCase& at) const {
    switch (options_.climb) {
      case Climb::kRatio:
        return at.stability.ratio;
      case Climb::kOverGrowth:
        return at.error / bound_growth(at.stability.condition);
      default:
        return at.error;
    }
  }

  const Candidate& candidate_;
  const Stage stage_;
  const Law& law_;
  const SearchOptions& options_;
  const RunControl& control_;
  Random random_;
};

}  // namespace

const Law* law_of(Stage stage, Quantity quantity) {
  if (is_decision(quantity)) return nullptr;
  const auto found =
      laws_that([&](const Law& law) { return law.stage == stage && law.quantity == quantity; });
  return found.empty() ? nullptr : found.front();
}

std::optional<WorstCase> find_worst_case(const Candidate& candidate, Stage stage,
                                         const SearchOptions& options, const RunControl& control) {
  const scene::Interruptible interruptible(control.interrupted);
  Climber climber(candidate, stage, options, control);
  std::vector<WorstCase> starts = climber.random_phase();
  if (starts.empty()) return std::nullopt;
  const double height_random = starts.front().height;
  for (WorstCase& start : starts) {
    climber.climb(start, options.steps / static_cast<int>(starts.size()));
  }
  WorstCase worst =
      *std::max_element(starts.begin(), starts.end(),
                        [](const WorstCase& a, const WorstCase& b) { return a.height < b.height; });
  const double height_climbed = worst.height;
  climber.shrink(worst);
  worst.height_climbed = height_climbed;
  worst.height_random = height_random;
  return worst;
}

}  // namespace raycheck::properties
