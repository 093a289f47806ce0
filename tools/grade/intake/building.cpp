#include "tools/grade/intake/building.h"

#include <fmt/core.h>

#include <system_error>
#include <utility>
#include <vector>

#include "tools/external/compile.h"
#include "tools/grade/intake/as_it_comes.h"
#include "tools/grade/intake/build_plan.h"
#include "tools/grade/intake/quoting.h"
#include "tools/grade/rubric/rubric_files.h"
#include "tools/grade/store/store.h"
#include "tools/report/words.h"

namespace raycheck::tools {

namespace fs = std::filesystem;

Building::Building(const Form& form, const std::string& file, const CandidateSpec& program,
                   const fs::path& folder, const HandedInFiles& files, std::string contents)
    : form_(form),
      file_(file),
      program_(program),
      folder_(folder),
      files_(files),
      contents_(std::move(contents)) {}

bool Building::is_needed() const {
  return !form_.build.empty() || program_.kind == CandidateKind::kSource;
}

std::string Building::words() const {
  return with_mark(form_.build, "{file}", single_quoted(file_));
}

Built Building::run(const fs::path& to, const RunOptions& options) const {
  if (form_.builds_as_it_comes()) return build_as_it_comes(folder_, files_, to, options);
  const bool is_source = program_.kind == CandidateKind::kSource;
  const PrivateFolder made;
  fs::path from = folder_;
  if (!form_.build.empty()) {
    from = is_source ? made.path() : to;
    build(folder_, {words(), words()}, from, options);
    open_to_others(from);
  }
  if (!is_source) return {{""}, form_.build.empty() ? "" : words()};
  std::error_code error;
  const fs::path source = fs::canonical(from / program_.what, error);
  if (error) throw CandidateError(fmt::format("{}: {}", program_.what, error.message()));
  return {{compile(source, to, options).filename()}, form_.build.empty() ? "" : words()};
}

std::string Building::key(const Layers& layers) const {
  std::vector<std::string> texts = {toolchain(), layers.text(), contents_, words(),
                                    program_.text()};
  if (form_.builds_as_it_comes()) {
    for (const BuildAttempt& attempt : build_plan(files_).attempts) {
      for (const std::string* text : {&attempt.what, &attempt.words, &attempt.program}) {
        texts.push_back(*text);
      }
      texts.insert(texts.end(), attempt.made.begin(), attempt.made.end());
      texts.insert(texts.end(), attempt.notes.begin(), attempt.notes.end());
    }
  }
  return digest(texts);
}

std::string answers_key(const std::string& build, const CandidateSpec& program,
                        const Limits& limits) {
  return digest({build, program.text(),
                 fmt::format("{} {} {} {} {} {}", limits.seconds, limits.cpu_seconds, limits.memory,
                             limits.file, limits.files, limits.processes)});
}

}  // namespace raycheck::tools
