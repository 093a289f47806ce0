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
  kKnown,         ///< Fails, and the baseline has it.
  kInconclusive,  ///< Too little was judged, or decided, to pass.
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
  std::string name;  ///< Unique among those of the candidate: "class/tangency".
  GateOutcome outcome = GateOutcome::kPassed;
  std::string summary = {};  ///< Why it does not pass: one line.
  std::string text = {};     ///< The details of a failed or undecided check.
  std::vector<Identity> defects = {};
  std::optional<properties::CodeLine> line = {};  ///< Where the candidate first crashed or threw.
};

/// A report for continuous integration.
struct Gate {
  std::string command;  ///< "check" or "properties"
  std::string about;    ///< The scene, or the number of cases. One line.
  std::vector<GateCheck> checks;
  std::map<std::string, std::string> sources;  ///< Of candidates that are files: by name.
  std::optional<Ratchet> ratchet;              ///< If there is a baseline.
  Findings findings;                           ///< To be compared with a baseline.

  std::uint64_t count(GateOutcome outcome) const;
};

/// Where viewers should show a check: the line at which the candidate crashed, else line 1 of its
/// source; empty if neither is known.
std::optional<properties::CodeLine> line_of(const Gate& gate, const GateCheck& check);

/// The undecided discrepancies of a check.
struct LeftUndecided {
  std::uint64_t answers = 0;
  std::vector<Identity> kept;
  bool is_cut = false;  ///< Some were not kept, so that a baseline cannot have all.
};
/// Adds a check with its defects and sets its outcome: known if the baseline has all that was
/// found. If it is inconclusive, adds the reason.
GateCheck& add_check(Gate& gate, GateCheck check, const LeftUndecided& undecided);

/// Whether the baseline has a discrepancy.
bool is_known(const Identity& one, const std::optional<Ratchet>& ratchet);

/// Completes a gate: adds checks that fail if it was interrupted or all was left out, and makes
/// names unique.
void complete(Gate& gate, bool was_interrupted);

/// The number of checks of each candidate by outcome.
std::map<std::string, std::array<std::size_t, kGateOutcomes>> outcomes_by_candidate(
    const Gate& gate);
/// "12 passed, 1 failed, 2 left out"
std::string outcomes_text(const Gate& gate);

/// The comparison of a run with a baseline, in lines, for people.
std::string ratchet_text(const Ratchet& ratchet);
/// The same as JSON; null without a baseline.
Json ratchet_json(const std::optional<Ratchet>& ratchet);

/// A format for continuous integration: its name for --format and --report, and its writer.
/// docs/ci.md cites the documentation of the readers.
struct GateFormat {
  std::string_view name;
  std::string (*write)(const Gate& gate);
  bool is_executed = false;  ///< Lines that GitHub's workflow log executes.
};
/// Every format, in the order of --help (formats.cpp).
std::span<const GateFormat> gate_formats();

/// GitHub accepts summaries of a step up to 1 MiB.
inline constexpr std::size_t kMostMarkdownBytes = 1'000'000;

}  // namespace raycheck::tools
