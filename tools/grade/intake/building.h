#pragma once

#include <filesystem>
#include <string>

#include "tools/external/locate.h"
#include "tools/grade/intake/handed_in.h"
#include "tools/grade/rubric/rubric.h"
#include "tools/grade/store/store.h"

namespace raycheck::tools {

/// How a submission is built by its form: by the form's words, as it comes, or as a library of
/// functions; some need nothing.
class Building {
 public:
  /// `file`: what says that the form fits; `program`: what the form makes of it; `folder`: a copy
  /// of the submission, with these files; `contents`: their digest. They outlast it.
  Building(const Form& form, const std::string& file, const CandidateSpec& program,
           const std::filesystem::path& folder, const HandedInFiles& files, std::string contents);

  bool is_needed() const;
  /// Builds it in the empty folder `to`. Errors: CandidateError with what a compiler said.
  Built run(const std::filesystem::path& to, const RunOptions& options) const;
  /// A digest of all that what is built depends on: the files, what is run on them, compilers, and
  /// raycheck's version.
  std::string key(const Layers& layers) const;

 private:
  std::string words() const;

  const Form& form_;
  const std::string& file_;
  const CandidateSpec& program_;
  const std::filesystem::path& folder_;
  const HandedInFiles& files_;
  std::string contents_;
};

/// A digest of all that the answers of what was built depend on, the requests aside.
std::string answers_key(const std::string& build, const CandidateSpec& program,
                        const Limits& limits);

}  // namespace raycheck::tools
