#pragma once

#include <algorithm>
#include <compare>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "properties/verdict.h"

namespace raycheck::tools {

/// How the kind of a discrepancy ends that is left undecided.
inline constexpr std::string_view kUndecided = ", undecided";

/// What stays the same of a discrepancy from run to run, whatever its numbers are.
struct Identity {
  std::string law;
  std::string source;     ///< Of cases; or the scene's file (lasting_path).
  std::string kind;       ///< "class: missed"
  std::string place;      ///< "demanding", the level of the cases; of a scene "sphere 3".
  std::string candidate;  ///< What it is called wherever it lies.
  auto operator<=>(const Identity&) const = default;

  /// Whether it is none that is held against the candidate, but one that is left undecided.
  bool is_undecided() const { return kind.ends_with(kUndecided); }
};

/// "class: missed", "parameter: error above its bound"
std::string kind_text(const properties::DefectKind& kind);
/// "class: missed, undecided"
std::string undecided_text(const properties::DefectKind& kind);

/// A file's path from the working folder, however it is typed; of an absolute one that lies
/// elsewhere, itself.
std::string lasting_path(const std::string& path);

/// Which discrepancies a run could have found.
struct Scope {
  std::string law;
  std::string source;
  std::string candidate;
  auto operator<=>(const Scope&) const = default;
};
Scope scope_of(const Identity& identity);

/// Known discrepancies, as a file of a line each that git merges: laws and sources have headings,
/// which stay when all below them are mended, so that two branches that mend different ones change
/// no neighbouring lines.
struct Baseline {
  std::set<Identity> known;
  std::set<std::pair<std::string, std::string>> headings;  ///< Of law and source.
};

/// Reads such a file; an empty one knows nothing.
/// Errors: std::invalid_argument naming the line and what is wrong with it.
Baseline parse_baseline(std::string_view text);

/// The file: sorted, the same for the same discrepancies.
std::string baseline_text(const Baseline& baseline);

/// What a run found, held against a baseline.
struct Ratchet {
  std::string file;
  std::vector<Identity> known;    ///< Found, as the baseline has it.
  std::vector<Identity> added;    ///< Found, and not in the baseline.
  std::vector<Identity> mended;   ///< In the baseline, and no longer wrong.
  std::vector<Identity> unasked;  ///< In the baseline, of what this run did not judge.
  bool strict = false;            ///< What is mended fails, too.
  bool is_conclusive = true;      ///< Whatever is undecided is known.

  bool fails() const {
    const bool has_defects = std::any_of(added.begin(), added.end(),
                                         [](const Identity& one) { return !one.is_undecided(); });
    return has_defects || (strict && !mended.empty());
  }
};

/// What a run asked, and what it found.
struct Findings {
  std::set<Scope> asked;     ///< What was judged.
  std::set<Scope> complete;  ///< Of that, all that is wrong is among what was found.
  std::set<Identity> found;  ///< What is held against a candidate, or is undecided.
  bool is_cut = false;       ///< What is undecided is not all among what was found.
};

Ratchet compare(const Baseline& baseline, const Findings& findings);

/// The baseline that knows what was found: of what was not asked it stays as it is.
Baseline updated(Baseline baseline, const Findings& findings);

}  // namespace raycheck::tools
