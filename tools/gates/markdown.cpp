#include <fmt/core.h>

#include <algorithm>
#include <string_view>

#include "scene/text.h"
#include "tools/gates/gate_views.h"

namespace raycheck::tools {
namespace {

/// Text inside a line of Markdown, without any markup.
std::string inline_text(std::string_view text) {
  constexpr std::string_view kActs = "\\`*_{}[]()#+-.!|<>&~@:$^=";
  std::string shown;
  for (const char c : scene::visible_line(text)) {
    if (c == '<') {
      shown += "&lt;";
    } else if (c == '&') {
      shown += "&amp;";
    } else {
      if (kActs.find(c) != std::string_view::npos) shown += '\\';
      shown += c;
    }
  }
  return shown;
}

/// Text as code, between fences longer than any inside it.
std::string fenced(std::string_view text) {
  const std::string shown = scene::visible(text);
  std::size_t longest = 2, run = 0;
  for (const char c : shown) {
    run = c == '`' ? run + 1 : 0;
    longest = std::max(longest, run);
  }
  const std::string fence(longest + 1, '`');
  return fmt::format("{0}text\n{1}{2}{0}\n", fence, shown, shown.ends_with('\n') ? "" : "\n");
}

std::string failure_of(const GateCheck& check) {
  return fmt::format("\n#### {}\n\n{} \u2014 {}\n\n{}", inline_text(check.name),
                     inline_text(check.candidate), inline_text(check.summary),
                     fenced(check.text.empty() ? check.summary : check.text));
}

std::string table_of(const Gate& gate) {
  std::string head = "| candidate |", line = "|:---|", rows;
  for (const std::string_view outcome : kGateOutcomeNames) {
    head += fmt::format(" {} |", outcome);
    line += "---:|";
  }
  for (const auto& [candidate, by_outcome] : outcomes_by_candidate(gate)) {
    rows += fmt::format("| {} |", inline_text(candidate));
    for (const std::size_t count : by_outcome) rows += fmt::format(" {} |", count);
    rows += "\n";
  }
  return fmt::format("{}\n{}\n{}", head, line, rows);
}

std::string ratchet_part(const Ratchet& ratchet) {
  std::string text =
      fmt::format("\nHeld against {}: {} known, {} new, {} mended.\n", inline_text(ratchet.file),
                  ratchet.known.size(), ratchet.added.size(), ratchet.mended.size());
  for (const Identity& one : ratchet.mended) {
    text += fmt::format("- mended: {}/{}, {}, at {}, {}\n", inline_text(one.law),
                        inline_text(one.source), inline_text(one.kind), inline_text(one.place),
                        inline_text(one.candidate));
  }
  return text;
}

}  // namespace

std::string markdown(const Gate& gate) {
  const bool fails = gate.count(GateOutcome::kFailed) > 0;
  std::string text = fmt::format("### raycheck {}: {}\n\n{}: {}.\n\n{}", gate.command,
                                 fails ? "discrepancies" : "no new discrepancy",
                                 inline_text(gate.about), outcomes_text(gate), table_of(gate));
  if (gate.ratchet) text += ratchet_part(*gate.ratchet);
  std::size_t left_out = 0;
  constexpr std::size_t kRoomForCount = 100;
  for (const GateOutcome outcome : {GateOutcome::kFailed, GateOutcome::kInconclusive}) {
    for (const GateCheck& check : gate.checks) {
      if (check.outcome != outcome) continue;
      const std::string failure = failure_of(check);
      if (left_out > 0 || text.size() + failure.size() + kRoomForCount > kMostMarkdownBytes) {
        ++left_out;
      } else {
        text += failure;
      }
    }
  }
  if (left_out > 0) text += fmt::format("\n{} more: the report as JSON has all.\n", left_out);
  return text;
}

}  // namespace raycheck::tools
