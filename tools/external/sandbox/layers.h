#ifndef RAYCHECK_TOOLS_EXTERNAL_SANDBOX_LAYERS_H_
#define RAYCHECK_TOOLS_EXTERNAL_SANDBOX_LAYERS_H_

#include <string>

namespace raycheck::tools {

/// What keeps a candidate in its place, beyond what always does: a group, a folder and an
/// environment of its own, closed descriptors and limits on what it uses.
struct Layers {
  bool own_user = false;     ///< It runs as a user that owns nothing; raycheck is root.
  bool seccomp = false;      ///< No sockets, no looking into other processes.
  bool bubblewrap = false;   ///< Namespaces of its own; of the file system what it needs.
  std::string text() const;  ///< "own user, seccomp, bubblewrap", or "limits only"
};

/// The layers that work here; found out once, by trying.
const Layers& layers_that_work();

/// Which to use. Throws std::invalid_argument where `require` asks for what does not work here.
enum class Sandbox { kAuto, kRequire, kNone };
Layers chosen_layers(Sandbox sandbox);

}  // namespace raycheck::tools

#endif  // RAYCHECK_TOOLS_EXTERNAL_SANDBOX_LAYERS_H_
