#include <fmt/core.h>

#include "scene/text.h"
#include "tools/gates/gate.h"

namespace raycheck::tools {
namespace {

std::string lines_of(std::string_view what, const std::vector<Identity>& identities) {
  return scene::joined(identities, "", [&](const Identity& one) {
    return fmt::format("  {}: {} on {}, {} ({}), {}\n", what, one.law, one.source, one.place,
                       one.kind, one.candidate);
  });
}

}  // namespace

std::string ratchet_text(const Ratchet& ratchet) {
  std::string text = fmt::format("compared with {}: {} known, {} new, {} fixed{}", ratchet.file,
                                 ratchet.known.size(), ratchet.added.size(), ratchet.mended.size(),
                                 ratchet.mended.empty() ? "" : " (--update-baseline)");
  if (!ratchet.unasked.empty()) {
    text += fmt::format("; this run did not judge {} of the baseline", ratchet.unasked.size());
  }
  return text + "\n" + lines_of("new", ratchet.added) + lines_of("fixed", ratchet.mended);
}

}  // namespace raycheck::tools
