#include <fmt/core.h>

#include <string_view>
#include <vector>

#include "scene/text.h"
#include "tools/gates/gate_views.h"

namespace raycheck::tools {
namespace {

/// Text in a workflow command: characters that would end it, or a property of it, are escaped.
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

}  // namespace

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
    text += fmt::format("::notice title=raycheck::{} of {} are mended: update it\n",
                        gate.ratchet->mended.size(), spelled(gate.ratchet->file, false));
  }
  return text + fmt::format("{}\n", outcomes_text(gate));
}

}  // namespace raycheck::tools
