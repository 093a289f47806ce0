#include "properties/mistakes/undeclared.h"

#include <algorithm>
#include <limits>
#include <string_view>
#include <utility>

namespace raycheck::properties {
namespace {

/// A convention that a candidate may follow even if the scene says otherwise, another declaration
/// of the valid roots, or another interface.
struct Followed {
  std::string text;
  DeclaredConventions declared;
  std::optional<contract::Interface> interface = {};
};

template <class Value>
void add(std::string_view name, std::optional<Value> DeclaredConventions::*member,
         const DeclaredConventions& declared, std::vector<Followed>& all) {
  if (declared.*member) return;
  for (std::size_t k = 0; k < names_of(Value{}).size(); ++k) {
    const auto value = static_cast<Value>(k);
    if (scene::name(value) == "either") continue;  // under it tangents are not judged
    Followed one{std::string(name) + " = " + std::string(scene::name(value)), {}};
    one.declared.*member = value;
    all.push_back(std::move(one));
  }
}

std::vector<Followed> undeclared(const Candidate& candidate) {
  const DeclaredConventions& declared = candidate.declared;
  std::vector<Followed> all;
  if (candidate.pixel_points || candidate.pixel_rays || candidate.focal_rays) {
    add("rows", &DeclaredConventions::rows, declared, all);
    add("samples", &DeclaredConventions::samples, declared, all);
    add("origin", &DeclaredConventions::origin, declared, all);
  }
  add("root", &DeclaredConventions::root, declared, all);
  add("tangent", &DeclaredConventions::tangent, declared, all);
  const auto add_valid = [&](std::string text, auto member, auto value) {
    Followed one{std::move(text), {}};
    one.declared.valid = declared.valid;
    if ((*one.declared.valid).*member == value) return;
    (*one.declared.valid).*member = value;
    all.push_back(std::move(one));
  };
  if (declared.valid) {
    for (const auto unit :
         {scene::TUnit::kAbsolute, scene::TUnit::kRadius, scene::TUnit::kLength}) {
      add_valid("t_unit = " + std::string(scene::name(unit)), &scene::ValidRoots::unit, unit);
    }
    add_valid("t_max = infinity", &scene::ValidRoots::t_max,
              std::numeric_limits<double>::infinity());
    if (candidate.interface.rays == contract::RayForm::kEnd) {
      add_valid("t_max = 1", &scene::ValidRoots::t_max, 1.0);
    }
    add_valid("culling = none", &scene::ValidRoots::culling, scene::Culling::kNone);
    add_valid("t_min = 0", &scene::ValidRoots::t_min, 0.0);
    add_valid("t_min = -infinity", &scene::ValidRoots::t_min,
              -std::numeric_limits<double>::infinity());
  }
  if (!candidate.by_interface) return all;
  contract::Declarations allowed;
  allowed.conventions = declared;
  contract::for_each_choice(candidate.interface, [&](const char* name, auto& declared_value, auto) {
    using Value = std::remove_cvref_t<decltype(declared_value)>;
    // What it returns, and the inputs that it accepts, have other sentences.
    if (std::is_same_v<Value, Returns> || std::is_same_v<Value, contract::Directions> ||
        std::is_same_v<Value, contract::Windows> || std::is_same_v<Value, contract::Placement>) {
      return;
    }
    for (std::size_t k = 0; k < names_of(declared_value).size(); ++k) {
      const auto other = static_cast<Value>(k);
      Followed one{std::string(name) + " = " + std::string(scene::name(other)), {}};
      contract::for_each_choice(one.interface.emplace(candidate.interface),
                                [&](auto /*name*/, auto& value, auto) {
                                  if constexpr (std::is_same_v<decltype(value), Value&>)
                                    value = other;
                                });
      allowed.interface = *one.interface;
      if (other != declared_value && contract::defects(allowed).empty()) {
        all.push_back(std::move(one));
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
  if (!one.has_rays() || !other.has_rays()) return true;
  if (one.rays() != other.rays()) return false;
  for (std::size_t k = 0; candidate.intersect && k < one.scene().spheres.size(); ++k) {
    const SphereHits &hits = one.hits(k), &others = other.hits(k);
    if (!std::equal(hits.begin(), hits.end(), others.begin(), others.end(),
                    [](const RayHit& a, const RayHit& b) {
                      return a.ray == b.ray && a.hit.parameter == b.hit.parameter;
                    })) {
      return false;
    }
  }
  return !candidate.nearest || one.nearest() == other.nearest();
}

/// Whether a candidate, called by this interface, gives right answers under these conventions, and
/// the same under those that are asked for.
bool is_right(const Law& law, const std::vector<Case>& cases, const Candidate& candidate,
              const Followed& under) try {
  const auto& [rows, samples, origin, root, tangent, valid] = under.declared;
  const bool has_convention = rows || samples || origin || root || tangent || valid;
  const Candidate called = following(candidate, {{}, {}, under.interface});
  const Candidate other_candidate = following(candidate, under);
  std::uint64_t asked = 0;
  for (const Case& given : cases) {
    const auto one = rounded_case(given, other_candidate.input_format()).the_case;
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
  }
  return 2 * asked > cases.size();
} catch (const NoAnswer&) {
  return false;
}

}  // namespace

std::uint64_t count_defects(const Law& law, const std::vector<Case>& cases,
                            const Candidate& candidate) {
  std::uint64_t count = 0;
  for (const Case& one : cases) {
    const Verdict verdict = Trials(one, candidate, {}).apply(law);
    const auto worst = verdict.worst(1);
    if (!worst.empty() && worst.front().wrong == Wrong::kFailed) return 0;
    count += verdict.count(Standing::kDefect);
  }
  return count;
}

std::optional<RightUnder> right_under(const Law& law, const std::vector<Case>& cases,
                                      const Candidate& candidate) {
  if (candidate.image) return {};
  const std::uint64_t defects = count_defects(law, cases, candidate);
  if (defects == 0) return {};
  const std::vector<Followed> all = undeclared(candidate);
  for (const Followed& one : all) {
    if (is_right(law, cases, candidate, one)) return RightUnder{one.text, defects};
  }
  for (std::size_t one = 0; one < all.size(); ++one) {
    // Starts after both values of the first convention.
    for (std::size_t other = (one / 2 + 1) * 2; other < all.size(); ++other) {
      if (all[one].interface) continue;
      const Followed both = {all[one].text + " and " + all[other].text,
                             all[one].declared.over(all[other].declared), all[other].interface};
      if (is_right(law, cases, candidate, both)) return RightUnder{both.text, defects};
    }
  }
  return {};
}

}  // namespace raycheck::properties
