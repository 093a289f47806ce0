#pragma once

#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

namespace raycheck::tools {

/// A file that an option or a field names. It appears completely or not at all, because it is
/// written beside its place and then moved there. The constructor opens it, so that an unwritable
/// file is reported before hours of work.
class OutputFile {
 public:
  /// `named_by` is its name in errors: "--out" on the command line, "out" elsewhere. Throws
  /// std::invalid_argument with that name, the path and the reason.
  OutputFile(std::string named_by, std::string path);
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;
  /// Removes the file unless place() was called.
  ~OutputFile();

  /// Writes the next part of the file. Throws std::runtime_error on failure.
  void append(std::string_view bytes);
  /// Moves the file to its place. No other call may follow. Throws as append().
  void place();
  /// Throws std::runtime_error with `named_by`, the path and the reason.
  [[noreturn]] void fail(const std::string& why) const;
  /// Writes the whole file at once.
  void write(std::string_view text) {
    append(text);
    place();
  }

 private:
  void require_written();

  std::string named_by_;
  std::string path_;
  std::string beside_;  ///< The path at which it is written first; empty once it is moved.
  std::ofstream file_;
};

/// Makes a folder, and its parents, if missing. Errors: std::invalid_argument as OutputFile.
void make_folder(const std::string& named_by, const std::filesystem::path& folder);

/// Throws std::invalid_argument if an output file is one of the command's inputs, also through
/// links. Ignores inputs that do not exist.
void require_no_input(const std::string& named_by, const std::string& path,
                      const std::vector<std::string>& inputs);

}  // namespace raycheck::tools
