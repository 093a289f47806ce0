#pragma once

#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

namespace raycheck::tools {

/// A file that an option or a field names, which appears completely or not at all: it is written
/// beside its place and then moved there. The constructor opens it, so that hours of work do not
/// end with a file that cannot be written.
class OutputFile {
 public:
  /// `named_by` is its name in errors: "--out" if an option names it, "out" if a field does. Throws
  /// std::invalid_argument naming `named_by`, the path and what is wrong with it.
  OutputFile(std::string named_by, std::string path);
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;
  /// Removes the file unless place() was called.
  ~OutputFile();

  /// Writes the next part of the file. Throws std::runtime_error on failure.
  void append(std::string_view bytes);
  /// Moves the file to its place; the last call. Throws as append().
  void place();
  /// Throws std::runtime_error that names `named_by`, the path and why it was not written.
  [[noreturn]] void fail(const std::string& why) const;
  /// Writes the whole file, and moves it to its place.
  void write(std::string_view text) {
    append(text);
    place();
  }

 private:
  void require_written();

  std::string named_by_;
  std::string path_;
  std::string beside_;  ///< The path to which it is written first; empty once moved.
  std::ofstream file_;
};

/// Makes a folder, and its parents, if missing. Errors: std::invalid_argument as for OutputFile.
void make_folder(const std::string& named_by, const std::filesystem::path& folder);

/// Throws std::invalid_argument if an output file is one of the inputs of the same command, also
/// through links. Inputs that do not exist are ignored.
void require_no_input(const std::string& named_by, const std::string& path,
                      const std::vector<std::string>& inputs);

}  // namespace raycheck::tools
