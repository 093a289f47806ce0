#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace raycheck::scene {

/// The most bytes read from a file: enough for three million spheres.
inline constexpr std::uintmax_t kMostFileBytes = std::uintmax_t{256} << 20;

/// The contents of a file, or all that a pipe, a socket or a terminal delivers (/dev/stdin, and the
/// /dev/fd/N of a shell's `<(...)`). Errors: SceneFileError, naming the path, if the file cannot be
/// read, has more than `most` bytes, or is a folder, a device or a named pipe, which may block.
std::string file_text(const std::filesystem::path& path, std::uintmax_t most = kMostFileBytes);

}  // namespace raycheck::scene
