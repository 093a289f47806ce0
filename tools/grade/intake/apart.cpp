#include "tools/grade/intake/apart.h"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>
#include <system_error>

namespace raycheck::tools {
namespace {

namespace fs = std::filesystem;

/// Absolute and without links, as far as it is there.
fs::path resolved(const fs::path& path) {
  // "results/" has an empty last part.
  const fs::path whole = fs::weakly_canonical(fs::absolute(path));
  return whole.has_filename() ? whole : whole.parent_path();
}

/// Both resolved.
bool is_in(const fs::path& path, const fs::path& folder) {
  return std::mismatch(folder.begin(), folder.end(), path.begin(), path.end()).first ==
         folder.end();
}

}  // namespace

void require_apart(const std::string& out, const std::vector<Submission>& submissions) {
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

}  // namespace raycheck::tools
