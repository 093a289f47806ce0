#include "properties/laws/law.h"

#include <algorithm>
#include <exception>
#include <limits>
#include <new>
#include <stdexcept>
#include <string>

#include "properties/laws/law_list.h"
#include "scene/interruption.h"

namespace raycheck::properties {

std::span<const Law> laws() {
  static const std::vector<Law> all = [] {
    std::vector<Law> joined;
    for (const std::span<const Law> some :
         {kFrameLaws, kPixelPlaneLaws, kPixelRayLaws, kIntersectLaws, kNearestSphereLaws,
          kImageLaws, kPlanLaws, kMetamorphicLaws, kRefusalLaws}) {
      joined.insert(joined.end(), some.begin(), some.end());
    }
    return joined;
  }();
  return all;
}

const Law* find_law(std::string_view name) {
  const auto found =
      std::find_if(laws().begin(), laws().end(), [&](const Law& law) { return law.name == name; });
  return found == laws().end() ? nullptr : &*found;
}

bool wants_given_rays(const Law& law, const Trial& trial) {
  return needs_any(law.needs, Needs::kRays) && !trial.has_rays() &&
         (trial.candidate().intersect || trial.candidate().nearest);
}

namespace {

/// A law's verdict on a candidate that gave no answer, `message` being what it threw.
Verdict verdict_on_failure(const Law& law, const Trial& trial, Wrong wrong, const char* message) {
  Verdict verdict(law.name);
  trial.judge(
      verdict, Quantity::kRefusal, Question::kRefusal, Place{}, wrong, [] { return Excuse{}; },
      [&](Discrepancy& discrepancy) { discrepancy.what = message; });
  return verdict;
}

}  // namespace

Verdict apply(const Law& law, Trial& trial) {
  scene::poll();
  try {
    Verdict verdict(law.name);
    const std::string_view missing = what_is_missing(law.needs, trial);
    if (missing.empty()) {
      law.judge(trial, verdict);
    } else {
      verdict.leave_out(std::string(missing));
    }
    return verdict;
  } catch (const std::bad_alloc&) {
    throw;  // no fault of the candidate
  } catch (const std::invalid_argument& error) {
    return verdict_on_failure(law, trial, Wrong::kRefused, error.what());
  } catch (const std::exception& error) {
    return verdict_on_failure(law, trial, Wrong::kFailed, error.what());
  }
}

}  // namespace raycheck::properties
