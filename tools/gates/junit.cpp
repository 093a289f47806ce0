#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <string_view>
#include <vector>

#include "scene/text.h"
#include "tools/gates/gate_views.h"

namespace raycheck::tools {
namespace {

constexpr std::string_view kCut = "\n... (cut: the report as JSON has all)";

/// Not allowed in XML 1.0, beyond what scene::visible escapes.
constexpr std::array<std::string_view, 2> kNoCharacters = {"\uFFFE", "\uFFFF"};

std::string xml(std::string_view text) {
  std::string shown = scene::visible(text);
  for (const std::string_view none : kNoCharacters) {
    for (std::size_t at = shown.find(none); at != std::string::npos; at = shown.find(none, at)) {
      shown.replace(at, none.size(), "\uFFFD");
    }
  }
  std::string escaped;
  for (const char c : shown) {
    switch (c) {
      // Logs of GitHub workflows interpret "##[error]" anywhere.
      case '[':
        escaped += escaped.ends_with("##") ? "&#91;" : "[";
        break;
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      default:
        escaped += c;
    }
  }
  return escaped;
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

/// The element of a check that did not pass.
std::string_view element_of(GateOutcome outcome) {
  switch (outcome) {
    case GateOutcome::kFailed:
      return "failure";
    case GateOutcome::kInconclusive:
      return "error";
    default:
      return "skipped";
  }
}

std::string test_case(const GateCheck& check, std::size_t most_text) {
  const std::string begin = fmt::format("    <testcase classname=\"{}\" name=\"{}\"",
                                        xml(check.candidate), xml(check.name));
  if (check.outcome == GateOutcome::kPassed) return begin + "/>\n";
  const std::string_view element = element_of(check.outcome);
  return fmt::format("{}>\n      <{} type=\"{}\" message=\"{}\">{}</{}>\n    </testcase>\n", begin,
                     element, name(check.outcome), shortened(check.summary, most_text),
                     shortened(check.text.empty() ? check.summary : check.text, most_text),
                     element);
}

struct Suite {
  std::vector<const GateCheck*> checks;
  std::size_t failed = 0, inconclusive = 0, skipped = 0;
};

std::map<std::string, Suite> suites_of(const Gate& gate) {
  std::map<std::string, Suite> suites;
  for (const GateCheck& check : gate.checks) {
    Suite& suite = suites[check.candidate];
    suite.checks.push_back(&check);
    suite.failed += check.outcome == GateOutcome::kFailed ? 1 : 0;
    suite.inconclusive += check.outcome == GateOutcome::kInconclusive ? 1 : 0;
    suite.skipped +=
        check.outcome == GateOutcome::kKnown || check.outcome == GateOutcome::kLeftOut ? 1 : 0;
  }
  return suites;
}

/// The file, with each text and message limited to `most_text` bytes.
std::string file_of(const Gate& gate, std::size_t most_text) {
  const auto suites = suites_of(gate);
  std::string text = fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<testsuites name=\"raycheck {}\" tests=\"{}\" failures=\"{}\" errors=\"{}\">\n",
      gate.command, gate.checks.size(), gate.count(GateOutcome::kFailed),
      gate.count(GateOutcome::kInconclusive));
  for (const auto& [candidate, suite] : suites) {
    text += fmt::format(
        "  <testsuite name=\"{}\" tests=\"{}\" failures=\"{}\" errors=\"{}\" skipped=\"{}\">\n",
        xml(candidate), suite.checks.size(), suite.failed, suite.inconclusive, suite.skipped);
    for (const GateCheck* const check : suite.checks) text += test_case(*check, most_text);
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
