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

/// An external implementation, as named by `--candidate`: what to run, and its introduction from a
/// trial run.
struct External {
  std::string name;  ///< "library:PATH.so", as it was asked for.
  Confined program;
  Introduction introduction;
  /// The format that it is judged in: the one it declares or, for a renderer, the user's choice.
  scene::Precision precision = scene::Precision::kDouble;
  /// It documents no bounds: these methods' bounds apply to it.
  MethodPair bounds = kDefaultMethods;
  /// The shared library that its process loads; empty: there is none.
  std::filesystem::path library = {};
  /// The source lines of what was compiled here; else null.
  std::shared_ptr<const SourceLines> lines = {};
  /// The folder of the copies of its source, or of the files in its words, if there are any.
  std::shared_ptr<const PrivateFolder> copies = {};
  /// Renderers introduce themselves only by pictures.
  std::optional<Renderer> renderer = {};
  /// The program's folder, if raycheck made it.
  std::shared_ptr<const PrivateFolder> folder;
  /// What a renderer drew last.
  std::shared_ptr<Pictures> pictures = {};
  std::shared_ptr<AnswerStore> answers = std::make_shared<AnswerStore>();
  /// The file that it is made from, as named by the user; empty if that is not one file.
  std::string source_file = {};
  /// What the compiler read of a source's folder: names as the user's, and digests.
  std::map<std::string, std::string> built_of = {};
};

/// Starts the program once to hear its introduction, unless that is among the stored answers.
/// Errors: CandidateError if it gives none.
External introduced(std::string name, const Confined& program,
                    std::shared_ptr<const PrivateFolder> folder,
                    std::shared_ptr<AnswerStore> answers);

External rendering(std::string name, Renderer renderer);

/// The same renderer, given driver files of another form.
External reading(const External& renderer, const DriverForm& driver);

/// How a candidate failed last.
using LastFailure = std::shared_ptr<std::optional<FailureKind>>;

/// A candidate with a process of its own, which is never sent an answer. It is to be right on
/// ordinary cases where it states no other level. Where a process fails (ends, stays
/// silent, or replies what is no reply) the functions throw std::runtime_error with the name of the
/// function, and where its line is known properties::FailedAtLine; the next request goes to a fresh
/// process. A request that failed is not sent again, and none is sent after silences that together
/// took kMostSilences times the time for a reply: then, and where no process could be started, what
/// they throw is properties::CandidateUnavailable. Every failure sets `last`.
properties::Candidate external_candidate(const External& external,
                                         const LastFailure& last = nullptr);

/// The functions of someone else's shared library, called in raycheck's own process, where nothing
/// isolates it. It is loaded once and stays, since what it has started may still run.
/// Errors: CandidateError where it is isolated, or no such library.
InProcess calls_in_process(const External& external);

/// What commands judge of it.
Implementation implementation_of(const External& external);

}  // namespace raycheck::tools
