#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace raycheck::tools {

/// How much is taken of what someone hands in.
struct IntakeLimits {
  std::uintmax_t mib = 64;
  std::size_t files = 10000;
};

/// A file as it was handed in.
struct HandedInFile {
  std::string text;   ///< Its first 4 MiB.
  bool runs = false;  ///< Its mode says that it is a program.
};

/// By their paths in the submission: "src/rt.cpp".
using HandedInFiles = std::map<std::string, HandedInFile>;

/// What is taken of a submission.
struct HandedInPaths {
  std::map<std::string, std::filesystem::path> files;  ///< By their paths in it.
  std::vector<std::string> folders;  ///< Their paths in it, in which there may be nothing.
};

/// The regular files of a submission, and its folders, without what archives, editors and
/// compilers leave behind: __MACOSX, .git, virtual environments, objects, precompiled headers.
/// Links are not followed: they may lead to what is not the submission's.
/// Errors: std::invalid_argument with what is wrong: no file or folder, or too large.
HandedInPaths paths_of(const std::filesystem::path& path, const IntakeLimits& limits);

/// Where a folder has nothing but another, as unpacked archives do, that, unless a name `is_meant`;
/// what is left behind aside.
std::filesystem::path innermost(std::filesystem::path path,
                                const std::function<bool(const std::string& name)>& is_meant);

/// A digest of files, their names, contents, and which are programs, and of folders.
std::string digest_of(const HandedInPaths& paths);

/// Files with their contents.
HandedInFiles read_files(const std::map<std::string, std::filesystem::path>& paths);

}  // namespace raycheck::tools
