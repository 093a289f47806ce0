#ifndef RAYCHECK_TOOLS_GRADE_STORE_TOOLCHAIN_H_
#define RAYCHECK_TOOLS_GRADE_STORE_TOOLCHAIN_H_

#include <string>

namespace raycheck::tools {

/// A digest of raycheck's version and of the compilers and interpreters of this machine that builds
/// and programs use, and of Eigen and glm: which files they are, how large and of which time.
/// Another version is another file.
std::string toolchain();

}  // namespace raycheck::tools

#endif  // RAYCHECK_TOOLS_GRADE_STORE_TOOLCHAIN_H_
