#include "tools/grade/intake/include_repairs.h"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>

#include "tools/grade/intake/quoting.h"
#include "tools/report/words.h"

namespace raycheck::tools {
namespace {

namespace fs = std::filesystem;

std::string normal(const fs::path& path) { return path.lexically_normal().generic_string(); }

/// The submission's files, found by whatever an include calls them.
class Headers {
 public:
  Headers(const HandedInFiles& files, const Vendored& vendored,
          const std::vector<std::string>& include)
      : files_(files), include_(include) {
    for (const auto& [name, file] : files) {
      by_lower_case_.try_emplace(lower_case(name), name);
      if (!vendored.has(name)) by_base_[lower_case(base_of(name))].push_back(name);
    }
  }

  bool are_found(const std::string& from, const std::string& name) const {
    return any_place(from, name, [&](const std::string& at) { return files_.contains(at); });
  }

  /// The file that is meant by a name under which none is found.
  std::optional<std::string> meant(const std::string& from, const std::string& name) const {
    std::optional<std::string> found;
    any_place(from, name, [&](const std::string& at) {
      const auto known = by_lower_case_.find(lower_case(at));
      if (known != by_lower_case_.end()) found = known->second;
      return found.has_value();
    });
    if (found) return found;
    const auto named = by_base_.find(lower_case(base_of(name)));
    if (named != by_base_.end() && named->second.size() == 1) return named->second.front();
    return {};
  }

 private:
  template <class Test>
  bool any_place(const std::string& from, const std::string& name, const Test& test) const {
    if (test(normal(fs::path(folder_of(from)) / name))) return true;
    return std::any_of(include_.begin(), include_.end(), [&](const std::string& folder) {
      return test(normal(fs::path(folder) / name));
    });
  }

  const HandedInFiles& files_;
  const std::vector<std::string>& include_;
  std::map<std::string, std::string> by_lower_case_;
  std::map<std::string, std::vector<std::string>> by_base_;
};

/// "<Eigen/Dense>" of "../eigen-3.4/Eigen/Dense"; empty where it names neither library.
std::string library_header(const std::string& name) {
  for (const std::string library : {"unsupported/Eigen/", "Eigen/", "glm/"}) {
    const std::size_t at = name.rfind("/" + library);
    if (at != std::string::npos) return "<" + name.substr(at + 1) + ">";
  }
  return "";
}

}  // namespace

std::vector<IncludeRepair> include_repairs(const HandedInFiles& files, const Vendored& vendored,
                                           const std::vector<std::string>& include) {
  const Headers headers(files, vendored, include);
  std::vector<IncludeRepair> repairs;
  for (const auto& [file, content] : files) {
    if (!is_c_family(file) || vendored.has(file)) continue;
    for (const IncludeLine& one : includes_of(content.text)) {
      if (headers.are_found(file, one.name)) continue;
      std::string name = one.name;
      std::replace(name.begin(), name.end(), '\\', '/');
      const std::string library = library_header(name);
      if (!library.empty()) {
        repairs.push_back({file, one.line, one.name, library});
        continue;
      }
      if (!one.is_quoted) continue;
      if (const auto meant = headers.meant(file, name)) {
        const fs::path from = "/" + folder_of(file);
        const std::string to = fs::path("/" + *meant).lexically_relative(from).generic_string();
        repairs.push_back({file, one.line, one.name, '"' + to + '"'});
      }
    }
  }
  return repairs;
}

std::string repair_words(const std::vector<IncludeRepair>& repairs) {
  std::string words;
  for (const IncludeRepair& repair : repairs) {
    std::string instead = repair.instead;
    for (const char* const special : {"\\", "&", "|"}) {
      instead = with_mark(instead, special, "\\" + std::string(special));
    }
    words += fmt::format("sed -i {} {}; ",
                         single_quoted(fmt::format("{}s|.*|#include {}|", repair.line, instead)),
                         single_quoted(repair.file));
  }
  return words;
}

}  // namespace raycheck::tools
