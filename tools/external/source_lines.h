#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <mutex>
#include <optional>
#include <vector>

#include "properties/failures.h"
#include "tools/external/sandbox/launch.h"

namespace raycheck::tools {

/// Finds source lines of a compiled library. The library's line tables are not trusted: addr2line
/// reads them in the library's sandbox, and only existing lines of files in the source's folder are
/// accepted.
/// Source: addr2line, GNU binutils (sourceware.org/binutils/docs/binutils/addr2line.html).
class SourceLines {
 public:
  /// `program`: the program that runs the library. `compiled`: the folder of the source during
  /// compilation. `named`: the name of that folder in the results.
  SourceLines(const Confined& program, std::filesystem::path library,
              std::filesystem::path compiled, std::filesystem::path named);

  /// The source line of the innermost frame whose code is in the source's folder; frames in other
  /// headers are skipped, even if inlined. `frames`: offsets in the library's file, the innermost
  /// first. Empty if there is no such frame, or if addr2line is missing.
  std::optional<properties::CodeLine> innermost(const std::vector<std::uint64_t>& frames) const;

 private:
  std::optional<properties::CodeLine> find(const std::vector<std::uint64_t>& frames) const;
  std::optional<properties::CodeLine> own_line(std::string_view place) const;

  Confined addr2line_;
  std::filesystem::path library_, compiled_, named_;
  mutable std::mutex mutex_;
  mutable std::map<std::vector<std::uint64_t>, std::optional<properties::CodeLine>> found_;
};

}  // namespace raycheck::tools
