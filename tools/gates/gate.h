#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "properties/code_line.h"
#include "tools/gates/baseline.h"

namespace raycheck::tools {

/// What one check of a gate comes to.
enum class GateOutcome {
  kPassed,
  kFailed,
  kKnown,         ///< Fails as the baseline says that it does.
  kInconclusive,  ///< Too little was judged, or decided, to say that it passes.
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
  std::string summary = {};  ///< Of what is not passed, why: one line.
  std::string text = {};     ///< Of what failed, all there is to say, in lines.
  std::vector<Identity> defects = {};
  std::optional<properties::CodeLine> line = {};  ///< At which the candidate first died or threw.
};

/// Where a candidate's own source lies.
struct SourceFile {
  std::string candidate;
  std::string path;
};

/// A report as continuous integration reads it.
struct Gate {
  std::string command;  ///< "check" or "properties"
  std::string about;    ///< What was judged: the scene, or how many cases. One line.
  std::vector<GateCheck> checks;
  std::vector<SourceFile> sources;  ///< Of the candidates that are files.
  std::optional<Ratchet> ratchet;   ///< Where a baseline was given.
  Findings findings;                ///< What a baseline holds of it.
  /// Makes a PNG file of where the scene shows it; or empty.
  std::function<std::string()> picture;

  std::uint64_t count(GateOutcome outcome) const;
};

/// Where readers are to show a check: the line at which the candidate died, else line 1 of its
/// source; empty where neither is known.
std::optional<properties::CodeLine> line_of(const Gate& gate, const GateCheck& check);

/// What a check leaves undecided.
struct LeftUndecided {
  std::uint64_t answers = 0;
  std::vector<Identity> kept;
  bool is_cut = false;  ///< Not all of it was kept, so that no baseline knows it.
};
/// Adds a check whose defects are known, with what it comes to: known where the baseline has all
/// that was found. Says why it is inconclusive where it is.
GateCheck& add_check(Gate& gate, GateCheck check, const LeftUndecided& undecided);

/// Whether the baseline has a discrepancy.
bool is_known(const Identity& one, const std::optional<Ratchet>& ratchet);

/// What every gate has beside its checks: that it came to its end, that not all was left out, and
/// names that are unique.
void complete(Gate& gate, bool was_interrupted);

/// "12 passed, 1 failed, 2 left out"
std::string outcomes_text(const Gate& gate);

}  // namespace raycheck::tools
