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

/// The end of the kind of an undecided discrepancy.
inline constexpr std::string_view kUndecided = ", undecided";

/// The properties of a discrepancy that are the same in every run.
struct Identity {
  std::string law;
  std::string source;     ///< Of its cases; or the scene's file (lasting_path).
  std::string kind;       ///< "class: missed"
  std::string place;      ///< "demanding", the level of the cases; for a scene "sphere 3".
  std::string candidate;  ///< Its name, which does not depend on its folder.
  auto operator<=>(const Identity&) const = default;

  /// Whether it is undecided, rather than a defect.
  bool is_undecided() const { return kind.ends_with(kUndecided); }
};

/// "class: missed", "parameter: error above its bound"
std::string kind_text(const properties::DefectKind& kind);
/// "class: missed, undecided"
std::string undecided_text(const properties::DefectKind& kind);

/// A file's path relative to the working folder, however it is typed; paths outside that stay
/// absolute.
std::string lasting_path(const std::string& path);

/// Which discrepancies a run could have found.
struct Scope {
  std::string law;
  std::string source;
  std::string candidate;
  auto operator<=>(const Scope&) const = default;
};
Scope scope_of(const Identity& identity);

/// Known discrepancies, in a file with one line each that git can merge: laws and sources have
/// headings, which stay when all entries below them are fixed, so that branches that fix different
/// discrepancies do not change adjacent lines.
struct Baseline {
  std::set<Identity> known;
  std::set<std::pair<std::string, std::string>> headings;  ///< By law and source.
};

/// Reads such a file; an empty one has no entries.
/// Errors: std::invalid_argument naming the line and what is wrong with it.
Baseline parse_baseline(std::string_view text);

/// The text of the file: sorted, the same for the same discrepancies.
std::string baseline_text(const Baseline& baseline);

/// The findings of a run, compared with a baseline.
struct Ratchet {
  std::string file;
  std::vector<Identity> known;    ///< Found, and in the baseline.
  std::vector<Identity> added;    ///< Found, but not in the baseline.
  std::vector<Identity> mended;   ///< In the baseline, and no longer found.
  std::vector<Identity> unasked;  ///< In the baseline, but not judged by this run.
  bool strict = false;            ///< Mended ones fail, too.
  bool is_conclusive = true;      ///< All undecided discrepancies are known.

  bool fails() const {
    const bool has_defects =
        std::ranges::any_of(added, [](const Identity& one) { return !one.is_undecided(); });
    return has_defects || (strict && !mended.empty());
  }
};

/// What a run judged, and what it found.
struct Findings {
  std::set<Scope> asked;     ///< What was judged.
  std::set<Scope> complete;  ///< The part of `asked` in which all errors were found.
  std::set<Identity> found;  ///< Defects, and undecided discrepancies.
  bool is_cut = false;       ///< `found` lacks some undecided ones.
};

Ratchet compare(const Baseline& baseline, const Findings& findings);

/// The baseline with these findings; entries that were not judged stay.
Baseline updated(Baseline baseline, const Findings& findings);

}  // namespace raycheck::tools
