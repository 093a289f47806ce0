// Ways to build by Makefiles and CMake, and to compile plain C and C++ sources.

#include <fmt/core.h>

#include <algorithm>
#include <boost/algorithm/string/case_conv.hpp>
#include <cctype>
#include <filesystem>
#include <set>
#include <sstream>

#include "scene/text.h"
#include "tools/grade/intake/building.h"
#include "tools/grade/intake/sources.h"
#include "tools/report/words.h"

namespace raycheck::tools {
namespace {

constexpr const char* kSystemEigen = "/usr/include/eigen3";
/// At most this many files with a main() are tried.
constexpr std::size_t kMostMains = 3;

/// The folders with headers: those of the submission, and those of libraries in it.
std::vector<std::string> include_folders(const HandedInFiles& files, const Vendored& vendored) {
  std::vector<std::string> folders = {"."};
  const auto add = [&](const std::string& folder) {
    if (!is_one_of(folders, folder)) folders.push_back(folder);
  };
  for (const auto& [name, file] : files) {
    const bool is_header = is_c_family(name) && !is_c_or_cpp(name);
    if (!is_header || vendored.has(name) || folder_of(name).empty()) continue;
    add(folder_of(name));
    // "include/math/vec.h" may be included as "math/vec.h".
    add(folder_of(folder_of(name)).empty() ? "." : folder_of(folder_of(name)));
  }
  for (const std::string& folder : vendored.include) add(folder);
  return folders;
}

/// The submission's C and C++: include folders, repairs and search paths.
struct CSources {
  explicit CSources(const HandedInFiles& files)
      : vendored(vendored_in(files)),
        include(include_folders(files, vendored)),
        repairs(include_repairs(files, vendored, include)) {}

  std::vector<std::string> notes() const {
    std::set<std::string> notes;
    for (const IncludeRepair& repair : repairs) notes.insert(repair.note());
    return {notes.begin(), notes.end()};
  }
  /// Environment variables for compilers that a Makefile calls. These folders are searched after
  /// those that it names.
  std::string search_path() const {
    std::string path = "export CPATH=";
    for (const std::string& folder : include) path += "\"$PWD\"/" + single_quoted(folder) + ":";
    return path + kSystemEigen + "; ";
  }
  std::string flags() const {
    std::string flags;
    for (const std::string& folder : include) flags += "-I " + single_quoted(folder) + " ";
    return flags + "-I " + kSystemEigen;
  }

  Vendored vendored;
  std::vector<std::string> include;
  std::vector<IncludeRepair> repairs;
};

/// A shell command that removes submitted programs, which could be mistaken for the build's result,
/// and dependency files, which name files of another machine.
std::string removal_words(const HandedInFiles& files) {
  std::vector<std::string> stale;
  for (const auto& [name, file] : files) {
    const bool is_program = is_elf(file.text) && name.find(".so") == std::string::npos;
    const bool is_dependencies = ending_of(name) == ".d" || base_of(name) == ".depend";
    if (is_program || is_dependencies) stale.push_back(name);
  }
  return stale.empty() ? "" : "rm -f -- " + shell_words(stale) + "; ";
}

/// The file with one of these names that is nearest to the top; empty if there is none, or if two
/// are equally near.
std::string top_file(const HandedInFiles& files, const std::vector<std::string>& names,
                     const Vendored& vendored) {
  std::vector<std::string> found;
  const auto depth = [](const std::string& name) { return std::ranges::count(name, '/'); };
  for (const auto& [name, file] : files) {
    const bool is_named = is_one_of(names, base_of(name));
    const bool is_generated = file.text.find("CMAKE generated file") != std::string::npos;
    if (is_named && !is_generated && !vendored.has(name) && !is_aside(name)) found.push_back(name);
  }
  if (found.empty()) return "";
  std::ranges::stable_sort(found, {}, depth);
  const std::string folder = folder_of(found.front());
  for (const std::string& other : found) {
    if (depth(other) == depth(found.front()) && folder_of(other) != folder) return "";
  }
  // make prefers them in this order.
  for (const std::string& name : names) {
    const std::string path = folder.empty() ? name : folder + "/" + name;
    if (is_one_of(found, path)) return path;
  }
  return found.front();
}

/// Likely names of a Makefile's program: the values of its variables, and its targets, in order.
std::vector<std::string> made_by(const std::string& makefile) {
  std::vector<std::string> names;
  std::istringstream lines(makefile);
  for (std::string line; std::getline(lines, line);) {
    if (line.empty() || line[0] == '\t' || line[0] == '#' || line[0] == '.') continue;
    const std::size_t mark = line.find_first_of(":=");
    if (mark == std::string::npos) continue;
    const bool is_rule = line[mark] == ':' && line.substr(mark, 2) != ":=";
    std::istringstream words(is_rule ? line.substr(0, mark)
                                     : line.substr(line.find('=', mark) + 1));
    for (std::string word; words >> word;) names.push_back(base_of(word));
  }
  return names;
}

/// The linker options in the Makefiles of a submission, each if this machine has its library, as
/// words of a shell.
std::string libraries_of_makefiles(const HandedInFiles& files) {
  std::set<std::string> linked;
  for (const auto& [name, file] : files) {
    if (boost::to_lower_copy(base_of(name)) != "makefile") continue;
    std::istringstream words(file.text);
    const auto is_name = [](unsigned char c) { return std::isalnum(c) != 0 || c == '_'; };
    for (std::string word; words >> word;) {
      if (word.starts_with("-l") && std::all_of(word.begin() + 2, word.end(), is_name))
        linked.insert(word);
    }
  }
  std::string libraries;
  for (const std::string& one : linked) {
    libraries += fmt::format(" $(gcc -shared -o /dev/null {0} 2> /dev/null && echo {0})", one);
  }
  return libraries;
}

/// Options that a header needs, if a header of the system is installed: of the same library, or of
/// the one that it uses.
struct HeaderOptions {
  std::string_view header, installed, options;
};
constexpr HeaderOptions kHeaderOptions[] = {{"omp.h", "", "-fopenmp"},
                                            {"execution", "tbb/tbb.h", "-ltbb"},
                                            {"CImg.h", "X11/Xlib.h", "-lX11"},
                                            {"CImg.h", "png.h", "-lpng"},
                                            {"CImg.h", "jpeglib.h", "-ljpeg"},
                                            {"FreeImage.h", "FreeImage.h", "-lfreeimage"},
                                            {"GL/freeglut.h", "GL/glut.h", "-lglut -lGLU -lGL"},
                                            {"GL/glut.h", "GL/glut.h", "-lglut -lGLU -lGL"},
                                            {"GL/gl.h", "GL/gl.h", "-lGL"},
                                            {"X11/Xlib.h", "X11/Xlib.h", "-lX11"},
                                            {"jpeglib.h", "jpeglib.h", "-ljpeg"},
                                            {"png.h", "png.h", "-lpng"},
                                            {"zlib.h", "zlib.h", "-lz"}};

/// The linker options that the sources need; adds a note about those of headers.
std::string libraries_of(const HandedInFiles& files, const std::vector<std::string>& sources,
                         std::vector<std::string>& notes) {
  std::string of_headers;
  std::set<std::string, std::less<>> headers;
  for (const auto& [name, file] : files) {
    if (!is_c_family(name)) continue;
    for (const IncludeLine& one : includes_of(file.text)) {
      headers.insert(base_of(one.name) == "CImg.h" ? "CImg.h" : one.name);
    }
  }
  const bool is_mixed =
      std::ranges::any_of(sources, is_cpp) && !std::ranges::all_of(sources, is_cpp);
  for (const auto& [header, installed, options] : kHeaderOptions) {
    if (!headers.contains(header) || of_headers.find(options) != std::string::npos) continue;
    if (!std::filesystem::exists(std::filesystem::path("/usr/include") / installed)) continue;
    of_headers += fmt::format(" {}", options);
  }
  if (!of_headers.empty()) {
    notes.push_back(fmt::format("built with{}, which its headers need", of_headers));
  }
  return fmt::format("-pthread -lm{}{}{}", is_mixed ? " -lstdc++" : "", of_headers,
                     libraries_of_makefiles(files));
}

std::string names_shown(const std::vector<std::string>& names) {
  if (names.size() > 3) return fmt::format("{} and {} more", names.front(), names.size() - 1);
  return scene::joined(names, " ");
}

/// Compiles and links these sources with the first C++ standard that works. If none works, shows
/// the errors with the newest.
BuildAttempt compiled(const HandedInFiles& files, const CSources& c, const std::string& what,
                      const std::vector<std::string>& sources) {
  constexpr const char* kProgram = "raycheck-built";
  const bool has_cpp = std::ranges::any_of(sources, is_cpp);
  const bool all_cpp = std::ranges::all_of(sources, is_cpp);
  const std::string compiler = all_cpp ? "g++" : "gcc";
  const std::string first = has_cpp ? "c++20" : "gnu17";
  std::vector<std::string> notes = c.notes();
  const std::string rest =
      fmt::format("-O2 -w -fmax-errors=20 {} {} -o {} {} {}", c.flags(), kHintedOptions, kProgram,
                  shell_words(sources), libraries_of(files, sources, notes));
  const std::string standards = has_cpp ? first + " gnu++17 gnu++14" : first;
  std::string words = fmt::format(
      "rm -f {0}; for standard in {1}; do {2} -std=$standard {3} 2> raycheck-said-$standard && "
      "break; done; test -e {0} || {{ cat raycheck-said-{4} >&2; false; }}",
      kProgram, standards, compiler, rest, first);
  return {what,
          fmt::format("{} -O2 -std={} {}", compiler, first, names_shown(sources)),
          removal_words(files) + repair_words(c.repairs),
          std::move(words),
          std::string(kMade),
          {kProgram},
          std::move(notes)};
}

/// A source and the sources that belong to the headers that it includes: "vec.cpp" for "vec.h".
std::vector<std::string> reached_from(const std::string& main, const HandedInFiles& files,
                                      const std::vector<std::string>& others) {
  const auto stem = [](const std::string& name) {
    const std::string base = boost::to_lower_copy(base_of(name));
    return base.substr(0, base.rfind('.'));
  };
  std::set<std::string> stems, seen = {main};
  std::vector<std::string> open = {main};
  while (!open.empty()) {
    const std::string from = open.back();
    open.pop_back();
    for (const IncludeLine& one : includes_of(files.at(from).text)) stems.insert(stem(one.name));
    for (const auto& [name, file] : files) {
      if (is_c_family(name) && stems.contains(stem(name)) && seen.insert(name).second) {
        open.push_back(name);
      }
    }
  }
  std::vector<std::string> reached = {main};
  for (const std::string& other : others) {
    if (seen.contains(other)) reached.push_back(other);
  }
  return reached;
}

}  // namespace

void plan_recipes(const HandedInFiles& files, std::vector<BuildAttempt>& plan) {
  const CSources c(files);
  const std::string repairs = removal_words(files) + repair_words(c.repairs);
  const auto folder = [](const std::string& path) {
    return folder_of(path).empty() ? "." : folder_of(path);
  };
  const std::string make =
      top_file(files, {"GNUmakefile", "makefile", "Makefile", "MAKEFILE"}, c.vendored);
  if (!make.empty()) {
    plan.push_back(
        {"its " + make, folder(make) == "." ? "make" : "make -C " + folder(make), repairs,
         c.search_path() + "cd " + single_quoted(folder(make)) + " && make -f " +
             single_quoted(base_of(make)),
         std::string(kMade), made_by(files.at(make).text), c.notes(), java_main_class(files)});
  }
  const std::string cmake = top_file(files, {"CMakeLists.txt"}, c.vendored);
  if (cmake.empty()) return;
  plan.push_back({"its " + cmake,
                  "cmake",
                  repairs,
                  c.search_path() + "cmake -S " + single_quoted(folder(cmake)) +
                      " -B raycheck-build -DCMAKE_BUILD_TYPE=Release && make -C raycheck-build",
                  std::string(kMade),
                  {},
                  c.notes()});
}

void plan_c_family(const HandedInFiles& files, std::vector<BuildAttempt>& plan) {
  const CSources c(files);
  std::set<std::string> included;
  for (const auto& [name, file] : files) {
    if (!is_c_family(name) || c.vendored.has(name)) continue;
    for (const IncludeLine& one : includes_of(file.text)) {
      if (is_c_or_cpp(one.name)) included.insert(base_of(one.name));
    }
  }
  std::vector<std::string> mains, others;
  for (const std::string& name :
       own_sources(files, c.vendored, [&](const std::string&path, const HandedInFile&) {
         return is_c_or_cpp(path) && !included.contains(base_of(path));
       })) {
    (defines_main(files.at(name).text) ? mains : others).push_back(name);
  }
  sort_by_likelihood(mains);
  const std::size_t count = mains.size();
  mains.resize(std::min(count, kMostMains));
  for (const std::string& main : mains) {
    std::vector<std::string> sources = others;
    sources.insert(sources.begin(), main);
    const std::vector<std::string> reached = reached_from(main, files, others);
    const std::size_t first = plan.size();
    plan.push_back(compiled(files, c, "its sources", sources));
    if (reached.size() < sources.size()) {
      plan.push_back(compiled(files, c, "the sources that " + main + " includes", reached));
      plan.back().only_after_failure = true;
    }
    if (count == 1) continue;
    for (std::size_t k = first; k < plan.size(); ++k) {
      plan[k].notes.push_back(
          fmt::format("{} of its files have a main function; that of {} is used", count, main));
    }
  }
}

}  // namespace raycheck::tools
