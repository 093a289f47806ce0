#include "tools/external/candidate_spec.h"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

#include "scene/text.h"

namespace raycheck::tools {
namespace {

constexpr std::string_view kKinds =
    "library:PATH.so, source:PATH, command:'WORDS' or "
    "renderer:'WORDS with {scene} and {image}'";

}  // namespace

std::string CandidateSpec::text() const {
  return fmt::format("{}:{}", kCandidateKindNames[static_cast<std::size_t>(kind)], what);
}

CandidateError::CandidateError(const std::string& why, std::string output, std::string_view whose)
    : InvalidInput(whose.empty() ? "" : "candidate", scene::visible(whose),
                   scene::visible(why + (output.empty() ? "" : "\n" + output))),
      why_(why),
      output_(std::move(output)) {}

CandidateSpec parse_candidate(const std::string& text) {
  const std::size_t colon = text.find(':');
  const std::string name = text.substr(0, colon);
  const std::string what = colon == std::string::npos ? "" : text.substr(colon + 1);
  if (what.empty()) throw CandidateError(fmt::format("give {}", kKinds), {}, text);
  const auto* const found = std::ranges::find(kCandidateKindNames, name);
  if (found == kCandidateKindNames.end()) {
    throw CandidateError(fmt::format("unknown kind '{}'; give {}", name, kKinds), {}, text);
  }
  return {static_cast<CandidateKind>(found - kCandidateKindNames.begin()), what};
}

}  // namespace raycheck::tools
