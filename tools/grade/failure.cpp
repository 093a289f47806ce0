#include "tools/grade/failure.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "properties/cases/shrink.h"
#include "properties/mistakes/answer_explanation.h"
#include "properties/mistakes/image_explanation.h"
#include "tools/grade/wording.h"

namespace raycheck::tools {
namespace {

using properties::Candidate;
using properties::Case;
using properties::Discrepancy;
using properties::Law;
using properties::Per;
using properties::Trial;
using properties::Verdict;
using properties::Wrong;

/// Simpler cases tried in place of a failing one: of functions, of programs that fail altogether,
/// and of pictures, for each of which a program is started.
constexpr int kTries = 400;
constexpr int kTriesOfFailures = 40;
constexpr int kTriesOfPictures = 60;

/// Fewer wrong answers are explained by too much to name a mistake.
constexpr std::uint64_t kFewestErrors = 3;

/// The step from a scene to what is seen that a wrong quantity shows to be wrong.
std::string step_that_gives(properties::Quantity quantity) {
  using properties::Quantity;
  switch (quantity) {
    case Quantity::kUnitDefect:
      return std::string(info(Quantity::kDirection).name);
    case Quantity::kClass:
      return "discriminant";
    case Quantity::kParameter:
      return std::string(info(Quantity::kRoot).name);
    default:
      return std::string(info(quantity).name);
  }
}

/// Whether a camera still looks the way in which another does, its bounds in the same order: what
/// programs may rely on.
bool is_alike(const scene::Scene& now, const scene::Scene& before) {
  if (!before.camera) return true;
  const scene::Camera& a = *now.camera;
  const scene::Camera& b = *before.camera;
  return (a.near < 0) == (b.near < 0) && (a.left < a.right) == (b.left < b.right) &&
         (a.bottom < a.top) == (b.bottom < b.top);
}

std::optional<std::string> first_wrong_step(const Case& the_case, const Examinee& examinee) {
  Trial trial(the_case, examinee.candidate, examinee.options());
  for (const Law& law : properties::laws()) {
    if (!law.judges_values || law.per == Per::kImage) continue;
    if (!apply(law, trial).holds()) return step_that_gives(law.quantity);
  }
  return {};
}

}  // namespace

WrongAnswer wrong_answer(const Discrepancy& d) {
  WrongAnswer answer{d.quantity, d.place, plain_text(d.what), d.wrong, d.symbol, d.got,
                     d.exact,    {},      d.condition};
  if (d.wrong == Wrong::kNot) answer.error = d.error;
  return answer;
}

Case simplest(const Case& from, const Law& law, const Discrepancy& first, const Examinee& examinee,
              const std::function<bool()>& is_late) {
  const bool failed = first.wrong == Wrong::kFailed;
  const int tries = failed ? kTriesOfFailures : examinee.pictures ? kTriesOfPictures : kTries;
  // A picture is judged in every pixel.
  const auto whole = [&](Case the_case) {
    if (examinee.pictures) the_case.pixels = properties::all_pixels(*the_case.scene.camera);
    return the_case;
  };
  Case start = from;
  if (examinee.pictures) start.pixels.clear();
  return whole(properties::smallest(std::move(start), tries, [&](const Case& next) {
    if (is_late() || !is_alike(next.scene, from.scene)) return false;
    const Case judged = whole(next);
    Trial trial(judged, examinee.candidate, examinee.options());
    const Verdict verdict = apply(law, trial);
    if (verdict.holds()) return false;
    const Discrepancy now = verdict.worst(1).front();
    return now.wrong == first.wrong && now.quantity == first.quantity;
  }));
}

std::optional<FailingCase> failing_case(const Case& the_case, const CaseOrigin& origin,
                                        const Law& law, const Discrepancy& first,
                                        const Examinee& examinee) {
  Trial trial(the_case, examinee.candidate, examinee.options());
  const Verdict verdict = apply(law, trial);
  if (verdict.holds()) return {};
  // Asked again, a program that failed may not be asked at all.
  const Discrepancy d = first.wrong == Wrong::kFailed ? first : verdict.worst(1).front();
  FailingCase failing{std::string(law.name), origin, {}, wrong_answer(d), the_case};
  failing.the_case.scene.conventions = trial.conventions();
  if (examinee.pictures) {
    failing.the_case.pixels.clear();
  } else if (d.wrong != Wrong::kFailed) {
    failing.step = first_wrong_step(the_case, examinee);
  }
  return failing;
}

namespace {

using properties::Explanation;

/// What explains the wrong pixels of all pictures together; one that shows nothing tells nothing.
std::vector<Explanation> explained_pictures(const std::vector<Case>& cases,
                                            const Candidate& candidate) {
  std::vector<Explanation> found;
  std::uint64_t wrong = 0;
  for (const Case& one : cases) {
    const auto conventions = candidate.declared.over(one.scene.conventions);
    const properties::ImageAnswer image = candidate.image(one.scene, conventions);
    if (properties::shows_nothing(image)) continue;
    Trial trial(one, candidate);
    for (const Law& law : properties::laws()) {
      if (law.per == Per::kImage) wrong += apply(law, trial).discrepancies();
    }
    for (const Explanation& mistake : properties::explanations(one.scene, conventions, image)) {
      const auto known = std::find_if(found.begin(), found.end(), [&](const Explanation& other) {
        return other.sentence == mistake.sentence;
      });
      if (known == found.end()) {
        found.push_back(mistake);
      } else {
        known->explained += mistake.explained;
      }
    }
  }
  for (Explanation& mistake : found) mistake.errors = std::max(wrong, mistake.explained);
  std::erase_if(found, [](const Explanation& mistake) {
    return mistake.errors - mistake.explained > properties::most_unexplained(mistake.errors);
  });
  return found;
}

}  // namespace

std::vector<ExplainingMistake> explaining_mistakes(const std::vector<Case>& cases,
                                                   const Candidate& candidate, bool pictures) {
  std::vector<Explanation> found;
  try {
    found = pictures ? explained_pictures(cases, candidate)
                     : properties::explanations(cases, candidate);
  } catch (const std::runtime_error&) {
    return {};  // it fails, as the verdict says
  }
  std::vector<ExplainingMistake> result;
  for (const Explanation& one : found) {
    if (one.errors < kFewestErrors) continue;
    result.push_back({one.sentence, one.errors, one.explained});
  }
  return result;
}

}  // namespace raycheck::tools
