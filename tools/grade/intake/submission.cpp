#include "tools/grade/intake/submission.h"

#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <stdexcept>
#include <system_error>

#include "tools/grade/rubric/rubric_files.h"

namespace raycheck::tools {
namespace {

namespace fs = std::filesystem;

/// Absolute, with links resolved as far as the path exists.
fs::path resolved(const fs::path& path) {
  // "results/" has an empty last component.
  const fs::path whole = fs::weakly_canonical(fs::absolute(path));
  return whole.has_filename() ? whole : whole.parent_path();
}

/// Domain: both resolved.
bool is_in(const fs::path& path, const fs::path& folder) {
  return std::mismatch(folder.begin(), folder.end(), path.begin(), path.end()).first ==
         folder.end();
}

}  // namespace

std::vector<Submission> find_submissions(const std::vector<std::string>& paths,
                                         const std::vector<std::string_view>& reserved) {
  std::vector<Submission> found;
  std::map<std::string, std::string> known;
  for (const std::string& given : paths) {
    std::error_code error;
    // A link is not followed: it may lead to another's submission.
    fs::path path = fs::absolute(given).lexically_normal();
    if (!path.has_filename()) path = path.parent_path();
    if (!fs::exists(fs::symlink_status(path, error))) {
      throw std::invalid_argument(fmt::format("{}: there is no such file or folder", given));
    }
    const bool is_file = fs::is_regular_file(fs::symlink_status(path));
    const std::string name = is_file ? path.stem().string() : path.filename().string();
    if (std::find(reserved.begin(), reserved.end(), name) != reserved.end()) {
      throw std::invalid_argument(
          fmt::format("{}: rename it; the results of the class are called so", given));
    }
    const auto [other, is_new] = known.try_emplace(name, given);
    if (!is_new) {
      throw std::invalid_argument(
          fmt::format("{}: {} has the same name, {}", given, other->second, name));
    }
    found.push_back({name, path});
  }
  return found;
}

void require_disjoint(const std::string& out, const std::vector<Submission>& submissions) {
  std::vector<fs::path> handed_in;
  for (const Submission& each : submissions) handed_in.push_back(resolved(each.path));
  const auto require = [&](const fs::path& folder) {
    const fs::path results = resolved(folder);
    for (std::size_t k = 0; k < handed_in.size(); ++k) {
      const char* where = results == handed_in[k]        ? "is"
                          : is_in(handed_in[k], results) ? "holds"
                          : is_in(results, handed_in[k]) ? "lies in"
                                                         : nullptr;
      if (where == nullptr) continue;
      throw std::invalid_argument(
          fmt::format("out {}: {} {} {}, which is handed in; results take another folder", out,
                      folder.string(), where, submissions[k].path.string()));
    }
  };
  require(out);
  std::error_code ignored;
  for (const Submission& each : submissions) {
    // Others lie in `out` as it was looked at.
    const fs::path folder = fs::path(out) / each.name;
    if (fs::is_symlink(fs::symlink_status(folder, ignored))) require(folder);
  }
}

std::string digest(const Submission& submission, const SubmissionLimits& limits) {
  try {
    return digest_of(paths_of(submission.path, limits));
  } catch (const std::system_error& error) {
    if (is_of_the_machine(error.code())) throw;
    return digest({error.what()});
  } catch (const std::exception& error) {
    return digest({error.what()});
  }
}

}  // namespace raycheck::tools
