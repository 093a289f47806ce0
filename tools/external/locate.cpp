#include "tools/external/locate.h"

#include <fmt/core.h>

#include <algorithm>
#include <boost/tokenizer.hpp>
#include <map>
#include <system_error>
#include <utility>

#include "tools/external/compile.h"
#include "tools/external/sandbox/file_tree.h"
#include "tools/external/source_lines.h"
#include "tools/report/digest.h"

namespace raycheck::tools {
namespace {

namespace fs = std::filesystem;

fs::path existing(const std::string& path, const RunOptions& options) {
  std::error_code error;
  fs::path found = fs::canonical(options.folder / path, error);
  if (error == std::errc::no_such_file_or_directory) {
    throw CandidateError("there is no such file or folder");
  }
  if (error) throw CandidateError(error.message());
  return found;
}

/// A library as a candidate. It is copied to a folder that the candidate's user may read.
External library(const std::string& name, const fs::path& path, const RunOptions& options) {
  auto folder = std::make_shared<PrivateFolder>();
  // If it may read its own folder, it is not copied, because its rpath may begin with $ORIGIN.
  const bool stays = std::ranges::find(options.reads, path.parent_path()) != options.reads.end();
  const fs::path copy = stays ? path : folder->path() / path.filename();
  if (!stays) fs::copy_file(path, copy);
  open_to_others(folder->path());
  const std::string worker = helper("raycheck-worker");
  Confined program = options.confined();
  program.arguments = {worker, copy.string()};
  program.readable.insert(program.readable.end(), {worker, folder->path()});
  External external = introduced(name, program, std::move(folder), options.answers);
  external.library = copy;
  return external;
}

/// At most this many bytes are copied from a folder that other users may not read.
constexpr std::uintmax_t kMostCopied = std::uintmax_t{64} << 20;

/// Copies a folder that the candidate's user may not read.
void copy_for_others(const fs::path& from, const fs::path& to) {
  std::uintmax_t copied = 0;
  if (!fs::relative(to, from).string().starts_with("..")) {
    throw CandidateError(fmt::format(
        "other users may not read {}; put the program into a separate folder", from.string()));
  }
  for (const auto& entry : fs::recursive_directory_iterator(from)) {
    const fs::path target = to / fs::relative(entry.path(), from);
    const fs::file_status status = entry.symlink_status();
    if (fs::is_directory(status)) fs::create_directories(target);
    // Files that other users may not read are left out, unless the command line names them.
    if (!fs::is_regular_file(status) ||
        (status.permissions() & fs::perms::others_read) == fs::perms::none) {
      continue;
    }
    copied += entry.file_size();
    if (copied > kMostCopied) {
      throw CandidateError(fmt::format(
          "other users may not read {}, and it is too large to be copied; put the program "
          "into a separate folder, or choose sandbox none",
          from.string()));
    }
    fs::copy_file(entry.path(), target);
  }
  open_to_others(to);
}

/// Maps paths to paths that the candidate's user may read. Each folder that other users may not
/// read is copied once.
class ReadableCopies {
 public:
  explicit ReadableCopies(const Layers& layers) : own_user_(layers.own_user) {}
  /// The path of a file or folder, or of its copy.
  fs::path path_of(const fs::path& path) {
    const fs::path folder = folder_of(path);
    if (!own_user_ || others_may_read(folder)) return path;
    if (!copies_) {
      copies_ = std::make_shared<PrivateFolder>();
      open_to_others(copies_->path());
    }
    const auto [copy, is_new] =
        known_.try_emplace(folder, copies_->path() / std::to_string(known_.size()));
    if (is_new) {
      fs::create_directory(copy->second);
      copy_for_others(folder, copy->second);
    }
    if (folder == path) return copy->second;
    const fs::path file = copy->second / path.filename();
    if (!fs::exists(file)) {
      fs::copy_file(path, file);
      open_to_others(file);
    }
    return file;
  }
  static fs::path folder_of(const fs::path& path) {
    return fs::is_directory(path) ? path : path.parent_path();
  }
  /// The folder of the copies; null if nothing was copied.
  std::shared_ptr<const PrivateFolder> folder() const { return copies_; }

 private:
  bool own_user_;
  std::shared_ptr<PrivateFolder> copies_;
  std::map<fs::path, fs::path> known_;
};

/// The words of a command line, split as in a shell: quotes of both kinds keep spaces inside a
/// word.
std::vector<std::string> split(const std::string& text) {
  const boost::escaped_list_separator<char> separator("", " \t\n", "\"'");
  std::vector<std::string> words;
  for (const std::string& word : boost::tokenizer(text, separator)) {
    if (!word.empty()) words.push_back(word);
  }
  return words;
}

/// Lets a program read a folder, or a file's folder; never / or the folder for temporary files.
void let_read(const fs::path& path, Confined& program) {
  const fs::path folder = ReadableCopies::folder_of(path);
  const bool is_everyones = folder == "/" || folder == fs::temp_directory_path();
  if (!is_everyones) {
    program.readable.push_back(folder);
  } else if (folder != path) {
    program.readable.push_back(path);
  }
}

/// A Java class path (files or folders separated by colons), made absolute. Empty if the word is
/// not a class path.
std::string class_path(const std::string& word, const RunOptions& options, ReadableCopies& copies,
                       Confined& program) {
  if (word.find(':') == std::string::npos) return "";
  std::string paths;
  std::vector<fs::path> found;
  for (const std::string& part :
       boost::tokenizer(word, boost::char_separator<char>(":", "", boost::keep_empty_tokens))) {
    std::error_code error;
    const fs::path named = options.folder / part;
    if (part.empty() || !fs::exists(named, error)) return "";
    found.push_back(fs::absolute(named).lexically_normal());
  }
  for (const fs::path& one : found) {
    const fs::path path = copies.path_of(one);
    let_read(path, program);
    paths += (paths.empty() ? "" : ":") + path.string();
  }
  return paths;
}

/// The source file of a candidate: its source, or the first file in its command line.
std::string source_file(const CandidateSpec& spec, const RunOptions& options) {
  if (spec.kind == CandidateKind::kLibrary) return "";
  for (const std::string& word :
       spec.is_words() ? split(spec.what) : std::vector<std::string>{spec.what}) {
    std::error_code error;
    if (fs::is_regular_file(options.folder / word, error)) return word;
  }
  return "";
}

/// The program of a command line, with file names made absolute.
Confined program_of(const std::string& words, const RunOptions& options, ReadableCopies& copies) {
  Confined program = options.confined();
  for (const std::string& word : split(words)) {
    const bool is_program = program.arguments.empty();
    const bool is_bare = word.find('/') == std::string::npos;
    std::error_code error;
    const fs::path named = options.folder / word;
    if (is_program && is_bare && !is_on_path(word)) {
      throw CandidateError(fmt::format("there is no program '{}' in {}", word, program_path()));
    }
    if (is_program && !is_bare && !fs::exists(named, error)) {
      throw CandidateError(fmt::format("there is no program '{}'", word));
    }
    if (const auto paths = class_path(word, options, copies, program); !paths.empty()) {
      program.arguments.push_back(paths);
      continue;
    }
    // A first word without a slash is searched on the PATH. Links are not resolved, because a
    // program may depend on the name by which it is started.
    if ((is_program && is_bare) || !fs::exists(named, error)) {
      program.arguments.push_back(word);
      continue;
    }
    const fs::path path = copies.path_of(fs::absolute(named).lexically_normal());
    program.arguments.push_back(path);
    let_read(path, program);
  }
  if (program.arguments.empty()) {
    throw CandidateError("the command is empty; give a program");
  }
  return program;
}

External renderer(const CandidateSpec& spec, const RunOptions& options) {
  if (spec.what.find("{scene}") == std::string::npos) {
    throw CandidateError("{scene} is missing");
  }
  ReadableCopies copies(options.layers);
  const Confined program = program_of(spec.what, options, copies);
  Renderer found;
  found.program = program;
  found.wrapper = program;
  found.driver = options.driver;
  found.excused_change = options.excused_image_change;
  found.threshold = options.image_threshold;
  found.any_sample = options.any_sample;
  found.depth = options.depth;
  found.answers = options.answers;
  External external = rendering(spec.text(), std::move(found));
  external.precision = options.precision;
  external.copies = copies.folder();
  return external;
}

/// A path for messages: relative to the working folder if it is below that.
fs::path as_shown(const fs::path& path) {
  std::error_code error;
  const fs::path working = fs::current_path(error);
  const fs::path inside = error ? fs::path() : path.lexically_relative(working);
  return inside.empty() || *inside.begin() == ".." ? path : inside;
}

External find(const CandidateSpec& spec, const RunOptions& options) {
  ReadableCopies copies(options.layers);
  switch (spec.kind) {
    case CandidateKind::kLibrary:
      if (const fs::path file = existing(spec.what, options); fs::is_regular_file(file)) {
        return library(spec.text(), file, options);
      }
      throw CandidateError("it is not a file; give a shared library");
    case CandidateKind::kSource: {
      const PrivateFolder built;
      const fs::path named = existing(spec.what, options);
      const fs::path source = copies.path_of(named);
      const Compiled compiled = compile(source, built.path(), options);
      External external = library(spec.text(), compiled.library, options);
      for (const std::string& file : compiled.read) {
        const fs::path shown =
            fs::is_directory(source) ? fs::path(spec.what) : fs::path(spec.what).parent_path();
        external.built_of[(shown / file).lexically_normal().string()] =
            digest({file_bytes(source_folder(source) / file)});
      }
      external.lines =
          std::make_shared<SourceLines>(external.program, external.library, source_folder(source),
                                        as_shown(source_folder(named)));
      external.copies = copies.folder();
      return external;
    }
    case CandidateKind::kCommand: {
      const Confined program = program_of(spec.what, options, copies);
      External external = introduced(spec.text(), program, {}, options.answers);
      external.copies = copies.folder();
      return external;
    }
    case CandidateKind::kRenderer:
      break;
  }
  return renderer(spec, options);
}

template <class Find>
External named_in_errors(const CandidateSpec& spec, const RunOptions& options, const Find& found) {
  try {
    External external = found();
    external.bounds = options.bounds;
    return external;
  } catch (const CandidateError& error) {
    throw CandidateError(error.why(), error.output(), spec.text());
  }
}

}  // namespace

External find_external(const CandidateSpec& spec, const RunOptions& options) {
  External found = named_in_errors(spec, options, [&] { return find(spec, options); });
  found.source_file = source_file(spec, options);
  return found;
}

External compiled_external(const CandidateSpec& spec, const fs::path& path,
                           const RunOptions& options) {
  return named_in_errors(spec, options, [&] { return library(spec.text(), path, options); });
}

}  // namespace raycheck::tools
