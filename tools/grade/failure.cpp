#include "tools/grade/failure.h"

#include <fmt/core.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "properties/cases/shrink.h"
#include "properties/mistakes/answer_explanation.h"
#include "properties/mistakes/image_explanation.h"
#include "properties/search/campaign.h"
#include "tools/external/renderer.h"
#include "tools/external/sandbox/process.h"
#include "tools/grade/submission.h"
#include "tools/report/words.h"

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

/// The first wrong step: laws of single values are in the order of steps.
std::string step_of(const Case& the_case, const Asking& asking) {
  Trial trial(the_case, asking.candidate, asking.options());
  for (const Law& law : properties::laws()) {
    if (!law.judges_values || law.per == Per::kImage) continue;
    if (!apply(law, trial).holds()) return step_that_gives(law.quantity);
  }
  return "";
}

/// What was answered, or should have been.
std::string answer_text(const Discrepancy& d, const std::vector<double>& answer) {
  if (d.quantity == properties::Quantity::kRefusal) return "";
  if (d.quantity != properties::Quantity::kNearestSphere) return numbers_text(answer);
  if (!answer.empty()) return fmt::format("sphere {}", answer.front());
  const bool is_untold = &answer == &d.got && d.wrong == Wrong::kFalseHit;
  return is_untold ? "a sphere" : "no sphere";
}

}  // namespace

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

Case simplest(const Case& from, const Law& law, const Discrepancy& first, const Asking& asking,
              const std::function<bool()>& is_late) {
  const bool failed = first.wrong == Wrong::kFailed;
  // A silence costs as much as it lasts.
  for (const std::string_view late : {kSilent, kEndless}) {
    if (failed && first.what.find(late) != std::string::npos) return from;
  }
  const int tries = failed ? kTriesOfFailures : asking.pictures ? kTriesOfPictures : kTries;
  // A picture is judged in every pixel.
  const auto whole = [&](Case the_case) {
    if (asking.pictures) the_case.pixels = properties::all_pixels(*the_case.scene.camera);
    return the_case;
  };
  Case start = from;
  if (asking.pictures) start.pixels.clear();
  return whole(properties::smallest(std::move(start), tries, [&](const Case& next) {
    if (is_late() || !is_alike(next.scene, from.scene)) return false;
    const Case judged = whole(next);
    Trial trial(judged, asking.candidate, asking.options());
    const Verdict verdict = apply(law, trial);
    if (verdict.holds()) return false;
    const Discrepancy now = verdict.worst(1).front();
    return now.wrong == first.wrong && now.quantity == first.quantity;
  }));
}

std::optional<FailingCase> failing_case(const Case& the_case, const std::string& origin,
                                        const Law& law, const Discrepancy& first,
                                        const Asking& asking) {
  Trial trial(the_case, asking.candidate, asking.options());
  const Verdict verdict = apply(law, trial);
  if (verdict.holds()) return {};
  // Asked again, a program that failed may not be asked at all.
  const Discrepancy d = first.wrong == Wrong::kFailed ? first : verdict.worst(1).front();
  FailingCase failing;
  failing.law = law.sentence;
  failing.origin = origin;
  failing.what = plain_text(head(d));
  failing.actual = answer_text(d, d.got);
  failing.expected = answer_text(d, d.exact);
  Case told = the_case;
  told.scene.conventions = trial.conventions();
  failing.scene = asking.pictures ? scene::write_toml(told.scene) : properties::text(told);
  if (told.scene.camera) failing.driver = driver_text(told.scene, asking.dialect);
  if (!asking.pictures && d.wrong != Wrong::kFailed) failing.step = step_of(the_case, asking);
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

std::vector<std::string> mistake_sentences(const std::vector<Case>& cases,
                                           const Candidate& candidate, bool pictures) {
  std::vector<Explanation> found;
  try {
    found = pictures ? explained_pictures(cases, candidate)
                     : properties::explanations(cases, candidate);
  } catch (const std::runtime_error&) {
    return {};  // it fails, as the verdict says
  }
  std::vector<std::string> result;
  for (const Explanation& one : found) {
    if (one.errors < kFewestErrors) continue;
    result.push_back(fmt::format("{}: {} of {} wrong {} are right that way", one.sentence,
                                 one.explained, one.errors, pictures ? "pixels" : "answers"));
  }
  return result;
}

}  // namespace raycheck::tools
