#pragma once

#include <string>
#include <vector>

namespace raycheck::tools {

/// What keeps a candidate in its place, beyond what always does: a session, a folder and an
/// environment of its own, closed descriptors and limits on what it uses.
struct Layers {
  bool own_user = false;    ///< It runs as a user that owns nothing; raycheck is root.
  bool seccomp = false;     ///< No sockets, no looking into other processes.
  bool landlock = false;    ///< Of the file system what it needs; in place of bubblewrap.
  bool bubblewrap = false;  ///< Namespaces of its own; of the file system what it needs.
  /// A control group of its own, in which all is counted and killed together, and where the kernel
  /// limits what all use together.
  bool control_group = false, group_memory = false, group_processes = false;
  /// "own user, seccomp, bubblewrap, control group (memory, processes)", or "limits only"
  std::string text() const;
};

/// A layer that a machine should have and that does not work there.
struct MissingLayer {
  std::string name;
  std::string why;  ///< In the words of what failed.
};

/// The layers that work here, found out once, by trying, and those that do not.
struct LayersHere {
  Layers layers;
  std::vector<MissingLayer> missing;
  /// Why there is no control group, which most machines let nobody make; empty: there is, or none
  /// was asked for.
  std::string no_control_group = {};
};
const LayersHere& layers_here();

/// Which layers to use.
enum class Sandbox {
  kRequire,    ///< All that there should be: a user of its own as root, seccomp, bubblewrap.
  kAvailable,  ///< Those that work here.
  kNone        ///< Limits alone.
};
/// Errors: std::invalid_argument where `kRequire` asks for what does not work here, naming it, why,
/// and what does; and where the folder for temporary files cannot be used.
LayersHere chosen_layers(Sandbox sandbox);

}  // namespace raycheck::tools
