#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <boost/algorithm/string/replace.hpp>
#include <numeric>
#include <string_view>
#include <utility>

#include "tools/gates/gate_views.h"
#include "tools/report/spelling.h"

namespace raycheck::tools {
namespace {

constexpr std::string_view kCut = "\n... (cut: the report as JSON has all)";

/// What scene::visible leaves that XML 1.0 does not allow, and that logs of GitHub workflows
/// interpret anywhere; an apostrophe stays.
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

/// The file, with each text and message limited to `most_text` bytes.
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

}  // namespace

std::string junit(const Gate& gate) {
  // The size of each text for which all fit together, halved until they do.
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

}  // namespace raycheck::tools
