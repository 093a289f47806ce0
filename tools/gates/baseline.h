#pragma once

#include <algorithm>
#include <compare>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "properties/discrepancy.h"

namespace raycheck::tools {

/// The kind of an undecided discrepancy ends with this.
inline constexpr std::string_view kUndecided = ", undecided";

/// The properties of a discrepancy that are the same in every run.
struct Identity {
  std::string law;
  std::string source;     ///< The source of its cases, or the scene's file (lasting_path).
  std::string kind;       ///< "class: missed"
  std::string place;      ///< The level of the cases, "demanding"; for a scene, "sphere 3".
  std::string candidate;  ///< A name that does not depend on its folder.
  auto operator<=>(const Identity&) const = default;

  /// Whether it is undecided. If not, it is a defect.
  bool is_undecided() const { return kind.ends_with(kUndecided); }
};

/// "class: missed", "parameter: error above its bound"
std::string kind_text(const properties::DefectKind& kind);
/// "class: missed, undecided"
std::string undecided_text(const properties::DefectKind& kind);

/// A file's path relative to the working folder, in whatever way the user wrote it. Paths outside
/// the working folder stay absolute.
std::string lasting_path(const std::string& path);

/// Discrepancies that a run could have found: those of a law on a source for a candidate.
struct Scope {
  std::string law;
  std::string source;
  std::string candidate;
  auto operator<=>(const Scope&) const = default;
};
Scope scope_of(const Identity& identity);

/// Known discrepancies, in a file with one line for each, which git can merge. Laws and sources
/// have headings, which stay even if all entries below them are fixed. So branches that fix
/// different discrepancies do not change adjacent lines.
struct Baseline {
  std::set<Identity> known;
  std::set<std::pair<std::string, std::string>> headings;  ///< By law and source.
};

/// Parses a baseline; an empty text has no entries.
/// Errors: std::invalid_argument naming the line and its fault.
Baseline parse_baseline(std::string_view text);

/// The text of a baseline. It is sorted, so that the same discrepancies give the same text.
std::string baseline_text(const Baseline& baseline);

/// The findings of a run, compared with a baseline.
struct Ratchet {
  std::string file;
  std::vector<Identity> known;    ///< Found, and in the baseline.
  std::vector<Identity> added;    ///< Found, but not in the baseline.
  std::vector<Identity> mended;   ///< In the baseline, and no longer found.
  std::vector<Identity> unasked;  ///< In the baseline, but not judged by this run.
  bool strict = false;            ///< Whether discrepancies that no longer occur fail, too.
  bool is_conclusive = true;      ///< Whether all undecided discrepancies are in the baseline.

  bool fails() const {
    const bool has_defects =
        std::ranges::any_of(added, [](const Identity& one) { return !one.is_undecided(); });
    return has_defects || (strict && !mended.empty());
  }
};

/// What a run judged and found.
struct Findings {
  std::set<Scope> asked;     ///< Everything that was judged.
  std::set<Scope> complete;  ///< The part of `asked` in which all errors were found.
  std::set<Identity> found;  ///< Defects, and undecided discrepancies.
  bool is_cut = false;       ///< Whether `found` lacks some undecided discrepancies.
};

Ratchet compare(const Baseline& baseline, const Findings& findings);

/// The baseline with the entries that were judged replaced by these findings.
Baseline updated(Baseline baseline, const Findings& findings);

}  // namespace raycheck::tools
