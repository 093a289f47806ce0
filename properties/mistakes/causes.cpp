#include "properties/mistakes/causes.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <string_view>
#include <type_traits>
#include <utility>

#include "properties/case.h"
#include "properties/mistakes/answer_examination.h"
#include "properties/mistakes/answer_explanation.h"
#include "properties/mistakes/picture_causes.h"
#include "scene/interruption.h"
#include "scene/precision.h"

namespace raycheck::properties {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// A convention that a candidate may follow even if the scene says otherwise, another declaration
/// of the valid roots, or another interface.
struct Followed {
  std::string text;
  DeclaredConventions declared = {};
  std::optional<contract::Interface> interface = {};
  bool is_of_hits = true;  ///< Whether it changes hits, not only the rays that are made.
};

/// Sets the choice of this type.
template <class Choice>
void choose(auto& choices, const Choice& value) {
  using contract::for_each_choice, scene::for_each_choice;
  for_each_choice(choices, [&](auto /*name*/, auto& choice, auto...) {
    if constexpr (std::is_same_v<decltype(choice), Choice&>) choice = value;
  });
}

std::vector<Followed> undeclared(const Candidate& candidate) {
  const DeclaredConventions& declared = candidate.declared;
  std::vector<Followed> all;
  const auto add = [&](std::string_view name, auto value) -> Followed& {
    all.push_back({std::string(name) + " = " + std::string(scene::name(value))});
    return all.back();
  };
  const bool makes_rays =
      candidate.pixel_points || candidate.pixel_rays || candidate.focal_rays || candidate.pick;
  scene::for_each_choice(declared, [&](std::string_view name, const auto& declared_value) {
    using Choice = std::remove_cvref_t<decltype(declared_value)>;
    using Value = typename Choice::value_type;
    const bool is_of_hits =
        std::is_same_v<Value, scene::Root> || std::is_same_v<Value, scene::Tangent>;
    if (declared_value || !(makes_rays || is_of_hits)) return;
    for (std::size_t k = 0; k < names_of(Value{}).size(); ++k) {
      const auto value = static_cast<Value>(k);
      if (scene::name(value) == "either") continue;  // under it tangents are not judged
      Followed& one = add(name, value);
      choose(one.declared, Choice(value));
      one.is_of_hits = is_of_hits;
    }
  });
  const auto add_valid = [&](std::string text, auto member, auto value) {
    if ((*declared.valid).*member == value) return;
    all.push_back({std::move(text)});
    auto& valid = all.back().declared.valid = declared.valid;
    (*valid).*member = value;
  };
  if (declared.valid) {
    const bool has_lengths = declared.valid->t_min != 0 || std::isfinite(declared.valid->t_max);
    for (const auto unit :
         {scene::TUnit::kAbsolute, scene::TUnit::kRadius, scene::TUnit::kLength}) {
      if (has_lengths)
        add_valid("t_unit = " + std::string(scene::name(unit)), &scene::ValidRoots::unit, unit);
    }
    add_valid("t_max = infinity", &scene::ValidRoots::t_max, kInfinity);
    if (candidate.interface.rays == contract::RayForm::kEnd) {
      add_valid("t_max = 1", &scene::ValidRoots::t_max, 1.0);
    }
    add_valid("culling = none", &scene::ValidRoots::culling, scene::Culling::kNone);
    add_valid("t_min = 0", &scene::ValidRoots::t_min, 0.0);
    add_valid("t_min = -infinity", &scene::ValidRoots::t_min, -kInfinity);
  }
  if (!candidate.by_interface) return all;
  contract::for_each_choice(candidate.interface, [&](const char* name, auto& declared_value, auto) {
    using Value = std::remove_cvref_t<decltype(declared_value)>;
    // What it returns, and the inputs that it accepts, have other sentences.
    if (std::is_same_v<Value, Returns> || std::is_same_v<Value, contract::Directions> ||
        std::is_same_v<Value, contract::Windows> || std::is_same_v<Value, contract::Placement>) {
      return;
    }
    for (std::size_t k = 0; k < names_of(declared_value).size(); ++k) {
      contract::Declarations allowed;
      allowed.conventions = declared;
      allowed.interface = candidate.interface;
      choose(allowed.interface, static_cast<Value>(k));
      // Nor is there another way of calling code that always looks at a sphere's centre.
      if (allowed.interface.view == contract::View::kCentre) continue;
      if (allowed.interface != candidate.interface && contract::defects(allowed).empty()) {
        Followed& one = add(name, static_cast<Value>(k));
        one.interface = allowed.interface;
        one.is_of_hits = std::is_same_v<Value, contract::SphereSize> ||
                         std::is_same_v<Value, contract::RayForm> ||
                         std::is_same_v<Value, contract::FromInside>;
      }
    }
  });
  return all;
}

/// The candidate under these conventions, or called by this interface.
Candidate following(const Candidate& candidate, const Followed& under) {
  Candidate one = candidate;
  one.declared = under.declared.over(candidate.declared);
  if (under.interface) {
    static_cast<Functions&>(one) = candidate.by_interface(*under.interface);
    one.interface = *under.interface;
  }
  return one;
}

/// Whether the answers are the same under both conventions.
bool same_answers(Trial& one, Trial& other) {
  const Candidate& candidate = one.candidate();
  if (one.scene().camera && candidate.pixel_points && one.pixel_points() != other.pixel_points()) {
    return false;
  }
  const bool picks = one.picks();
  if (!picks && (!one.has_rays() || !other.has_rays())) return true;
  if (!picks && one.rays() != other.rays()) return false;
  // s of a picked point depends on the ray, and so on the conventions.
  const bool has_points = picks && gives_point(candidate.interface.returns);
  for (std::size_t k = 0; (picks || candidate.intersect) && k < one.scene().spheres.size(); ++k) {
    const SphereHits &hits = one.hits(k), &others = other.hits(k);
    if (!std::equal(hits.begin(), hits.end(), others.begin(), others.end(),
                    [&](const RayHit& a, const RayHit& b) {
                      return a.ray == b.ray && (has_points ? a.hit.point == b.hit.point
                                                           : a.hit.parameter == b.hit.parameter);
                    })) {
      return false;
    }
  }
  return !candidate.nearest || one.nearest() == other.nearest();
}

/// Whether the candidate finds any hit.
bool finds_hit(Trial& trial) {
  const Candidate& candidate = trial.candidate();
  if (!trial.picks() && !trial.has_rays()) return false;
  for (std::size_t k = 0; k < trial.scene().spheres.size(); ++k) {
    if ((trial.picks() || candidate.intersect) && !trial.hits(k).empty()) return true;
  }
  return candidate.nearest &&
         std::ranges::any_of(trial.nearest(), [](const auto& one) { return one.has_value(); });
}

/// The counts of a law's answers in a case.
struct Counts {
  std::uint64_t defects = 0, compared = 0;
};

/// Whether a candidate, called by this interface, gives right answers under these conventions, and
/// the same under those that are asked for. If hits depend on it, some are needed, as misses may
/// be right for any reason; nor is it enough that as many answers as were wrong are not judged
/// then.
bool is_right(const Law& law, const std::vector<Case>& cases, const Candidate& candidate,
              const Followed& under, const std::vector<Counts>& before) try {
  const auto& [rows, samples, origin, root, tangent, valid] = under.declared;
  const bool has_convention = rows || samples || origin || root || tangent || valid;
  const Candidate called = following(candidate, {{}, {}, under.interface});
  const Candidate other_candidate = following(candidate, under);
  std::uint64_t asked = 0, compared = 0, needed = 0;
  bool is_shown = !under.is_of_hits;
  for (std::size_t k = 0; k < cases.size(); ++k) {
    const auto one = rounded_case(cases[k], other_candidate.input_format()).the_case;
    if (!one || !is_problem(*one, other_candidate.declared)) continue;
    Trials declared(*one, called, {}), followed(*one, other_candidate, {});
    const Verdict verdict = followed.apply(law);
    if (verdict.count(Standing::kDefect) > 0) return false;
    if (has_convention && !same_answers(declared.of(law), followed.of(law))) return false;
    // All other laws must hold, too: the hit class may be right although the root is wrong.
    for (const Law& other : laws()) {
      if (other.judges_values && followed.apply(other).count(Standing::kDefect) > 0) return false;
    }
    asked += verdict.compared() > 0 ? 1 : 0;
    compared += verdict.compared() + before[k].defects;
    needed += before[k].compared;
    is_shown = is_shown || finds_hit(followed.of(law));
  }
  return is_shown && 2 * asked > cases.size() && (!under.is_of_hits || compared > needed);
} catch (const NoAnswer&) {
  return false;
}

/// A law's counts in these cases; no defects if the candidate fails on one of them.
std::vector<Counts> counts_of(const Law& law, const std::vector<Case>& cases,
                              const Candidate& candidate) {
  std::vector<Counts> counts;
  for (const Case& one : cases) {
    const Verdict verdict = Trials(one, candidate, {}).apply(law);
    const auto worst = verdict.worst(1);
    if (!worst.empty() && worst.front().wrong == Wrong::kFailed) return {};
    counts.push_back({verdict.count(Standing::kDefect), verdict.compared()});
  }
  return counts;
}
std::uint64_t defects_of(const std::vector<Counts>& counts) {
  std::uint64_t sum = 0;
  for (const Counts& one : counts) sum += one.defects;
  return sum;
}

/// The smallest set of conventions, one or two, that a candidate follows without declaring them, or
/// valid roots other than those that it declares, under which no answer about these cases is a
/// defect. The candidate must give the same answers when it is asked to follow them. Empty if there
/// is no such set, if there are no defects, and for renderers, which do not get conventions.
/// Domain: cases of the candidate's format (rounded_case).
std::optional<Explanation> right_under(const Law& law, const std::vector<Case>& cases,
                                       const Candidate& candidate) {
  if (candidate.image) return {};
  const std::vector<Counts> counts = counts_of(law, cases, candidate);
  const std::uint64_t defects = defects_of(counts);
  if (defects == 0) return {};
  const auto said = [&](const Followed& under) {
    return Explanation{"right under " + under.text + ", which the candidate does not declare",
                       defects, defects};
  };
  const std::vector<Followed> all = undeclared(candidate);
  for (const Followed& one : all) {
    if (is_right(law, cases, candidate, one, counts)) return said(one);
  }
  for (std::size_t one = 0; one < all.size(); ++one) {
    // Starts after both values of the first convention.
    for (std::size_t other = (one / 2 + 1) * 2; other < all.size(); ++other) {
      if (all[one].interface) continue;
      const Followed both = {all[one].text + " and " + all[other].text,
                             all[one].declared.over(all[other].declared), all[other].interface,
                             all[one].is_of_hits || all[other].is_of_hits};
      if (is_right(law, cases, candidate, both, counts)) return said(both);
    }
  }
  return {};
}

bool is_too_large(const Scene& scene) {
  return !scene.camera || scene.camera->width > kMostPixelsOfACause / scene.camera->height;
}

/// Whether squares of distances overflow: a separate defect, which other causes need not explain.
bool overflows(const Scene& scene, Precision precision) {
  return std::any_of(scene.spheres.begin(), scene.spheres.end(), [&](const auto& sphere) {
    const Vector3 T = sphere.centre - scene.camera->eye;
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
  const std::uint64_t others = defects_of(counts_of(law, not_searched, candidate));
  for (Explanation& one : found) {
    if (one.explained == 0) continue;
    one.errors += others;
    if (one.sentence == kNotNumbers) {
      one.errors = std::max(one.errors, defects_of(counts_of(law, cases, candidate)));
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
    if (auto under = right_under(law, asked, candidate)) return {*std::move(under)};
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
