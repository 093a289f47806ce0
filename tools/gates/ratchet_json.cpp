#include "tools/gates/gate_views.h"

namespace raycheck::tools {
namespace {

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
