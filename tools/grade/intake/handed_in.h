#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tools/external/sandbox/private_folder.h"
#include "tools/grade/results/result.h"
#include "tools/grade/rubric/rubric.h"

namespace raycheck::tools {

/// A submission: a folder, or a single file.
struct Submission {
  std::string name;
  std::filesystem::path path;
};

/// The submissions, named after their files or folders.
/// Errors: std::invalid_argument if a path does not exist, two names are equal, or a name is
/// reserved.
std::vector<Submission> find_submissions(const std::vector<std::string>& paths,
                                         const std::vector<std::string_view>& reserved = {});

/// Throws std::invalid_argument if the folder of results, or a submission's folder in it, is a
/// submission, contains one or lies in one, also through links. The folder need not exist.
void require_disjoint(const std::string& out, const std::vector<Submission>& submissions);

/// A submitted file.
struct HandedInFile {
  std::string text;   ///< Its first 4 MiB.
  bool runs = false;  ///< It is executable.
};

/// Submitted files, by their paths in the submission: "src/rt.cpp".
using HandedInFiles = std::map<std::string, HandedInFile>;

/// The files and folders of a submission that are used.
struct HandedInPaths {
  /// The files, by their paths in the submission.
  std::map<std::string, std::filesystem::path> files;
  std::vector<std::string> folders;  ///< Paths in the submission, including empty folders.
};

/// The regular files of a submission, and its folders, without files that archives, editors and
/// compilers leave behind: __MACOSX, .git, virtual environments, objects, precompiled headers.
/// Links are not followed, because they may lead outside the submission. Errors:
/// std::invalid_argument if the path is neither a file nor a folder, or if the submission is too
/// large.
HandedInPaths paths_of(const std::filesystem::path& path, const SubmissionLimits& limits);

/// Descends while a folder contains nothing but one other folder, as unpacked archives do. Ignores
/// files that tools leave behind, and stops before a folder if `is_meant` is true for its name.
std::filesystem::path innermost(std::filesystem::path path,
                                const std::function<bool(const std::string& name)>& is_meant);

/// The code cells of a Jupyter notebook as one Python module. Lines with magics (% and !) become
/// `pass`; cells in other languages (%%bash) are left out. Empty if the text is not a notebook.
std::optional<std::string> notebook_module(std::string_view text);

/// Files whose content a human reader cannot judge and that may contain answers computed elsewhere:
/// programs, libraries, archives, pictures, large files, and texts with very long lines. Such files
/// are allowed. `paths`: the locations of the files.
std::vector<OpaqueFile> opaque_files(const HandedInFiles& files,
                                     const std::map<std::string, std::filesystem::path>& paths);

/// The folder in which a submission's renderer runs: the submission's folders and files. Left out
/// are pictures, which could be taken for its output, files named like the driver file or the
/// picture, and headers of Eigen and glm. `copy`: the folder with the files.
std::shared_ptr<const StartingFolder> run_folder(const HandedInFiles& files,
                                                 const std::vector<std::string>& folders,
                                                 std::shared_ptr<const PrivateFolder> copy);

}  // namespace raycheck::tools
