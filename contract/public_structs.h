#pragma once

// Converts between raycheck's structs and those of its public headers, in C
// (<raycheck/candidate.h>) and in C++ (<raycheck/scene.h>). Members have the same names.
// Enumerators have the same numbers, or numbers that are larger by one if 0 is AS_ASKED.

#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

#include "contract/declarations.h"
#include "scene/scene.h"

namespace raycheck::contract {

template <class To, class From>
To triple(const From& v) {
  return {v.x, v.y, v.z};
}
template <class To, class From>
To pixel(const From& p) {
  return {p.i, p.j};
}
template <class To, class From>
To ray(const From& r) {
  return {triple<decltype(To::origin)>(r.origin), triple<decltype(To::direction)>(r.direction)};
}
template <class To, class From>
To sphere(const From& s) {
  return {triple<decltype(To::centre)>(s.centre), s.radius};
}
template <class To>
To camera(const scene::Camera& c) {
  using Triple = decltype(To::eye);
  return {triple<Triple>(c.eye),
          triple<Triple>(c.look_at),
          triple<Triple>(c.up),
          c.near,
          c.left,
          c.right,
          c.bottom,
          c.top,
          c.width,
          c.height};
}
template <class From>
scene::Camera camera(const From& c) {
  return {triple<scene::Point3>(c.eye),
          triple<scene::Point3>(c.look_at),
          triple<scene::Vector3>(c.up),
          c.near_plane,
          {},
          c.left,
          c.right,
          c.bottom,
          c.top,
          c.width,
          c.height};
}

/// A public enumerator as one of raycheck's; `first`: the number of the first.
/// Errors: std::invalid_argument naming the field.
template <class Enum, class Public>
void from_public(Public number, const char* field, Enum& value, int first = 0) {
  const auto& names = names_of(value);
  const auto place = static_cast<std::int64_t>(number) - first;
  if (place < 0 || place >= static_cast<std::int64_t>(names.size())) {
    std::string expected;
    for (std::size_t k = 0; k < names.size(); ++k) {
      expected.append(k == 0 ? "" : ", ").append(std::to_string(first + static_cast<int>(k)));
      expected.append(" (").append(names[k]).append(")");
    }
    throw std::invalid_argument(std::string(field) + " = " + std::to_string(place + first) +
                                ": expected " + expected);
  }
  value = static_cast<Enum>(place);
}
template <class Enum, class Public>
void from_public(Public number, const char* field, std::optional<Enum>& value) {
  value.reset();
  if (static_cast<int>(number) != 0) from_public(number, field, value.emplace(), 1);
}

template <class From>
scene::ValidRoots valid_roots(const From& v) {
  scene::ValidRoots valid = {.t_min = v.t_min, .t_max = v.t_max};
  from_public(v.ends, "ends", valid.ends);
  from_public(v.unit, "unit", valid.unit);
  from_public(v.culling, "culling", valid.culling);
  return valid;
}
template <class To>
To valid_roots(const scene::ValidRoots& v) {
  return {v.t_min, v.t_max, static_cast<decltype(To::ends)>(v.ends),
          static_cast<decltype(To::unit)>(v.unit), static_cast<decltype(To::culling)>(v.culling)};
}

/// Without the valid roots, which are in another struct in C.
template <class From>
DeclaredConventions declared_conventions(const From& c) {
  DeclaredConventions declared;
  from_public(c.rows, "rows", declared.rows);
  from_public(c.samples, "samples", declared.samples);
  from_public(c.origin, "origin", declared.origin);
  from_public(c.root, "root", declared.root);
  from_public(c.tangent, "tangent", declared.tangent);
  return declared;
}
template <class To>
To conventions(const scene::Conventions& c) {
  const auto seen = [](auto value) { return static_cast<int>(value) + 1; };
  return {static_cast<decltype(To::rows)>(seen(c.rows)),
          static_cast<decltype(To::samples)>(seen(c.samples)),
          static_cast<decltype(To::origin)>(seen(c.origin)),
          static_cast<decltype(To::root)>(seen(c.root)),
          static_cast<decltype(To::tangent)>(seen(c.tangent))};
}

/// What a candidate's struct declares, built for a version of the public header. Errors:
/// std::invalid_argument naming the member.
template <class From, class Conventions, class Roots>
Declarations declarations(const From& from, const Conventions& fixed, const Roots& roots,
                          std::uint32_t version) {
  Declarations declared;
  auto& valid = declared.conventions.valid;
  declared.conventions = declared_conventions(fixed);
  valid = scene::ValidRoots{};
  if (version >= 2) {
    std::optional<Level> level;
    from_public(from.level, "level", level);
    declared.level = level.value_or(declared.level);
    declared.lengths.smallest = from.smallest_length;
    if (from.largest_length != 0) declared.lengths.largest = from.largest_length;
  }
  if (version >= 3) {
    from_public(from.precision, "precision", declared.precision);
    RootsOf of = RootsOf::kUsual;
    from_public(from.roots, "roots", of);
    if (of == RootsOf::kDeclared) valid = valid_roots(roots);
    if (of == RootsOf::kScene) valid.reset();
  }
  if (version >= 4) {
    from_public(from.directions, "directions", declared.interface.directions);
    from_public(from.returns, "returns", declared.interface.returns);
  }
  if constexpr (requires { from.contract; }) {
    if (version >= 5 && from.contract != nullptr) declare_all(from.contract, declared);
  }
  return declared;
}

}  // namespace raycheck::contract
