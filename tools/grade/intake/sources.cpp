#include "tools/grade/intake/sources.h"

#include <fmt/core.h>

#include <array>
#include <boost/algorithm/string/case_conv.hpp>
#include <boost/algorithm/string/replace.hpp>
#include <cctype>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <sstream>
#include <utility>

#include "scene/text.h"
#include "tools/report/words.h"

namespace raycheck::tools {
namespace {

constexpr std::array<std::string_view, 5> kCpp = {".cpp", ".cc", ".cxx", ".c++", ".C"};
constexpr std::array<std::string_view, 7> kHeaderEndings = {".h",   ".hh",  ".hpp", ".hxx",
                                                            ".h++", ".ipp", ".inl"};

}  // namespace

std::string shell_words(const std::vector<std::string>& names) {
  return scene::joined(names, " ", single_quoted);
}

std::string candidate_word(const std::string& name) {
  const char quote = name.find('"') == std::string::npos ? '"' : '\'';
  return name.find_first_of(" \t\"'") == std::string::npos ? name : quote + name + quote;
}

std::string folder_of(const std::string& path) {
  const std::size_t slash = path.rfind('/');
  return slash == std::string::npos ? "" : path.substr(0, slash);
}

std::string base_of(const std::string& path) { return path.substr(path.rfind('/') + 1); }

std::string ending_of(const std::string& path) {
  const std::string base = base_of(path);
  const std::size_t dot = base.rfind('.');
  if (dot == std::string::npos) return "";
  const std::string ending = base.substr(dot);
  return ending == ".C" ? ending : boost::to_lower_copy(ending);
}

bool is_cpp(const std::string& path) { return is_one_of(kCpp, ending_of(path)); }

bool is_c_or_cpp(const std::string& path) { return is_cpp(path) || ending_of(path) == ".c"; }

bool is_c_family(const std::string& path) {
  return is_c_or_cpp(path) || is_one_of(kHeaderEndings, ending_of(path));
}

std::string without_comments(std::string_view text) {
  std::string kept;
  kept.reserve(text.size());
  for (std::size_t at = 0; at < text.size();) {
    const std::string_view rest = text.substr(at);
    if (rest.starts_with("//")) {
      at = std::min(text.find('\n', at), text.size());
    } else if (rest.starts_with("/*")) {
      const std::size_t end = std::min(text.find("*/", at + 2), text.size());
      kept.append(static_cast<std::size_t>(std::count(text.begin() + static_cast<long>(at),
                                                      text.begin() + static_cast<long>(end), '\n')),
                  '\n');
      at = std::min(end + 2, text.size());
    } else if (rest[0] == '"') {
      // Comment signs inside a string are not comments.
      std::size_t end = at + 1;
      while (end < text.size() && text[end] != '"' && text[end] != '\n') {
        end += text[end] == '\\' ? 2 : 1;
      }
      end = std::min(end + 1, text.size());
      kept.append(text.substr(at, end - at));
      at = end;
    } else {
      kept += text[at++];
    }
  }
  return kept;
}

// A regular expression would recurse once for each space, even in a file that has a million.
std::vector<std::string_view> words_of_code(std::string_view text) {
  const auto is_of_name = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '.';
  };
  std::vector<std::string_view> words;
  for (std::size_t at = 0; at < text.size();) {
    std::size_t end = at;
    while (end < text.size() && is_of_name(text[end])) ++end;
    if (end == at) ++end;
    if (std::isspace(static_cast<unsigned char>(text[at])) == 0) {
      words.push_back(text.substr(at, end - at));
    }
    at = end;
  }
  return words;
}

bool defines_main(std::string_view given) {
  constexpr std::array<std::string_view, 4> kTypes = {"int", "void", "auto", "signed"};
  const std::string text = without_comments(given);
  const std::vector<std::string_view> words = words_of_code(text);
  for (std::size_t k = 1; k + 1 < words.size(); ++k) {
    if (words[k] == "main" && words[k + 1] == "(" && is_one_of(kTypes, words[k - 1])) return true;
  }
  return false;
}

std::vector<IncludeLine> includes_of(std::string_view given) {
  std::vector<IncludeLine> found;
  const std::string text = without_comments(given);
  int line = 0;
  for (std::size_t at = 0; at < text.size(); ++line) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    const std::string_view one = std::string_view(text).substr(at, end - at);
    at = end + 1;
    std::size_t hash = one.find_first_not_of(" \t");
    if (hash == std::string_view::npos || one[hash] != '#') continue;
    hash = one.find_first_not_of(" \t", hash + 1);
    if (hash == std::string_view::npos || !one.substr(hash).starts_with("include")) continue;
    const std::size_t begin = one.find_first_of("\"<", hash);
    if (begin == std::string_view::npos) continue;
    const bool is_quoted = one[begin] == '"';
    const std::size_t close = one.find(is_quoted ? '"' : '>', begin + 1);
    if (close == std::string_view::npos) continue;
    found.push_back({line + 1, std::string(one.substr(begin + 1, close - begin - 1)), is_quoted});
  }
  return found;
}

bool Vendored::has(const std::string& path) const {
  return std::ranges::any_of(
      folders, [&](const std::string& folder) { return path.starts_with(folder + "/"); });
}

Vendored vendored_in(const HandedInFiles& files) {
  Vendored vendored;
  for (const auto& [name, file] : files) {
    const std::string folder = folder_of(name);
    const std::string base = base_of(name);
    const bool is_eigen = base == "Dense" && base_of(folder) == "Eigen";
    const bool is_glm = base == "glm.hpp" && base_of(folder) == "glm";
    if (!is_eigen && !is_glm) continue;
    const std::string around = folder_of(folder);
    vendored.include.push_back(around.empty() ? "." : around);
    // The whole package belongs to the library: "eigen-3.4.0" has tests and examples, too.
    const std::string called = boost::to_lower_copy(base_of(around));
    const bool is_package = !around.empty() && called.starts_with(is_eigen ? "eigen" : "glm");
    vendored.folders.push_back(is_package ? around : folder);
    if (is_eigen && !is_package) {
      vendored.folders.push_back((around.empty() ? "" : around + "/") + std::string("unsupported"));
    }
  }
  return vendored;
}

bool is_aside(const std::string& path) {
  constexpr std::array<std::string_view, 9> kAside = {
      "test", "tests", "example", "examples", "node_modules", "old", "backup", "doc", "docs"};
  for (const std::filesystem::path& one :
       std::filesystem::path(boost::to_lower_copy(folder_of(path)))) {
    const std::string folder = one.string();
    if (is_one_of(kAside, folder) || folder == "build" || folder.starts_with("build-") ||
        folder.starts_with("build_") || folder.starts_with("cmake-build")) {
      return true;
    }
  }
  return false;
}

int likelihood_rank(const std::string& path) {
  std::string stem = boost::to_lower_copy(base_of(path));
  stem.resize(std::min(stem.rfind('.'), stem.size()));
  for (const char* const other : {"test", "old", "backup", "copy", "example", "demo", "convert",
                                  "compare", "setup", "plot"}) {
    if (stem.find(other) != std::string::npos) return kHardlyARenderer;
  }
  constexpr std::array<std::string_view, 8> kFirst = {
      "rt", "raytracer", "ray_tracer", "raytrace", "raycaster", "renderer", "render", "tracer"};
  if (is_one_of(kFirst, stem)) return 0;
  if (stem == "main" || stem == "__main__" || stem == "index" || stem == "app") return 1;
  for (const char* const other : {"ray", "trace", "render", "main"}) {
    if (stem.find(other) != std::string::npos) return 2;
  }
  return 3;
}

void sort_by_likelihood(std::vector<std::string>& names) {
  const auto key = [](const std::string& name) {
    return std::tuple(likelihood_rank(name), std::ranges::count(name, '/'), name);
  };
  std::ranges::sort(names, {}, key);
}

namespace {

namespace fs = std::filesystem;

std::string normal(const fs::path& path) { return path.lexically_normal().generic_string(); }

/// Finds the submission's files by the names in includes.
class Headers {
 public:
  Headers(const HandedInFiles& files, const Vendored& vendored,
          const std::vector<std::string>& include)
      : files_(files), include_(include) {
    for (const auto& [name, file] : files) {
      by_lower_case_.try_emplace(boost::to_lower_copy(name), name);
      if (!vendored.has(name)) by_base_[boost::to_lower_copy(base_of(name))].push_back(name);
    }
  }

  bool are_found(const std::string& from, const std::string& name) const {
    return any_place(from, name, [&](const std::string& at) { return files_.contains(at); });
  }

  /// The file that is probably meant by a name that matches no file.
  std::optional<std::string> meant(const std::string& from, const std::string& name) const {
    std::optional<std::string> found;
    any_place(from, name, [&](const std::string& at) {
      const auto known = by_lower_case_.find(boost::to_lower_copy(at));
      if (known != by_lower_case_.end()) found = known->second;
      return found.has_value();
    });
    if (found) return found;
    const auto named = by_base_.find(boost::to_lower_copy(base_of(name)));
    if (named != by_base_.end() && named->second.size() == 1) return named->second.front();
    return {};
  }

 private:
  template <class Test>
  bool any_place(const std::string& from, const std::string& name, const Test& test) const {
    if (test(normal(fs::path(folder_of(from)) / name))) return true;
    return std::ranges::any_of(
        include_, [&](const std::string& folder) { return test(normal(fs::path(folder) / name)); });
  }

  const HandedInFiles& files_;
  const std::vector<std::string>& include_;
  std::map<std::string, std::string> by_lower_case_;
  std::map<std::string, std::vector<std::string>> by_base_;
};

/// "<Eigen/Dense>" for "../eigen-3.4/Eigen/Dense"; empty if the name belongs to neither library.
std::string library_header(const std::string& name) {
  for (const std::string library : {"unsupported/Eigen/", "Eigen/", "glm/"}) {
    const std::size_t at = name.rfind("/" + library);
    if (at != std::string::npos) return "<" + name.substr(at + 1) + ">";
  }
  return "";
}

/// The submission's file that a compiler names by a relative or absolute path.
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
  return fmt::format("#include of {} is replaced by {}", name, instead);
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
      std::ranges::replace(name, '\\', '/');
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
    const std::string script = fmt::format("{}s|.*|#include {}|", repair.line, instead);
    words += fmt::format("sed -i {} {}; ", single_quoted(script), single_quoted(repair.file));
  }
  return words;
}

namespace {

/// Headers, and names of theirs for which GCC 12 suggests none.
struct HeaderNames {
  std::string_view header, names;
};
constexpr HeaderNames kHeaderNames[] = {
    {"<algorithm>",
     " all_of any_of clamp copy count count_if fill find find_if for_each lower_bound max "
     "max_element min min_element none_of nth_element random_shuffle remove remove_if reverse "
     "shuffle sort stable_sort swap transform unique upper_bound "},
    {"<cmath>",
     " M_PI acos asin atan atan2 cbrt ceil cos exp fabs floor fmax fmin fmod hypot isinf isnan log "
     "pow round sin sqrt tan "},
    {"<cstdlib>", " abs atof atoi exit rand srand strtod "},
    {"<iomanip>", " setfill setprecision setw "},
    {"<limits>", " numeric_limits "},
    {"<numeric>", " accumulate inner_product iota partial_sum "},
    {"<random>", " default_random_engine mt19937 uniform_real_distribution "},
    {"<stdexcept>", " invalid_argument out_of_range runtime_error "}};

/// The text between the last `before` before `after`, and the first `after`; empty if they are not
/// there.
std::string between(const std::string& line, std::string_view before, std::string_view after) {
  const std::size_t end = line.find(after);
  if (end == std::string::npos) return "";
  const std::string until = line.substr(0, end);
  const std::size_t begin = until.rfind(before);
  return begin == std::string::npos ? "" : until.substr(begin + before.size());
}

/// The line that a line of GCC's output says is missing from a file; empty if it says nothing.
std::string missing_line(const std::string& line) {
  constexpr std::string_view kDefine = "#define ";
  constexpr std::pair<std::string_view, std::string_view> kUnknown[] = {
      {"'", "' is not a member of 'std'"},
      {"'", "' was not declared in this scope"},
      {"incomplete type 'std::", "<"}};
  const std::string asked = between(line, "did you forget to '", "'?");
  if (!asked.empty()) return asked;
  if (const std::size_t at = line.find(kDefine, line.find("#error")); at != std::string::npos) {
    return line.substr(at, line.find_first_of(" \"", at + kDefine.size()) - at);
  }
  for (const auto& [before, after] : kUnknown) {
    const std::string name = between(line, before, after);
    if (name.empty()) continue;
    for (const auto& [header, names] : kHeaderNames) {
      if (names.find(" " + name + " ") != std::string_view::npos) {
        return fmt::format("#include {}", header);
      }
    }
  }
  return "";
}

struct OptionHint {
  std::string_view sign, option, why;
};
constexpr OptionHint kOptionHints[] = {
    {": multiple definition of ", "-fcommon", "several of its files define the same variable"},
    {"[-fpermissive]", "-fpermissive", "GCC names this option for some of its errors"}};

}  // namespace

std::vector<BuildHint> hints_in(const std::string& said, const HandedInFiles& files,
                                bool takes_options) {
  std::set<std::pair<std::string, std::string>> missing;
  std::optional<std::string> includer;  // of a header that is not the submission's
  std::string text = said;
  for (const char* quote : {"\xe2\x80\x98", "\xe2\x80\x99"}) boost::replace_all(text, quote, "'");
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    const bool is_first = line.starts_with("In file included from ");
    if (is_first || line.starts_with("                 from ")) {
      if (is_first) includer.reset();
      if (!includer) includer = file_called(files, between(line, "from ", ":"));
      continue;
    }
    const std::string lacks = missing_line(line);
    if (lacks.empty()) continue;
    const auto file = file_called(files, line.substr(0, line.find(':')));
    if (file || includer) missing.emplace(file ? *file : *includer, lacks);
  }
  std::vector<BuildHint> hints;
  for (const auto& [file, line] : missing) {
    hints.push_back({fmt::format("sed -i {} {}; ", single_quoted("1i" + line), single_quoted(file)),
                     fmt::format("the missing {} is added to {}", line, file)});
  }
  for (const auto& [sign, option, why] : kOptionHints) {
    if (!takes_options || said.find(sign) == std::string::npos) continue;
    hints.push_back({fmt::format("also=\"{} {}\"; ", kHintedOptions, option),
                     fmt::format("compiled with {}: {}", option, why)});
  }
  return hints;
}

}  // namespace raycheck::tools
