#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "properties/case.h"
#include "properties/level.h"

namespace raycheck::properties {

/// What makes the cases of a family harder: the one thing that severity sets, in powers of `base`.
/// Severity 0 is ordinary.
struct Dial {
  std::string_view meaning;  ///< What severity counts: "log10 of the distance over the radius".
  int base;                  ///< 10 or 2
  int highest;               ///< Severities are 0..highest.
  int ordinary;              ///< Severities 0..ordinary are ordinary,
  int demanding;             ///< those beyond up to this are demanding, the others extreme.

  /// The highest severity of a level.
  int highest_of(Level level) const;
  Level level_of(int severity) const;
};

/// Where random cases come from: every valid case by its seed, the same on every machine. A source
/// with a dial is a stress family.
struct CaseSource {
  std::string_view name;
  std::string_view sentence;
  bool has_camera;
  std::optional<Dial> dial;
  /// Domain: a severity of the dial; a source without one ignores it.
  Case (*make)(int severity, std::uint64_t seed);
  Level level = Level::kOrdinary;  ///< Of a source without a dial.
};

/// Longer ranges of severities are judged at some of them.
inline constexpr int kMostSeverities = 65;

/// Every source, in the order of reports: those with a camera first.
std::span<const CaseSource> case_sources();

/// The source of that name, or null.
const CaseSource* find_case_source(std::string_view name);

/// A case of a severity that the seed chooses, each as likely as the other.
Case any_case(const CaseSource& source, std::uint64_t seed);

/// Severities first..last: all of them, or at most so many, evenly spaced but for the last, which
/// is always among them. Domain: first <= last, most >= 1.
std::vector<int> some_severities(int first, int last, int most = kMostSeverities);

/// A source, and perhaps the one severity that is wanted of it.
struct ChosenSource {
  const CaseSource* source = nullptr;
  std::optional<int> severity = {};

  Case make(std::uint64_t seed) const;
  /// Of the case that the seed makes; 0 of a source without a dial.
  int severity_of(std::uint64_t seed) const;
  std::string name() const;  ///< "SOURCE" or "SOURCE@SEVERITY"
  /// Of the name, by FNV-1a: the same on every machine, as std::hash is not.
  std::uint64_t hash() const;
  /// Of its severity, or of a source without a dial; of one with a dial as a whole the dial's last.
  Level level() const;
};

/// The one of several sources that a random number chooses, each as likely as the others (by
/// rendezvous hashing of number and name; Thaler and Ravishankar 1998). A source more takes over
/// its share of the numbers, and leaves every other number the source that it had.
/// Domain: at least one source.
const ChosenSource& chosen_by(std::span<const ChosenSource> sources, std::uint64_t number);

/// Reads a ChosenSource's name. Throws std::invalid_argument saying which part of it is wrong, and
/// which severities there are.
ChosenSource chosen_source(std::string_view name);

}  // namespace raycheck::properties
