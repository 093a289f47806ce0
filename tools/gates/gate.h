#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "properties/failures.h"
#include "tools/gates/baseline.h"
#include "tools/report/json.h"

namespace raycheck::tools {

/// The outcome of one check of a gate.
enum class GateOutcome {
  kPassed,
  kFailed,
  kKnown,         ///< It fails, and the baseline contains the failure.
  kInconclusive,  ///< Too little was judged or decided for it to pass.
  kLeftOut,       ///< There was nothing to judge.
};
inline constexpr std::size_t kGateOutcomes = 5;
inline constexpr std::array<std::string_view, kGateOutcomes> kGateOutcomeNames = {
    "passed", "failed", "known", "inconclusive", "left out"};
constexpr std::string_view name(GateOutcome outcome) {
  return kGateOutcomeNames[static_cast<std::size_t>(outcome)];
}

/// One check of a gate: a law on the cases of a source, or a quantity of a scene.
struct GateCheck {
  std::string candidate;
  std::string name;  ///< Unique among the candidate's checks: "class/tangency".
  GateOutcome outcome = GateOutcome::kPassed;
  std::string summary = {};  ///< Why it does not pass, in one line.
  std::string text = {};     ///< The details of a failed or undecided check.
  std::vector<Identity> defects = {};
  /// The line where the candidate first crashed or threw.
  std::optional<properties::CodeLine> line = {};
};

/// A report for continuous integration.
struct Gate {
  std::string command;  ///< "check" or "properties"
  std::string about;    ///< The scene, or the number of cases; one line.
  std::vector<GateCheck> checks;
  /// The source files of candidates, by the candidate's name.
  std::map<std::string, std::string> sources;
  std::optional<Ratchet> ratchet;  ///< The comparison with a baseline, if there is one.
  Findings findings;               ///< For comparison with a baseline.

  std::uint64_t count(GateOutcome outcome) const;
};

/// Where viewers should show a check: the line at which the candidate crashed; if that is not
/// known, line 1 of its source; empty if that is not known either.
std::optional<properties::CodeLine> line_of(const Gate& gate, const GateCheck& check);

/// The undecided discrepancies of a check.
struct LeftUndecided {
  std::uint64_t answers = 0;
  std::vector<Identity> kept;
  bool is_cut = false;  ///< Whether some were not kept, so that a baseline cannot contain all.
};
/// Adds a check with its defects and sets its outcome, kKnown if the baseline contains all its
/// defects and undecided discrepancies. If it is inconclusive, adds the reason.
GateCheck& add_check(Gate& gate, GateCheck check, const LeftUndecided& undecided);

/// Whether the baseline contains a discrepancy.
bool is_known(const Identity& one, const std::optional<Ratchet>& ratchet);

/// Completes a gate: adds a failing check if the run was interrupted or everything was left out,
/// and makes names unique.
void complete(Gate& gate, bool was_interrupted);

/// The number of checks of each candidate by outcome.
std::map<std::string, std::array<std::size_t, kGateOutcomes>> outcomes_by_candidate(
    const Gate& gate);
/// "12 passed, 1 failed, 2 left out"
std::string outcomes_text(const Gate& gate);

/// The comparison of a run with a baseline, in lines, for reports as text.
std::string ratchet_text(const Ratchet& ratchet);
/// The comparison as JSON; null if there is no baseline.
Json ratchet_json(const std::optional<Ratchet>& ratchet);

/// A format for continuous integration: its name for --format and --report, and its writer.
/// docs/ci.md cites the documentation of the services that read it.
struct GateFormat {
  std::string_view name;
  std::string (*write)(const Gate& gate);
  bool is_executed = false;  ///< Lines that GitHub's workflow log executes.
};
/// Every format, in the order of --help (formats.cpp).
std::span<const GateFormat> gate_formats();

/// GitHub accepts step summaries of at most 1 MiB.
inline constexpr std::size_t kMostMarkdownBytes = 1'000'000;

}  // namespace raycheck::tools
