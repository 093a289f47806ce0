#pragma once

#include <filesystem>
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

/// Someone else's implementation, as `--candidate` names it: what to run, and what that said of
/// itself when it was tried.
struct External {
  std::string name;  ///< "library:PATH.so", as it was asked for.
  Confined program;
  Introduction introduction;
  /// The format that it is asked and judged in: its own word, or, of a renderer, the user's.
  scene::Precision precision = scene::Precision::kDouble;
  /// It documents no bounds: these are what its errors are held to.
  MethodPair bounds = kDefaultMethods;
  /// The shared library that its process loads; empty: there is none.
  std::filesystem::path library = {};
  /// Of what was compiled here: the lines of its source; else null.
  std::shared_ptr<const SourceLines> lines = {};
  /// What a copy of its source lies in, where there is one.
  std::shared_ptr<const PrivateFolder> copies = {};
  /// A renderer introduces itself by pictures alone.
  std::optional<Renderer> renderer = {};
  /// What the program lies in, where raycheck made that.
  std::shared_ptr<const PrivateFolder> folder;
  /// What a renderer drew last.
  std::shared_ptr<Pictures> pictures = {};
  /// What its functions replied in earlier runs; null: they are always asked.
  std::shared_ptr<AnswerStore> answers = {};
  /// The file that it is made of, as it was named; empty where that is not one file.
  std::string source_file = {};
};

/// Starts the program once to hear its introduction, where that is not among the answers.
/// Errors: CandidateError where it has none.
External introduced(std::string name, const Confined& program,
                    std::shared_ptr<const PrivateFolder> folder = nullptr,
                    std::shared_ptr<AnswerStore> answers = nullptr);

External rendering(std::string name, Renderer renderer);

/// The same renderer, given driver files of another form.
External reading(const External& renderer, const DriverForm& driver);

/// How a candidate failed when it last did.
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

/// What commands judge of it.
Implementation implementation_of(const External& external);

}  // namespace raycheck::tools
