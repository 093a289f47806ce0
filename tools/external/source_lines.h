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

/// The lines of the source that a library was compiled from. Its line tables are not trusted:
/// addr2line reads them, sandboxed like the library itself, and its answers count only for existing
/// lines of files in the source's folder.
/// Source: addr2line, GNU binutils (sourceware.org/binutils/docs/binutils/addr2line.html).
class SourceLines {
 public:
  /// `program` runs the library; `compiled` is the folder of the source when it was compiled,
  /// `named` is how lines show that folder.
  SourceLines(const Confined& program, std::filesystem::path library,
              std::filesystem::path compiled, std::filesystem::path named);

  /// The line of the innermost of these frames, given as offsets in the library's file and
  /// innermost first, that lies in the source: frames in other people's headers are skipped,
  /// inlined or not. Empty if there is none, or no addr2line.
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
