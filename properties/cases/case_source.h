#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "properties/case.h"

namespace raycheck::properties {

/// The quantity that the severity of a source sets, in powers of `base`. Severity 0 is ordinary.
struct SeverityRange {
  std::string_view meaning;  ///< Of severity: "log10 of the distance over the radius".
  int base;                  ///< 10 or 2
  int highest;               ///< Severities are 0..highest.
  int ordinary;              ///< The highest ordinary severity.
  int demanding;             ///< The highest demanding severity; higher ones are extreme.

  /// The highest severity of a level.
  int highest_of(Level level) const;
  Level level_of(int severity) const;
};

/// A source of random cases: for every seed a valid case, the same on every machine.
struct CaseSource {
  std::string_view name;
  std::string_view sentence;
  bool has_camera;
  std::optional<SeverityRange> severities;
  /// Domain: one of `severities`. Ignored if there are none.
  Case (*make)(int severity, std::uint64_t seed);
  Level level = Level::kOrdinary;  ///< Only for sources without severities.
};

/// The most severities of a source that are judged.
inline constexpr int kMostSeverities = 65;

/// Every source, in the order of reports: those with a camera first.
std::span<const CaseSource> case_sources();

/// The source of this name, or null.
const CaseSource* find_case_source(std::string_view name);

/// Severities first..last: all of them, or at most `most`, evenly spaced except for the last, which
/// is always included.
/// Domain: first <= last, most >= 1.
std::vector<int> some_severities(int first, int last, int most = kMostSeverities);

/// A source, and optionally one severity of it.
struct ChosenSource {
  const CaseSource* source = nullptr;
  std::optional<int> severity = {};

  /// The case of a seed. If no severity is chosen, the seed also determines the severity.
  Case make(std::uint64_t seed) const;
  /// The severity of a seed's case; 0 for a source without severities.
  int severity_of(std::uint64_t seed) const;
  std::string name() const;  ///< "SOURCE" or "SOURCE@SEVERITY"
  /// Hashes the name by FNV-1a: the same on every machine, unlike std::hash.
  std::uint64_t hash() const;
  bool operator==(const ChosenSource&) const = default;
  /// The level of the chosen severity; if none is chosen, of the highest severity, or of a source
  /// without severities.
  Level level() const;
};

/// Chooses one of several sources, all equally likely, by a random number (rendezvous hashing of
/// number and name; Thaler and Ravishankar 1998). An added source takes its share of the numbers;
/// every other number keeps its source.
/// Domain: at least one source.
const ChosenSource& chosen_by(std::span<const ChosenSource> sources, std::uint64_t number);

/// Reads a ChosenSource's name. Throws std::invalid_argument, which says which part is wrong and
/// which severities exist.
ChosenSource chosen_source(std::string_view name);

}  // namespace raycheck::properties
