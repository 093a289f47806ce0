#include "properties/mistakes/causes.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>
#include <utility>

#include "properties/case.h"
#include "properties/mistakes/answer_examination.h"
#include "properties/mistakes/answer_explanation.h"
#include "properties/mistakes/picture_causes.h"
#include "properties/mistakes/undeclared.h"
#include "scene/interruption.h"
#include "scene/precision.h"

namespace raycheck::properties {
namespace {

bool is_too_large(const scene::Scene& scene) {
  return !scene.camera || scene.camera->width > kMostPixelsOfACause / scene.camera->height;
}

/// Whether squares of distances overflow: a separate defect, which other causes need not explain.
bool overflows(const scene::Scene& scene, scene::Precision precision) {
  return std::any_of(scene.spheres.begin(), scene.spheres.end(), [&](const auto& sphere) {
    const scene::Vector3 T = sphere.centre - scene.camera->eye;
    return !std::isfinite(scene::rounded_to(precision, T.x * T.x + T.y * T.y + T.z * T.z));
  });
}

/// The candidate's pictures of those scenes that are not too large.
std::vector<ShownPicture> shown(const std::vector<Case>& cases, const Candidate& candidate) {
  std::vector<ShownPicture> pictures;
  for (const Case& one : cases) {
    if (is_too_large(one.scene) || overflows(one.scene, candidate.precision)) continue;
    if (auto picture = shown_picture(one.scene, candidate)) {
      pictures.push_back(std::move(*picture));
    }
  }
  return pictures;
}

/// The causes of wrong answers. Wrong answers in cases that were left out count as unexplained, and
/// so do, for kNotNumbers, all other defects of the law. Other causes of less than half of the
/// wrong answers are dropped.
std::vector<Explanation> answer_explanations(const Law& law, const std::vector<Case>& cases,
                                             const Candidate& candidate) {
  std::vector<Explanation> found = explanations(answer_causes(cases, candidate));
  if (found.empty()) return found;
  std::vector<Case> not_searched;
  std::copy_if(cases.begin(), cases.end(), std::back_inserter(not_searched),
               [&](const Case& one) { return is_left_out(one, candidate); });
  const std::uint64_t others = count_defects(law, not_searched, candidate);
  for (Explanation& one : found) {
    if (one.explained == 0) continue;
    one.errors += others;
    if (one.sentence == kNotNumbers) {
      one.errors = std::max(one.errors, count_defects(law, cases, candidate));
    }
  }
  std::erase_if(found, [](const Explanation& one) {
    return one.sentence != kNotNumbers && 2 * one.explained < one.errors && one.explained > 0;
  });
  return found;
}

}  // namespace

std::vector<Explanation> causes(const Law& law, const std::vector<Case>& cases,
                                const Candidate& candidate) {
  std::vector<Case> asked;
  for (const Case& one : cases) {
    auto rounded = rounded_case(one, candidate.input_format()).the_case;
    if (rounded && is_problem(*rounded, candidate.declared)) asked.push_back(*std::move(rounded));
  }
  try {
    if (const auto under = right_under(law, asked, candidate)) {
      return {{"right under " + under->conventions + ", which the candidate does not declare",
               under->defects, under->defects}};
    }
    if (!candidate.image) return answer_explanations(law, asked, candidate);
    std::vector<Explanation> found = explanations(picture_causes(shown(asked, candidate)));
    std::erase_if(found, [](const Explanation& one) { return one.errors < kFewestErrorsOfACause; });
    return found;
  } catch (const NoAnswer&) {
    return {};  // the verdict reports that it gives no answer
  } catch (const scene::Interrupted&) {
    return {};
  }
}

std::vector<Explanation> causes(const Law& law, const TellingCases& telling,
                                const Candidate& candidate) {
  std::vector<Explanation> all;
  for (std::size_t round = 0;; ++round) {
    const std::vector<Case> cases = telling(round);
    if (cases.empty()) return all;
    bool is_explained = false;
    for (Explanation& one : causes(law, cases, candidate)) {
      if (one.explained > 0) {  // not kTooFewErrors
        is_explained = is_explained || one.sentence != kNotNumbers;
        std::erase_if(all, [](const Explanation& known) { return known.explained == 0; });
      }
      const bool is_known = std::any_of(all.begin(), all.end(), [&](const Explanation& known) {
        return known.sentence == one.sentence;
      });
      if (!is_known && (one.explained > 0 || all.empty())) all.push_back(std::move(one));
    }
    if (is_explained) return all;
    if (round == 1 && (all.empty() || all.front().explained == 0)) return all;
  }
}

}  // namespace raycheck::properties
