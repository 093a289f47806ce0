#include "tools/peers/peers.h"

namespace raycheck::peers {

std::span<const fast::IntersectMethod* const> peers() {
  static constexpr const fast::IntersectMethod* kPeers[] = {
#ifdef RAYCHECK_PEER_GLM
      &kGlm,
#endif
#ifdef RAYCHECK_PEER_BOOST
      &kBoost,
#endif
#ifdef RAYCHECK_PEER_GSL
      &kGsl,
#endif
#ifdef RAYCHECK_PEER_EMBREE
      &kEmbree,
#endif
#ifdef RAYCHECK_PEER_VECGEOM
      &kVecgeom,
#endif
      &kCore,
  };
  return kPeers;
}

}  // namespace raycheck::peers
