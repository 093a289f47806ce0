#pragma once

#include <filesystem>
#include <vector>

namespace raycheck::tools {

/// Of the system what programs need: of /etc files of the loader, Java and OpenSSL, which Node.js
/// does not start without where it is there and closed. Some may not be there.
std::vector<std::filesystem::path> system_paths();

/// What raycheck's helpers need besides the system: the adapters, and the libraries of a package
/// where it brings some that they may read.
std::vector<std::filesystem::path> own_paths();

/// Of all these what gives away right answers, or what is asked: raycheck itself, wherever programs
/// are looked for, and the rubrics that come with it.
std::vector<std::filesystem::path> hidden_paths();

}  // namespace raycheck::tools
