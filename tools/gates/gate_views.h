#pragma once

// How continuous integration is told: each view in the file of its name. docs/ci.md cites what its
// readers say that they read.

#include <cstddef>
#include <string>
#include <type_traits>

#include "tools/gates/gate.h"
#include "tools/report/json.h"
#include "tools/report/view.h"

namespace raycheck::tools {

/// GitLab takes no larger file of unit tests than 30 MB.
inline constexpr std::size_t kMostJunitBytes = 29'000'000;
/// JUnit's XML, as Jenkins, GitLab and GitHub's readers take it: a suite a candidate, a test a
/// check, whose name is unique. What is inconclusive is an error, what is known or left out
/// skipped. Texts are cut where the file would grow beyond kMostJunitBytes.
std::string junit(const Gate& gate);

/// GitHub takes no larger summary of a step than 1 MiB.
inline constexpr std::size_t kMostMarkdownBytes = 1'000'000;
/// Markdown: a table of what was judged, then what failed, as far as there is room. The picture is
/// within it; or linked, where an address is given.
std::string markdown(const Gate& gate, const std::string& picture_link = {});

/// A view of a report: what `kWrite` writes of the gate that `kGateOf` makes of it.
template <auto kWrite, auto kGateOf, class Report>
std::string gate_view(const Report& report, const ViewOptions& options) {
  const Gate gate = kGateOf(report);
  if constexpr (std::is_invocable_v<decltype(kWrite), const Gate&, const std::string&>) {
    return kWrite(gate, options.picture_link);
  } else {
    return kWrite(gate);
  }
}

/// What a baseline says of a run, in lines, for people.
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
