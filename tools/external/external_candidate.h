#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "properties/candidate.h"
#include "tools/external/answer_store.h"
#include "tools/external/pictures/renderer.h"
#include "tools/external/protocol/protocol.h"
#include "tools/external/sandbox/process.h"
#include "tools/external/source_lines.h"
#include "tools/implementations/implementation.h"

namespace raycheck::tools {

class Pictures;

/// An external candidate: how to run it, and its introduction.
struct External {
  std::string name;  ///< "library:PATH.so", as on the command line.
  Confined program;
  Introduction introduction;
  /// The format in which it is judged: the one that it declares or, for a renderer, the user's
  /// choice.
  scene::Precision precision = scene::Precision::kDouble;
  std::string declares = {};  ///< What the user declares of it besides.
  /// The methods whose bounds apply to it, because it documents none.
  MethodPair bounds = kDefaultMethods;
  /// The shared library that its process loads; may be empty.
  std::filesystem::path library = {};
  /// Its source lines if raycheck compiled it; otherwise null.
  std::shared_ptr<const SourceLines> lines = {};
  /// The folder with copies of its source or of files named in its command line; may be null.
  std::shared_ptr<const PrivateFolder> copies = {};
  /// Set for renderers, which have no introduction.
  std::optional<Renderer> renderer = {};
  /// The program's folder if raycheck made it; otherwise null.
  std::shared_ptr<const PrivateFolder> folder;
  /// The renderer's latest pictures.
  std::shared_ptr<Pictures> pictures = {};
  std::shared_ptr<AnswerStore> answers = std::make_shared<AnswerStore>();
  /// Its source file, as named by the user; empty if its source is not a single file.
  std::string source_file = {};
  /// The files that the compiler read in its source's folder, named as by the user, and their
  /// digests.
  std::map<std::string, std::string> built_of = {};
};

/// Reads the program's introduction: from the store or, if it is not stored, by starting the
/// program once. Errors: CandidateError if the introduction is missing or invalid.
External introduced(std::string name, const Confined& program,
                    std::shared_ptr<const PrivateFolder> folder,
                    std::shared_ptr<AnswerStore> answers);

/// Declares more of the candidate than its code does, or in place of it: "from_inside start".
/// Errors: std::invalid_argument naming the statement; of a renderer only conventions and windows
/// are declared, and what functions return is declared in their code.
void declare_over(std::string_view statements, External& external);

External rendering(std::string name, Renderer renderer);

/// The renderer with another form of driver files.
External reading(const External& renderer, const DriverForm& driver);

/// The kind of the candidate's last failure.
using LastFailure = std::shared_ptr<std::optional<FailureKind>>;

/// A candidate that runs in a separate process, which never receives a reference answer. Its level
/// is kOrdinary unless it declares another. If the process ends, times out or sends a malformed
/// reply, the functions throw properties::CandidateFailed with the name of the function, and the
/// source line if it is known. A failed request is not sent again; the next request goes to a fresh
/// process. The functions throw properties::CandidateUnavailable if no process can be started, or
/// after time-outs that add up to kMostTimeouts times the time limit for a reply, in CPU time or in
/// waiting. Every failure sets `last`.
properties::Candidate external_candidate(const External& external,
                                         const LastFailure& last = nullptr);

/// The functions of an external shared library, called in raycheck's process without isolation. The
/// library is never unloaded, because threads that it started may still run. Errors: CandidateError
/// if the candidate is sandboxed or is not a shared library.
InProcess calls_in_process(const External& external);

/// The candidate as commands use it.
Implementation implementation_of(const External& external);

}  // namespace raycheck::tools
