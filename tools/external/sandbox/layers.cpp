#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

#include "scene/invalid_input.h"
#include "scene/text.h"
#include "tools/external/sandbox/control_group.h"
#include "tools/external/sandbox/launch.h"
#include "tools/external/sandbox/private_folder.h"
#include "tools/external/sandbox/process.h"

namespace raycheck::tools {

namespace {

namespace fs = std::filesystem;

/// Why the program `true` does not run in these layers; empty if it does.
std::string why_not(const Layers& layers) {
  try {
    Process process({.arguments = {"/bin/true"}, .readable = {}, .layers = layers, .limits = {}});
    const int code = process.finish();
    if (code == 0) return "";
    return fmt::format("'true' exited with {}{}", code, output_text(process.excerpt()));
  } catch (const ProcessFailure& failure) {
    return failure.what();
  }
}

/// The environment variable that sets the folder for temporary files, and its value; TMPDIR by
/// default.
std::pair<std::string, std::string> temporary_folder() {
  for (const char* name : {"TMPDIR", "TMP", "TEMP", "TEMPDIR"}) {
    if (const char* const path = std::getenv(name)) return {name, path};
  }
  return {"TMPDIR", fs::temp_directory_path()};
}

/// Whether build tools and shells take this character literally, anywhere in a name.
bool is_plain(char c) {
  const auto byte = static_cast<unsigned char>(c);
  constexpr unsigned char kAscii = 0x80;
  return byte >= kAscii || std::isalnum(byte) != 0 ||
         std::string_view("/._-+,@=%").find(c) != std::string_view::npos;
}

/// Checks the folder for temporary files, in which candidates are built and run by their own
/// commands.
void check_temporary_folder() {
  const auto [name, path] = temporary_folder();
  auto fail = [&n = name, shown = path](const std::string& why) mutable {
    std::ranges::replace_if(
        shown, [](unsigned char c) { return std::iscntrl(c) != 0; }, '?');
    throw std::invalid_argument(fmt::format(
        "{} {}: {}; name another folder for temporary files, such as /tmp", n, shown, why));
  };
  if (!path.starts_with('/')) fail("it must begin with /, as candidates run in other folders");
  const auto odd = std::ranges::find_if_not(path, is_plain);
  if (odd != path.end()) {
    fail(fmt::format("its name contains {}, at which build tools may cut it off",
                     std::isprint(static_cast<unsigned char>(*odd)) != 0 ? fmt::format("'{}'", *odd)
                                                                         : "a control character"));
  }
  std::error_code error;
  if (!fs::is_directory(path, error)) fail("there is no such folder");
  if (access(path.c_str(), R_OK | W_OK | X_OK) != 0) fail(std::strerror(errno));
  if (geteuid() == 0 && !others_may_enter(fs::canonical(path))) {
    fail("candidates run as other users, who may not enter it");
  }
}

/// Checks for the helper programs beside raycheck.
void check_helpers() {
  for (const char* name : {"raycheck-jail", "raycheck-worker"}) {
    const fs::path path = program_folder() / name;
    if (access(path.c_str(), X_OK) == 0) continue;
    throw std::invalid_argument(
        fmt::format("{}: {}; raycheck starts candidates with raycheck-jail and raycheck-worker, "
                    "which must be in the same folder as raycheck",
                    path.string(), std::strerror(errno)));
  }
}

/// Tries the control group, after all other layers, because layers that restrict files keep a
/// program from the files of its group.
void try_control_group(LayersHere& here) {
  Layers layers = here.layers;
  if (!layers.own_user && !layers.bubblewrap && !layers.landlock) {
    here.no_control_group =
        "without a separate user, bubblewrap or Landlock a program could leave it";
    return;
  }
  try {
    const GroupLimits limits = begin_control_groups();
    layers.control_group = true;
    layers.group_memory = limits.memory;
    layers.group_processes = limits.processes;
    here.no_control_group = why_not(layers);
  } catch (const std::runtime_error& error) {
    here.no_control_group = error.what();
  }
  here.no_control_group.empty() ? void(here.layers = layers) : end_control_groups();
}

LayersHere found_by_trying() {
  LayersHere here;
  Layers& layers = here.layers;
  const auto attempt = [&](bool Layers::*layer, const char* name) {
    layers.*layer = true;
    const std::string why = why_not(layers);
    layers.*layer = why.empty();
    if (!why.empty()) here.missing.push_back({name, why});
  };
  if (geteuid() == 0) {
    layers.own_user = true;
    if (!why_not(layers).empty()) use_small_users();
    attempt(&Layers::own_user, "own user");
  }
  attempt(&Layers::seccomp, "seccomp");
  attempt(&Layers::bubblewrap, "bubblewrap");
  if (!layers.bubblewrap) attempt(&Layers::landlock, "Landlock");
  try_control_group(here);
  return here;
}

/// Adds raycheck's programs in a folder, without the helpers that run candidates.
void add_programs(const fs::path& folder, std::vector<fs::path>& programs) {
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(folder, ignored)) {
    const std::string name = entry.path().filename();
    const bool is_helper = name == "raycheck-jail" || name == "raycheck-worker";
    if (name.starts_with("raycheck") && !is_helper && entry.is_regular_file(ignored)) {
      programs.push_back(entry.path());
    }
  }
}

}  // namespace

std::string Layers::text() const {
  const auto those = [](std::initializer_list<std::pair<bool, std::string_view>> names) {
    std::string text;
    for (const auto& [is_there, name] : names) {
      if (is_there) text += (text.empty() ? "" : ", ") + std::string(name);
    }
    return text;
  };
  std::string text = those({{own_user, "own user"},
                            {seccomp, "seccomp"},
                            {landlock, "Landlock"},
                            {bubblewrap, "bubblewrap"},
                            {control_group, "control group"}});
  const std::string limits = those({{group_memory, "memory"}, {group_processes, "processes"}});
  if (!limits.empty()) text += " (" + limits + ")";
  return text.empty() ? "limits only" : text;
}

const LayersHere& layers_here() {
  static const LayersHere here = found_by_trying();
  return here;
}

LayersHere chosen_layers(Sandbox sandbox) {
  check_temporary_folder();
  check_helpers();
  if (sandbox == Sandbox::kNone) return {};
  const LayersHere& here = layers_here();
  if (sandbox == Sandbox::kAvailable || here.missing.empty()) return here;
  const std::string missing = scene::joined(here.missing, "; ", [](const auto& layer) {
    return fmt::format("{} ({})", layer.name, layer.why);
  });
  throw scene::InvalidInput(
      "sandbox", "require",
      fmt::format(
          "not available here: {}. Install it (bubblewrap is the Debian "
          "package of that name), or choose sandbox available, which uses only what works: {}",
          missing, here.layers.text()));
}

std::vector<fs::path> system_paths() {
  std::vector<fs::path> paths = {"/usr",
                                 "/bin",
                                 "/lib",
                                 "/lib64",
                                 "/etc/alternatives",
                                 "/etc/ld.so.cache",
                                 "/etc/ld.so.conf",
                                 "/etc/ld.so.conf.d",
                                 "/etc/matplotlibrc",
                                 "/etc/ssl/openssl.cnf"};
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator("/etc", ignored)) {
    if (entry.path().filename().string().starts_with("java")) paths.push_back(entry.path());
  }
  return paths;
}

std::vector<fs::path> own_paths() {
  std::vector<fs::path> paths = {adapters()};
  const fs::path libraries = prefix() / "lib";
  // If a candidate runs under another user id, the libraries are useful only if that user may read
  // them.
  if (fs::exists(libraries) && (geteuid() != 0 || others_may_read(libraries))) {
    paths.push_back(libraries);
  }
  return paths;
}

std::vector<fs::path> hidden_paths() {
  std::vector<fs::path> named = {prefix() / "share" / "raycheck" / "rubrics"};
  add_programs(program_folder(), named);
  for (const fs::path folder : kProgramFolders) {
    named.push_back(folder / "raycheck");
    add_programs(folder.parent_path() / "libexec" / "raycheck", named);
  }
  std::vector<fs::path> found;
  for (const fs::path& path : named) {
    std::error_code error;
    const fs::path real = fs::canonical(path, error);
    if (!error && std::ranges::find(found, real) == found.end()) found.push_back(real);
  }
  return found;
}

}  // namespace raycheck::tools
