#ifndef RAYCHECK_TOOLS_GATES_BASELINE_H_
#define RAYCHECK_TOOLS_GATES_BASELINE_H_

#include <compare>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "properties/verdict.h"

namespace raycheck::tools {

/// What stays the same of a discrepancy from run to run, whatever its numbers are.
struct Identity {
  std::string law;
  std::string source;  ///< Of cases; or the scene's file.
  std::string kind;    ///< "class: missed"
  std::string place;   ///< "demanding", the level of the cases; of a scene "sphere 3".
  std::string candidate;
  auto operator<=>(const Identity&) const = default;
};

/// "class: missed", "parameter: error above its bound"
std::string kind_text(const properties::DefectKind& kind);

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

  bool fails() const { return !added.empty() || (strict && !mended.empty()); }
};

/// What a run asked, and what it found.
struct Findings {
  std::set<Scope> asked;     ///< What was judged.
  std::set<Scope> complete;  ///< Of that, all that is wrong is among what was found.
  std::set<Identity> found;
};

Ratchet compare(const Baseline& baseline, const Findings& findings);

/// The baseline that knows what was found: of what was not asked it stays as it is.
Baseline updated(Baseline baseline, const Findings& findings);

}  // namespace raycheck::tools

#endif  // RAYCHECK_TOOLS_GATES_BASELINE_H_
