#include "tools/external/sandbox/layers.h"

#include <fmt/core.h>
#include <unistd.h>

#include <stdexcept>
#include <utility>

#include "tools/external/sandbox/process.h"

namespace raycheck::tools {
namespace {

/// Whether `true` runs in these layers.
bool works(const Layers& layers) {
  try {
    Process process({{"/bin/true"}, {}, layers, {}});
    return process.finish() == 0;
  } catch (const ProcessFailure&) {
    return false;
  }
}

Layers found_by_trying() {
  Layers layers;
  if (geteuid() == 0) {
    layers.own_user = true;
    if (!works(layers)) use_small_users();
    if (!works(layers)) layers.own_user = false;
  }
  layers.seccomp = true;
  if (!works(layers)) layers.seccomp = false;
  layers.bubblewrap = true;
  if (!works(layers)) layers.bubblewrap = false;
  return layers;
}

}  // namespace

std::string Layers::text() const {
  std::string text;
  for (const auto& [has, name] : {std::pair(own_user, "own user"), std::pair(seccomp, "seccomp"),
                                  std::pair(bubblewrap, "bubblewrap")}) {
    if (has) text += (text.empty() ? "" : ", ") + std::string(name);
  }
  return text.empty() ? "limits only" : text;
}

const Layers& layers_that_work() {
  static const Layers layers = found_by_trying();
  return layers;
}

Layers chosen_layers(Sandbox sandbox) {
  if (sandbox == Sandbox::kNone) return {};
  const Layers& layers = layers_that_work();
  if (sandbox == Sandbox::kRequire && !(layers.seccomp && layers.bubblewrap)) {
    throw std::invalid_argument(
        fmt::format("sandbox require: what works here is {}; seccomp and bubblewrap (the Debian "
                    "package of that name) are required",
                    layers.text()));
  }
  return layers;
}

}  // namespace raycheck::tools
