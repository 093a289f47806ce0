// Includes that lead nowhere, or are missing.

#include <fmt/core.h>

#include <algorithm>
#include <boost/algorithm/string/replace.hpp>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <sstream>
#include <string_view>
#include <utility>

#include "tools/grade/intake/sources.h"
#include "tools/report/words.h"

namespace raycheck::tools {
namespace {

namespace fs = std::filesystem;

std::string normal(const fs::path& path) { return path.lexically_normal().generic_string(); }

/// The submission's files, found by the names that includes use for them.
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

  /// The file meant by a name that matches none.
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

/// "<Eigen/Dense>" for "../eigen-3.4/Eigen/Dense"; empty if it names neither library.
std::string library_header(const std::string& name) {
  for (const std::string library : {"unsupported/Eigen/", "Eigen/", "glm/"}) {
    const std::size_t at = name.rfind("/" + library);
    if (at != std::string::npos) return "<" + name.substr(at + 1) + ">";
  }
  return "";
}

/// The submission's file that a compiler calls so, from the folder where it was started or from /.
std::optional<std::string> file_called(const HandedInFiles& files, const std::string& said) {
  const std::string path = "/" + normal(said);
  for (const auto& [name, file] : files) {
    const std::string own = "/" + name;
    if (is_c_family(name) && (path.ends_with(own) || own.ends_with(path))) return name;
  }
  return {};
}

}  // namespace

std::string IncludeRepair::note() const {
  return line == 0 ? fmt::format("#include {} is added to {}, where it is missing", instead, file)
                   : fmt::format("{} is taken for {}", name, instead);
}

std::vector<IncludeRepair> missing_includes(const HandedInFiles& files, const std::string& said) {
  constexpr std::string_view kHint = "did you forget to ", kInclude = "#include ";
  std::set<std::pair<std::string, std::string>> found;
  std::istringstream lines(said);
  for (std::string line; std::getline(lines, line);) {
    const std::size_t hint = line.find(kHint), begin = line.find(kInclude, hint);
    const std::size_t end = line.find('>', begin);
    if (hint == std::string::npos || end == std::string::npos) continue;
    const std::size_t name = begin + kInclude.size();
    if (const auto file = file_called(files, line.substr(0, line.find(':')))) {
      found.emplace(*file, line.substr(name, end + 1 - name));
    }
  }
  std::vector<IncludeRepair> repairs;
  for (const auto& [file, header] : found) repairs.push_back({file, 0, "", header});
  return repairs;
}

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
      instead = boost::replace_all_copy(instead, special, "\\" + std::string(special));
    }
    const std::string script = repair.line == 0
                                   ? "1i#include " + repair.instead
                                   : fmt::format("{}s|.*|#include {}|", repair.line, instead);
    words += fmt::format("sed -i {} {}; ", single_quoted(script), single_quoted(repair.file));
  }
  return words;
}

}  // namespace raycheck::tools
