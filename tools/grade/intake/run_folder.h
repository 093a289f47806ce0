#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "tools/external/sandbox/private_folder.h"
#include "tools/grade/intake/handed_in.h"

namespace raycheck::tools {

/// So many folders and files of a submission lie in the folder of each run at most, those nearer
/// to the top before others.
inline constexpr std::size_t kMostInRunFolder = 100;
/// A file of so many bytes is a copy there while all copies have at most so many; others are links.
inline constexpr std::size_t kMostOfCopy = std::size_t{64} << 10;
inline constexpr std::size_t kMostOfCopies = std::size_t{1} << 20;

/// The folder in which a submission's renderer runs: it has the submission's own folders and files,
/// but no picture, which would be taken for what it makes, nothing of the names that the driver
/// file and the picture have there, and none of Eigen's and glm's headers. `copy`: where the files
/// lie.
std::shared_ptr<const StartingFolder> run_folder(const HandedInFiles& files,
                                                 const std::vector<std::string>& folders,
                                                 std::shared_ptr<const PrivateFolder> copy);

}  // namespace raycheck::tools
