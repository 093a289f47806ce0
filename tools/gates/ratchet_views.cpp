#include <fmt/core.h>

#include "tools/gates/gate_views.h"

namespace raycheck::tools {
namespace {

std::string lines_of(std::string_view what, const std::vector<Identity>& identities) {
  std::string text;
  for (const Identity& one : identities) {
    text += fmt::format("  {}: {} on {}, {}, {}: {}\n", what, one.law, one.source, one.place,
                        one.kind, one.candidate);
  }
  return text;
}

Json identities_json(const std::vector<Identity>& identities) {
  return list_json(identities, [](const Identity& one) {
    return Json{{"law", one.law},
                {"source", one.source},
                {"kind", one.kind},
                {"place", one.place},
                {"candidate", one.candidate}};
  });
}

}  // namespace

std::string ratchet_text(const Ratchet& ratchet) {
  std::string text = fmt::format("held against {}: {} known, {} new, {} mended{}", ratchet.file,
                                 ratchet.known.size(), ratchet.added.size(), ratchet.mended.size(),
                                 ratchet.mended.empty() ? "" : " (--update-baseline)");
  if (!ratchet.unasked.empty()) {
    text += fmt::format("; {} of the baseline not asked", ratchet.unasked.size());
  }
  return text + "\n" + lines_of("new", ratchet.added) + lines_of("mended", ratchet.mended);
}

Json ratchet_json(const std::optional<Ratchet>& ratchet) {
  if (!ratchet) return nullptr;
  return {{"file", ratchet->file},
          {"known", identities_json(ratchet->known)},
          {"new", identities_json(ratchet->added)},
          {"mended", identities_json(ratchet->mended)},
          {"not_asked", identities_json(ratchet->unasked)},
          {"strict", ratchet->strict},
          {"fails", ratchet->fails()}};
}

}  // namespace raycheck::tools
