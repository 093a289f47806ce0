#pragma once

#include <string>

namespace raycheck::tools {

/// A digest of raycheck's version and of the compilers and interpreters of this machine that builds
/// and programs use, and of Eigen and glm: which files they are, how large and of which time.
/// Another version is another file.
std::string toolchain();

}  // namespace raycheck::tools
