#include "properties/search/law_search.h"

#include <charconv>
#include <utility>

#include "properties/cases/shrink.h"
#include "scene/interruption.h"

namespace raycheck::properties {
namespace {

/// A law's verdict on a case.
struct CaseVerdict {
  bool inside_domain = true;
  bool given_rays = false;
  Verdict verdict;
};

/// `trials` is null if the case is not valid under the candidate's conventions. `earlier`: see
/// Trial::set_earlier.
CaseVerdict verdict_on(const Law& law, Trials* trials, const Verdict* earlier = nullptr) {
  if (trials == nullptr) return {false, false, Verdict(law.name)};
  Trial& trial = trials->of(law);
  // If the candidate lacks functions, that is the reason, even outside its domain.
  const bool judged = trial.is_judged(law.quantity) || !what_is_missing(law.needs, trial).empty();
  return {judged, &trial != &trials->on_case(),
          judged ? trials->apply(law, earlier) : Verdict(law.name)};
}

CaseVerdict verdict_on(const Law& law, const Candidate& candidate, const Case& the_case,
                       std::optional<double> max_error, FailureSearch* search = nullptr) {
  if (!is_problem(the_case, candidate.declared)) return verdict_on(law, nullptr);
  Trials trials(the_case, candidate, {.max_error = max_error, .search = search});
  return verdict_on(law, &trials);
}

bool fails_always(const Verdict& verdict) {
  const std::vector<Discrepancy> worst = verdict.worst(1);
  return !worst.empty() && worst.front().failed.blame == Blame::kAnything;
}

}  // namespace

void LawSearch::judge(std::uint64_t seed, const RoundedCase& rounded, Trials* trials) {
  const std::uint64_t undecided = part.verdict.count(Standing::kUndecided);
  failure.reset();
  if (rounded.the_case) {
    auto [judged, given, verdict] = verdict_on(*law_, trials, &part.verdict);
    take(*rounded.the_case, judged, given, std::move(verdict));
  } else {
    leave_out(rounded.reason);
  }
  if (!part.undecided_seed && part.verdict.count(Standing::kUndecided) > undecided) {
    part.undecided_seed = seed;
  }
  if (!failure) return;
  failure->replay = replay_of(seed);
  std::string& replay = part.breaks.back().replay;
  if (replay.empty()) replay = failure->replay;
}

void LawSearch::judge(std::uint64_t seed) {
  const RoundedCase rounded = rounded_case(part.source.make(seed), candidate_->input_format());
  std::optional<Trials> trials;
  if (rounded.the_case && is_problem(*rounded.the_case, candidate_->declared)) {
    trials.emplace(*rounded.the_case, *candidate_, TrialOptions{.max_error = max_error_});
  }
  judge(seed, rounded, trials ? &*trials : nullptr);
}

void LawSearch::replay(std::uint64_t seed, bool shrinks) {
  until_interrupted([&] {
    judge(seed);
    if (shrinks) shrink();
  });
  if (failure) failure->is_shrunk = shrinks && !fails_always(failure->verdict);
}

void LawSearch::judge_restarted() {
  // Time-outs, and candidates that fail on every question, are not judged again.
  const auto worst = failure->verdict.worst(1);
  const bool timed_out = !worst.empty() && worst.front().failed.timed_out;
  if (!candidate_->restart || timed_out || fails_always(failure->verdict)) return;
  until_interrupted([&] {
    const auto is_right = [&](const Case& one, Verdict& verdict) {
      candidate_->restart();
      verdict = verdict_on(*law_, *candidate_, one, max_error_).verdict;
      return verdict.holds(strict_);
    };
    Verdict verdict(law_->name);
    if (!is_right(failure->shrunk, verdict)) return;
    failure->is_of_earlier = true;
    if (!whole_ || is_right(*whole_, verdict)) return;
    failure->shrunk = *whole_;
    failure->is_shrunk = false;
    failure->verdict = std::move(verdict);
  });
}

void LawSearch::replay_undecided(std::uint64_t seed) {
  const auto look = [&](const Case& one) {
    if (!is_of_format(one.scene, candidate_->input_format())) return false;
    Verdict verdict = verdict_on(*law_, *candidate_, one, max_error_).verdict;
    if (verdict.count(Standing::kUndecided) == 0) return false;
    failure = Failure{one, std::move(verdict), replay_of(seed), true};
    return true;
  };
  until_interrupted([&] {
    const auto rounded = rounded_case(part.source.make(seed), candidate_->input_format()).the_case;
    if (rounded && look(*rounded)) shrink_while(look);
  });
}

void LawSearch::replay(Case the_case) {
  until_interrupted([&] {
    const RoundedCase rounded = rounded_case(std::move(the_case), candidate_->input_format());
    if (rounded.the_case) {
      breaks(*rounded.the_case);
    } else {
      leave_out(rounded.reason);
    }
    shrink();
  });
  if (failure) failure->is_shrunk = !fails_always(failure->verdict);
}

template <class Work>
void LawSearch::until_interrupted(const Work& work) {
  try {
    work();
  } catch (const scene::Interrupted&) {
    interrupted = true;  // the cases judged before count
  }
  if (!strict_) part.undecided = part.verdict.undecided();
}

std::string LawSearch::replay_of(std::uint64_t seed) const {
  char digits[17] = {};
  std::to_chars(digits, digits + 16, seed, 16);
  return std::string(law_->name) + ":" + candidate_->name + ":" + part.source.name() + ":" + digits;
}

void LawSearch::leave_out(const std::string& reason) {
  ++part.counts.cases;
  ++part.counts.left_out;
  part.counts.reason = reason;
}

bool LawSearch::breaks(const Case& the_case) {
  auto [judged, given, verdict] = verdict_on(*law_, *candidate_, the_case, max_error_);
  return take(the_case, judged, given, std::move(verdict));
}

bool LawSearch::take(const Case& the_case, bool judged, bool given, Verdict verdict) {
  const bool is_shrinking = failure.has_value();
  if (!is_shrinking) count(judged, given, verdict);
  if (verdict.holds(strict_)) return false;
  // A failure on every question says nothing about a simpler case.
  if (is_shrinking && fails_always(verdict)) return false;
  if (!is_shrinking) {
    const bool is_first = part.verdict.compared() == verdict.compared();
    part.timed_out |= verdict.worst(1).front().failed.timed_out;
    if (is_first) part.failed_at_once = verdict.worst(1).front().wrong == Wrong::kFailed;
    std::vector<DefectKind> defects = verdict.defects(strict_);
    if (part.is_new(defects)) {
      part.breaks.push_back({{}, std::move(defects), verdict.failed_at(strict_)});
    }
  }
  failure = Failure{the_case, std::move(verdict), is_shrinking ? failure->replay : ""};
  return true;
}

void LawSearch::count(bool judged, bool given, const Verdict& verdict) {
  ++part.counts.cases;
  part.counts.given_rays += given ? 1 : 0;
  part.counts.not_judged += judged ? 0 : 1;
  if (!verdict.reason_left_out().empty() && verdict.compared() == 0) {
    ++part.counts.left_out;
    part.counts.reason = verdict.reason_left_out();
  }
  part.verdict.merge(verdict);
}

template <class Breaks>
void LawSearch::shrink_while(const Breaks& breaks) {
  ShrinkBudget budget;
  const std::int64_t all = budget.tries;
  const auto shrink_on = [&] {
    smallest(failure->shrunk, budget, breaks);
    if (budget.is_spent()) failure->tries = all - budget.tries;
  };
  shrink_on();
  const Case& shrunk = failure->shrunk;
  if (!shrunk.scene.camera || candidate_->pixel_rays || candidate_->focal_rays) return;
  const auto conventions = candidate_->declared.over(shrunk.scene.conventions);
  const bool was_given = verdict_on(*law_, *candidate_, shrunk, max_error_).given_rays;
  const auto given = was_given ? given_rays(shrunk, conventions, candidate_->input_format())
                               : std::optional<GivenRays>();
  if (given && breaks(given->the_case)) shrink_on();
}

void LawSearch::shrink() {
  if (!failure) return;
  whole_ = failure->shrunk;
  take_failed_question();
  shrink_while([this](const Case& simpler) {
    return is_of_format(simpler.scene, candidate_->input_format()) && breaks(simpler);
  });
}

void LawSearch::take_failed_question() {
  const std::vector<Discrepancy> worst = failure->verdict.worst(1);
  const bool has_failed = !worst.empty() && worst.front().wrong == Wrong::kFailed;
  if (!has_failed || fails_always(failure->verdict)) return;
  FailureSearch search;
  const Verdict verdict =
      verdict_on(*law_, *candidate_, failure->shrunk, max_error_, &search).verdict;
  for (Discrepancy& one : verdict.worst(kKeptDiscrepancies)) {
    if (one.failed.blame != Blame::kQuestion) continue;
    failure->shrunk = {*one.failed.scene, {}};
    if (one.failed.scene->camera) {
      failure->shrunk.pixels = {one.place.pixel.value()};
    } else {
      one.place = {0, {}, one.place.sphere ? std::optional<std::size_t>(0) : std::nullopt};
    }
    failure->verdict = Verdict(law_->name);
    failure->verdict.add(one);
    return;
  }
}

}  // namespace raycheck::properties
