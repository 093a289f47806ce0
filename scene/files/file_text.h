#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace raycheck::scene {

/// The most bytes of a file that are read: those of three million spheres.
inline constexpr std::uintmax_t kMostFileBytes = std::uintmax_t{256} << 20;

/// All of a file, or of what a pipe, a socket or a terminal gives up to its end (/dev/stdin, and
/// the /dev/fd/N of a shell's `<(...)`). Errors: SceneFileError, naming the path: what cannot be
/// read, is a folder or a device, is a named pipe (whoever opens one may wait for ever), or has
/// more than `most` bytes.
std::string file_text(const std::filesystem::path& path, std::uintmax_t most = kMostFileBytes);

}  // namespace raycheck::scene
