#pragma once

// Reports for continuous integration: each view in the file of its name. docs/ci.md cites the
// documentation of the readers.

#include <cstddef>
#include <string>

#include "tools/gates/gate.h"
#include "tools/report/json.h"
#include "tools/report/view.h"

namespace raycheck::tools {

/// GitLab accepts files of unit tests up to 30 MB.
inline constexpr std::size_t kMostJunitBytes = 29'000'000;
/// JUnit XML, as read by Jenkins, GitLab and tools for GitHub: a suite per candidate, a test per
/// check, with unique names. Inconclusive checks are errors, known or left out ones skipped. Texts
/// are cut if the file would exceed kMostJunitBytes.
std::string junit(const Gate& gate);

/// GitHub accepts summaries of a step up to 1 MiB.
inline constexpr std::size_t kMostMarkdownBytes = 1'000'000;
/// Markdown: a table of what was judged, then what failed, as far as there is room.
std::string markdown(const Gate& gate);

/// A view of a report: what `kWrite` writes of the gate that `kGateOf` makes of it.
template <auto kWrite, auto kGateOf, class Report>
std::string gate_view(const Report& report, const ViewOptions& /*options*/) {
  return kWrite(kGateOf(report));
}

/// The comparison of a run with a baseline, in lines, for people.
std::string ratchet_text(const Ratchet& ratchet);
/// The same as JSON; null where there is no baseline.
Json ratchet_json(const std::optional<Ratchet>& ratchet);

/// GitHub shows no more annotations of a step than these.
inline constexpr std::size_t kMostAnnotations = 10;
/// GitHub's workflow commands: an annotation for each failure, at its line where that is known; the
/// last one counts those left.
std::string github(const Gate& gate);

/// GitLab's code quality: a JSON list, an entry for each defect that the baseline does not have.
std::string gitlab_codequality(const Gate& gate);

}  // namespace raycheck::tools
