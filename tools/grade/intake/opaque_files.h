#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "tools/grade/intake/handed_in.h"
#include "tools/grade/results/result.h"

namespace raycheck::tools {

/// A file that is no picture, program or archive is listed from this size on.
inline constexpr std::uintmax_t kLargeFile = std::uintmax_t{256} << 10;
/// Nobody writes longer lines by hand.
inline constexpr std::size_t kLongLine = 4000;

/// Whether a file begins as a picture does.
bool is_picture(std::string_view text);

/// What nobody sees through by reading a submission, and what may bring answers along that were
/// computed elsewhere: programs, libraries, archives, pictures, large files, and texts with lines
/// that nobody wrote. None of it is forbidden.
/// `paths` are where the files lie.
std::vector<OpaqueFile> opaque_files(const HandedInFiles& files,
                                     const std::map<std::string, std::filesystem::path>& paths);

}  // namespace raycheck::tools
