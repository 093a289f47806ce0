#include <fmt/core.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

#include "tools/gates/fingerprint.h"
#include "tools/gates/gate_views.h"
#include "tools/report/json.h"
#include "tools/report/version.h"
#include "tools/report/words.h"

namespace raycheck::tools {
namespace {

using properties::CodeLine;

/// The one thing that is wrong at a line: GitHub knows a finding again by it and the fingerprint.
constexpr const char* kRule = "failed";
constexpr const char* kRuleSentence = "The code dies or throws where it is asked for an answer.";
constexpr const char* kRuleMeaning =
    "raycheck asks problems alone, as its documentation says, and each of them has an answer. At "
    "this line the code died of a signal, or threw what it does not catch, and gave none.";
constexpr const char* kRuleHelp =
    "The message says how it died, and what it was asked. The same command as text, not as SARIF, "
    "has that question as a scene of its own, and a command that asks it again.";
/// What of the checks that fail at a line is named.
constexpr std::size_t kMostNamed = 5;

/// A line at which a candidate failed: how it first did, and the checks that failed there.
struct FailedLine {
  CodeLine line;
  std::string candidate;
  std::string words;
  std::vector<std::string> checks;
};

/// In the order in which they were found.
std::vector<FailedLine> failed_lines(const Gate& gate) {
  std::vector<FailedLine> lines;
  std::map<std::pair<std::string, std::int64_t>, std::size_t> known;
  for (const GateCheck& check : gate.checks) {
    for (const FailedAnswer& failed : check.failed) {
      if (!failed.line || is_known(failed.identity, gate.ratchet)) continue;
      const auto [at, is_new] =
          known.try_emplace({failed.line->file, failed.line->line}, lines.size());
      if (is_new) lines.push_back({*failed.line, check.candidate, failed.words, {}});
      std::vector<std::string>& checks = lines[at->second].checks;
      if (checks.empty() || checks.back() != check.name) checks.push_back(check.name);
    }
  }
  return lines;
}

/// A path as a URI: relative, or of a file. Source: RFC 3986, 2.3 and 3.3; RFC 8089.
std::string uri_of(std::string_view path) {
  constexpr std::string_view kAsItIs = "/-._~";
  std::string uri = path.starts_with('/') ? "file://" : "";
  for (const char c : path) {
    const bool is_plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
                          (c >= '0' && c <= '9') || kAsItIs.find(c) != std::string_view::npos;
    uri += is_plain ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
  }
  return uri;
}

std::string message_of(const FailedLine& failed) {
  std::string checks;
  for (std::size_t k = 0; k < std::min(failed.checks.size(), kMostNamed); ++k) {
    checks += (k == 0 ? "" : ", ") + failed.checks[k];
  }
  if (failed.checks.size() > kMostNamed) {
    checks += fmt::format(" and {} more", failed.checks.size() - kMostNamed);
  }
  return fmt::format("{}: {}fails there: {}", failed.candidate, failed.words, checks);
}

/// Stays as it is where the line moves: of its text, and of which of the lines of the same text in
/// the file it is.
class Fingerprints {
 public:
  std::string of(const CodeLine& line) {
    const int number = ++seen_[{line.file, line.text}];
    return fmt::format("{}:{}", fingerprint(line.text), number);
  }

 private:
  std::map<std::pair<std::string, std::string>, int> seen_;
};

/// Code points.
std::int64_t characters(std::string_view text) {
  return std::count_if(text.begin(), text.end(),
                       [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; });
}

Json place_of(const CodeLine& line) {
  Json file = {{"uri", uri_of(line.file)}};
  if (!line.file.starts_with('/')) file["uriBaseId"] = "%SRCROOT%";
  return {{"physicalLocation",
           {{"artifactLocation", std::move(file)},
            {"region",
             {{"startLine", line.line},
              {"startColumn", line.column},
              {"endLine", line.line},
              {"endColumn", line.column + characters(line.text)},
              {"snippet", {{"text", line.text}}}}}}}};
}

}  // namespace

std::string sarif(const Gate& gate) {
  Json results = Json::array();
  Fingerprints fingerprints;
  std::vector<FailedLine> lines = failed_lines(gate);
  if (lines.size() > kMostSarifResults) lines.resize(kMostSarifResults);
  for (const FailedLine& failed : lines) {
    results.push_back(
        {{"ruleId", kRule},
         {"ruleIndex", 0},
         {"level", "error"},
         {"message", {{"text", message_of(failed)}}},
         {"locations", Json::array({place_of(failed.line)})},
         {"partialFingerprints", {{"primaryLocationLineHash", fingerprints.of(failed.line)}}}});
  }
  const Json rule = {{"id", kRule},
                     {"name", "Failed"},
                     {"shortDescription", {{"text", kRuleSentence}}},
                     {"fullDescription", {{"text", kRuleMeaning}}},
                     {"help", {{"text", kRuleHelp}}},
                     {"defaultConfiguration", {{"level", "error"}}}};
  const Json driver = {{"name", "raycheck"},
                       {"version", kVersion},
                       {"semanticVersion", kVersion},
                       {"rules", Json::array({rule})}};
  // The category keeps what `check` found and what `properties` found apart.
  const Json run = {{"tool", {{"driver", driver}}},
                    {"automationDetails", {{"id", fmt::format("raycheck/{}/", gate.command)}}},
                    {"columnKind", "unicodeCodePoints"},
                    {"results", std::move(results)}};
  return json_text({{"$schema", "https://json.schemastore.org/sarif-2.1.0.json"},
                    {"version", "2.1.0"},
                    {"runs", Json::array({run})}});
}

std::vector<std::string> sarif_warnings(const Gate& gate) {
  std::size_t wrong = 0, failed = 0, at_lines = 0;
  for (const GateCheck& check : gate.checks) {
    for (const Identity& one : check.defects) {
      if (is_known(one, gate.ratchet)) continue;
      bool is_failure = false, has_line = false;
      for (const FailedAnswer& answer : check.failed) {
        if (answer.identity != one) continue;
        is_failure = true;
        has_line = has_line || answer.line;
      }
      ++(has_line ? at_lines : is_failure ? failed : wrong);
    }
  }
  std::vector<std::string> warnings;
  if (wrong + failed > 0) {
    std::string why;
    if (wrong > 0) why = count_text(wrong, "wrong answer") + ", which no one line makes";
    if (wrong > 0 && failed > 0) why += "; ";
    if (failed > 0) {
      why += count_text(failed, "failure") +
             " at no line of its source that is known: silence, an exit, a reply that is none, or "
             "a stack that cannot be read";
    }
    warnings.push_back(fmt::format("{} of {} not in the SARIF log: {}", wrong + failed,
                                   count_text(wrong + failed + at_lines, "defect"), why));
  }
  const std::size_t lines = failed_lines(gate).size();
  if (lines > kMostSarifResults) {
    warnings.push_back(
        fmt::format("the SARIF log has the first {} of {} lines", kMostSarifResults, lines));
  }
  return warnings;
}

}  // namespace raycheck::tools
