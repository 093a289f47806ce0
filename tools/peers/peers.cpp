#include "tools/peers/peers.h"

// RAYCHECK_PEERS_FOUND is a PEER(Name) for each library that was found, by CMakeLists.txt: kName is
// defined in the file of that name.

namespace raycheck::peers {

#define PEER(name) extern const fast::IntersectMethod k##name;
RAYCHECK_PEERS_FOUND
#undef PEER

std::span<const fast::IntersectMethod* const> peers() {
  static constexpr const fast::IntersectMethod* kPeers[] = {
#define PEER(name) &k##name,
      RAYCHECK_PEERS_FOUND
#undef PEER
  };
  return kPeers;
}

}  // namespace raycheck::peers
