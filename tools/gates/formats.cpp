#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <boost/algorithm/string/replace.hpp>
#include <numeric>
#include <string_view>
#include <utility>
#include <vector>

#include "scene/text.h"
#include "tools/gates/gate.h"
#include "tools/report/spelling.h"

namespace raycheck::tools {
namespace {

// JUnit XML for Jenkins, GitLab and tools for GitHub: one suite per candidate, one test per check,
// with unique names. Inconclusive checks are errors; known checks and checks that were left out are
// skipped tests.

/// GitLab accepts test reports of at most 30 MB, so texts are cut if the file would be larger.
constexpr std::size_t kMostJunitBytes = 29'000'000;

constexpr std::string_view kCut = "\n... (truncated; the JSON report is complete)";

/// Characters that scene::visible leaves and XML 1.0 does not allow, and text that logs of GitHub
/// workflows interpret anywhere. An apostrophe stays.
constexpr std::pair<std::string_view, std::string_view> kReplaced[] = {
    {"\uFFFE", "\uFFFD"}, {"\uFFFF", "\uFFFD"}, {"##[", "##&#91;"}, {"&#39;", "'"}};

std::string xml(std::string_view text) {
  std::string shown = escaped(text);
  for (const auto& [from, to] : kReplaced) boost::replace_all(shown, from, to);
  return shown;
}

/// As much of a text as fits into `most` bytes, escaped: whole characters and entities.
std::string shortened(std::string_view text, std::size_t most) {
  std::string escaped = xml(text.substr(0, most));
  if (text.size() <= most && escaped.size() <= most) return escaped;
  std::size_t end = most > kCut.size() ? std::min(most - kCut.size(), escaped.size()) : 0;
  while (end > 0 && end < escaped.size() &&
         (static_cast<unsigned char>(escaped[end]) & 0xC0U) == 0x80U) {
    --end;
  }
  const std::size_t entity = escaped.rfind('&', end);
  if (entity != std::string::npos && entity < end && escaped.find(';', entity) >= end) end = entity;
  return escaped.substr(0, end) + std::string(kCut);
}

/// The element of a check that did not pass, by its outcome.
constexpr std::array<std::string_view, kGateOutcomes> kElements = {"", "failure", "skipped",
                                                                   "error", "skipped"};

std::string test_case(const GateCheck& check, std::size_t most_text) {
  const std::string begin = fmt::format("    <testcase classname=\"{}\" name=\"{}\"",
                                        xml(check.candidate), xml(check.name));
  if (check.outcome == GateOutcome::kPassed) return begin + "/>\n";
  const std::string_view element = kElements[static_cast<std::size_t>(check.outcome)];
  return fmt::format("{}>\n      <{} type=\"{}\" message=\"{}\">{}</{}>\n    </testcase>\n", begin,
                     element, name(check.outcome), shortened(check.summary, most_text),
                     shortened(check.text.empty() ? check.summary : check.text, most_text),
                     element);
}

/// The contents of the file, with each text and message limited to `most_text` bytes.
std::string file_of(const Gate& gate, std::size_t most_text) {
  std::string text = fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<testsuites name=\"raycheck {}\" tests=\"{}\" failures=\"{}\" errors=\"{}\">\n",
      gate.command, gate.checks.size(), gate.count(GateOutcome::kFailed),
      gate.count(GateOutcome::kInconclusive));
  for (const auto& [candidate, counts] : outcomes_by_candidate(gate)) {
    const auto count = [&counts = counts](GateOutcome outcome) {
      return counts[static_cast<std::size_t>(outcome)];
    };
    text += fmt::format(
        "  <testsuite name=\"{}\" tests=\"{}\" failures=\"{}\" errors=\"{}\" skipped=\"{}\">\n",
        xml(candidate), std::accumulate(counts.begin(), counts.end(), std::size_t{0}),
        count(GateOutcome::kFailed), count(GateOutcome::kInconclusive),
        count(GateOutcome::kKnown) + count(GateOutcome::kLeftOut));
    for (const GateCheck& check : gate.checks) {
      if (check.candidate == candidate) text += test_case(check, most_text);
    }
    text += "  </testsuite>\n";
  }
  return text + "</testsuites>\n";
}

std::string junit(const Gate& gate) {
  // The limit on each text is halved until all fit together.
  std::size_t texts = 0, bytes = 0;
  for (const GateCheck& check : gate.checks) {
    texts += check.outcome == GateOutcome::kPassed ? 0 : 2;
    bytes += 2 * check.summary.size() + check.text.size();
  }
  std::size_t most = bytes < kMostJunitBytes / 2 ? kMostJunitBytes : kMostJunitBytes / texts;
  std::string text = file_of(gate, most);
  for (; text.size() > kMostJunitBytes && most > 0; text = file_of(gate, most)) most /= 2;
  return text;
}

// Markdown: a table of the outcomes, followed by as many failures as fit.

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
      fmt::format("\nCompared with {}: {} known, {} new, {} fixed.\n", inline_text(ratchet.file),
                  ratchet.known.size(), ratchet.added.size(), ratchet.mended.size());
  for (const Identity& one : ratchet.mended) {
    text += fmt::format("- fixed: {}/{}, {}, at {}, {}\n", inline_text(one.law),
                        inline_text(one.source), inline_text(one.kind), inline_text(one.place),
                        inline_text(one.candidate));
  }
  return text;
}

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
  if (left_out > 0) text += fmt::format("\n{} more: see the JSON report.\n", left_out);
  return text;
}

// GitHub's workflow commands: an annotation for each failure, at its line if that is known. If
// there are too many, the last annotation counts the others.

/// GitHub shows at most this number of annotations per step.
constexpr std::size_t kMostAnnotations = 10;

/// Text in a workflow command. Characters that would end it, or end a property of it, are escaped.
std::string spelled(std::string_view text, bool is_property) {
  std::string shown;
  for (const char c : scene::visible(text)) {
    const bool ends = c == '%' || c == '\r' || c == '\n' || (is_property && (c == ':' || c == ','));
    shown += ends ? fmt::format("%{:02X}", static_cast<unsigned char>(c)) : std::string(1, c);
  }
  return shown;
}

std::string annotation(const Gate& gate, const GateCheck& check) {
  const auto at = line_of(gate, check);
  return fmt::format(
      "::error {}title={}::{}\n",
      at ? fmt::format("file={},line={},", spelled(at->file, true), at->line) : "",
      spelled(fmt::format("raycheck: {}", check.name), true),
      spelled(fmt::format("{}: {}\n{}", check.candidate, check.summary, check.text), false));
}

std::string github(const Gate& gate) {
  std::vector<const GateCheck*> shown;
  for (const GateOutcome outcome : {GateOutcome::kFailed, GateOutcome::kInconclusive}) {
    for (const GateCheck& check : gate.checks) {
      if (check.outcome == outcome) shown.push_back(&check);
    }
  }
  const bool fits = shown.size() <= kMostAnnotations;
  const std::size_t count = fits ? shown.size() : kMostAnnotations - 1;
  std::string text;
  for (std::size_t k = 0; k < count; ++k) text += annotation(gate, *shown[k]);
  if (!fits) {
    text += fmt::format("::error title=raycheck::{} more, of {} checks in all: {}\n",
                        shown.size() - count, gate.checks.size(), outcomes_text(gate));
  }
  if (gate.ratchet && !gate.ratchet->mended.empty()) {
    text += fmt::format("::notice title=raycheck::{} of {} no longer occur: update the baseline\n",
                        gate.ratchet->mended.size(), spelled(gate.ratchet->file, false));
  }
  return text + fmt::format("{}\n", outcomes_text(gate));
}

// GitLab's code quality report: a JSON list with an entry for each defect that is not in the
// baseline.

/// A hash of a text, the same on every machine: 32 hexadecimal digits by which GitLab recognises a
/// finding. It is FNV-1a (Fowler, Noll, Vo) twice, with different offsets, for 128 bits. Collisions
/// are improbable, but can be constructed.
std::string fingerprint(std::string_view text) {
  constexpr std::uint64_t kPrime = 0x100000001B3;
  const auto hash = [&](std::uint64_t value) {
    for (const char c : text) value = (value ^ static_cast<unsigned char>(c)) * kPrime;
    return value;
  };
  return fmt::format("{:016x}{:016x}", hash(0xCBF29CE484222325), hash(0x84222325CBF29CE4));
}

std::string fingerprint_of(const Identity& one) {
  return fingerprint(
      fmt::format("{}\n{}\n{}\n{}\n{}", one.law, one.source, one.kind, one.place, one.candidate));
}

std::string gitlab_codequality(const Gate& gate) {
  Json list = Json::array();
  for (const GateCheck& check : gate.checks) {
    if (check.outcome != GateOutcome::kFailed) continue;
    // GitLab needs a path; if the source is not known, the candidate's name.
    const auto at = line_of(gate, check).value_or(properties::CodeLine{check.candidate});
    for (const Identity& one : check.defects) {
      if (is_known(one, gate.ratchet)) continue;
      list.push_back({{"description", fmt::format("{}: {} ({}, {}): {}", check.candidate, one.kind,
                                                  check.name, one.place, check.summary)},
                      {"check_name", fmt::format("raycheck/{}", one.law)},
                      {"fingerprint", fingerprint_of(one)},
                      {"severity", "major"},
                      {"location", {{"path", at.file}, {"lines", {{"begin", at.line}}}}}});
    }
  }
  return json_text(list);
}

/// The formats; a new one is its function above and its row here.
constexpr GateFormat kFormats[] = {
    {"junit", junit},
    {"markdown", markdown},
    {"github", github, true},
    {"gitlab-codequality", gitlab_codequality},
};

}  // namespace

std::span<const GateFormat> gate_formats() { return kFormats; }

}  // namespace raycheck::tools
