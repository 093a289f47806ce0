// The ways to build a submission. Those for C and C++ are in plan_c_family.cpp.

#include <elf.h>
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <nlohmann/json.hpp>
#include <string_view>
#include <vector>

#include "tools/grade/intake/building.h"
#include "tools/grade/intake/sources.h"
#include "tools/report/words.h"

namespace raycheck::tools {
namespace {

std::string stem_of(const std::string& path) {
  const std::string base = base_of(path);
  return base.substr(0, base.rfind('.'));
}

std::vector<std::string> with_ending(const HandedInFiles& files,
                                     const std::vector<std::string>& endings) {
  return own_sources(files, vendored_in(files), [&](const std::string& path, const HandedInFile&) {
    return is_one_of(endings, ending_of(path));
  });
}

/// The files that look like the start of a program, the likeliest first. A single file always
/// counts.
std::vector<std::string> starting(const HandedInFiles& files, std::vector<std::string> names,
                                  const std::vector<std::string>& signs) {
  if (names.size() == 1) return names;
  std::vector<std::string> found;
  for (const std::string& name : names) {
    const bool has_sign = std::ranges::any_of(signs, [&](const std::string& sign) {
      return files.at(name).text.find(sign) != std::string::npos;
    });
    if (has_sign) found.push_back(name);
  }
  sort_by_likelihood(found);
  return found;
}

std::vector<std::string> several_note(const std::vector<std::string>& names) {
  if (names.size() == 1) return {};
  return {fmt::format("{} of its files could be started; {} is used", names.size(), names.front())};
}

/// Whether there is a `public static void main(`.
bool has_java_main(const std::vector<std::string_view>& words) {
  for (std::size_t k = 2; k + 1 < words.size(); ++k) {
    if (words[k] != "main" || words[k + 1] != "(" || words[k - 1] != "void") continue;
    bool is_public = false, is_static = false;
    for (std::size_t before = k - 1; before-- > 0;) {
      is_public = is_public || words[before] == "public";
      is_static = is_static || words[before] == "static";
      if (words[before] != "public" && words[before] != "static" && words[before] != "final") break;
    }
    if (is_public && is_static) return true;
  }
  return false;
}

/// The class with a Java file's main(), with its package.
std::string main_class(const std::string& path, const std::vector<std::string_view>& words) {
  constexpr std::array<std::string_view, 4> kTypes = {"class", "record", "enum", "interface"};
  std::string package, first_class;
  bool has_own = false;
  for (std::size_t k = 0; k + 1 < words.size(); ++k) {
    const std::string_view next = words[k + 1];
    if (words[k] == "package" && package.empty() && k + 2 < words.size() && words[k + 2] == ";") {
      package = std::string(next) + ".";
    }
    if (words[k] == "class" && first_class.empty()) first_class = next;
    has_own = has_own || (next == stem_of(path) && is_one_of(kTypes, words[k]));
  }
  if (has_own) return package + stem_of(path);
  return first_class.empty() ? "" : package + first_class;
}

/// The Java files with a main(), likeliest first.
std::vector<std::string> java_mains(const HandedInFiles& files) {
  std::vector<std::string> mains = with_ending(files, {".java"});
  std::erase_if(mains, [&](const std::string& name) {
    const std::string text = without_comments(files.at(name).text);
    return !has_java_main(words_of_code(text));
  });
  sort_by_likelihood(mains);
  return mains;
}

/// The submitted script that package.json names, or empty.
std::string of_package_json(const HandedInFiles& files) try {
  const auto package = files.find("package.json");
  if (package == files.end()) return "";
  const nlohmann::json json = nlohmann::json::parse(package->second.text);
  std::vector<std::string> named;
  if (json.contains("bin") && json.at("bin").is_string()) named.push_back(json.at("bin"));
  if (json.contains("bin") && json.at("bin").is_object()) {
    for (const auto& [name, path] : json.at("bin").items()) named.push_back(path);
  }
  if (json.contains("main")) named.push_back(json.at("main"));
  for (std::string name : named) {
    if (name.starts_with("./")) name.erase(0, 2);
    if (files.contains(name)) return name;
    if (files.contains(name + ".js")) return name + ".js";
  }
  return "";
} catch (const nlohmann::json::exception&) {
  return "";
}

void plan_script(const std::string& interpreter, const std::vector<std::string>& mains,
                 std::vector<BuildAttempt>& plan) {
  if (mains.empty()) return;
  const std::string program = interpreter + " " + candidate_word("./" + mains.front());
  plan.push_back({"its sources", interpreter, "", "", program, {}, several_note(mains)});
}

}  // namespace

std::string java_words(const std::string& folder, const std::vector<std::string>& jars,
                       const std::string& main_class) {
  // Its dependencies may lie beside it, unpacked.
  std::string path = folder + ":.";
  for (const std::string& jar : jars) path += ":" + jar;
  return fmt::format("java -cp {} {}", candidate_word(path), main_class);
}

std::string java_main_class(const HandedInFiles& files) {
  const std::vector<std::string> mains = java_mains(files);
  if (mains.empty()) return "";
  const std::string text = without_comments(files.at(mains.front()).text);
  return main_class(mains.front(), words_of_code(text));
}

namespace {

#if defined(__x86_64__)
constexpr Elf64_Half kMachine = EM_X86_64;
#elif defined(__aarch64__)
constexpr Elf64_Half kMachine = EM_AARCH64;
#else
#error "raycheck supports x86-64 and AArch64"
#endif

/// Whether a file could be the source of a program.
bool is_source(const std::string& name) {
  constexpr std::array<std::string_view, 5> kEndings = {".java", ".js", ".mjs", ".cjs", ".py"};
  return is_c_or_cpp(name) || is_one_of(kEndings, ending_of(name));
}

/// If the submission contains a program for another system, the reason why it cannot be run;
/// otherwise empty.
std::string foreign_program(const HandedInFiles& files) {
  for (const auto& [name, file] : files) {
    if (file.text.starts_with("MZ")) return name + " is a Windows program";
    const bool is_mach =
        file.text.starts_with("\xCF\xFA\xED\xFE") || file.text.starts_with("\xCA\xFE\xBA\xBE");
    if (is_mach && ending_of(name) != ".class") return name + " is a macOS program";
    if (is_elf(file.text) && !is_program_here(file.text)) {
      return name + " was built for another architecture";
    }
  }
  return "";
}

}  // namespace

bool is_elf(std::string_view text) {
  return text.starts_with(
      "\x7f"
      "ELF");
}

bool is_program_here(std::string_view text) {
  Elf64_Ehdr header{};
  if (!is_elf(text) || text.size() < sizeof header || text[EI_CLASS] != ELFCLASS64) return false;
  std::memcpy(&header, text.data(), sizeof header);
  return header.e_machine == kMachine && header.e_entry != 0 &&
         (header.e_type == ET_EXEC || header.e_type == ET_DYN);
}

namespace {

void plan_java(const HandedInFiles& files, std::vector<BuildAttempt>& plan) {
  const std::string started = java_main_class(files);
  if (started.empty()) return;
  constexpr const char* kClasses = "raycheck-classes";
  const std::vector<std::string> sources = with_ending(files, {".java"});
  std::vector<std::string> jars;
  std::string paths;
  for (const auto& [name, file] : files) {
    if (ending_of(name) != ".jar") continue;
    jars.push_back(name);
    paths += ":" + name;
  }
  BuildAttempt attempt;
  attempt.what = "its sources";
  attempt.shown = fmt::format(
      "javac {}{}", paths.empty() ? "" : "-cp " + paths.substr(1) + " ",
      sources.size() > 3 ? fmt::format("({} files)", sources.size()) : shell_words(sources));
  attempt.words = fmt::format("javac -encoding UTF-8 -nowarn -d {} -cp {} {}", kClasses,
                              single_quoted("." + paths), shell_words(sources));
  attempt.program = java_words(kClasses, jars, started);
  attempt.notes = several_note(java_mains(files));
  plan.push_back(std::move(attempt));
}

void plan_javascript(const HandedInFiles& files, std::vector<BuildAttempt>& plan) {
  std::vector<std::string> mains =
      starting(files, with_ending(files, {".js", ".mjs", ".cjs"}), {"process.argv", "Deno.args"});
  const std::string packaged = of_package_json(files);
  if (!packaged.empty()) mains = {packaged};
  plan_script("node", mains, plan);
}

void plan_python(const HandedInFiles& files, std::vector<BuildAttempt>& plan) {
  plan_script("python3",
              starting(files, with_ending(files, {".py"}),
                       {"__main__", "sys.argv", "argparse", "import argv"}),
              plan);
}

void plan_built_before(const HandedInFiles& files, std::vector<BuildAttempt>& plan) {
  std::vector<std::string> programs, scripts;
  for (const auto& [name, file] : files) {
    if (is_program_here(file.text) && name.find(".so") == std::string::npos) {
      programs.push_back(name);
    }
    if (ending_of(name) == ".sh" || (file.runs && file.text.starts_with("#!"))) {
      scripts.push_back(name);
    }
  }
  sort_by_likelihood(programs);
  sort_by_likelihood(scripts);
  const bool is_program = !programs.empty();
  if (!is_program && scripts.empty()) return;
  const std::string& name = (is_program ? programs : scripts).front();
  const bool needs_shell = !is_program && !files.at(name).text.starts_with("#!");
  plan.push_back({is_program ? "its program" : "its script", "chmod +x " + name, "",
                  "chmod +x " + single_quoted(name),
                  (needs_shell ? "sh " : "") + candidate_word("./" + name)});
  if (is_program) plan.back().notes = {name + " is run as it was handed in"};
}

}  // namespace

std::vector<BuildAttempt> build_plan(const HandedInFiles& files) {
  std::vector<BuildAttempt> plan;
  plan_recipes(files, plan);
  const std::size_t by_recipe = plan.size();
  for (const auto add :
       {plan_c_family, plan_java, plan_javascript, plan_python, plan_built_before}) {
    if (plan.size() == by_recipe) add(files, plan);
  }
  if (!plan.empty()) return plan;
  const std::string foreign = foreign_program(files);
  if (!foreign.empty()) {
    throw CandidateError(foreign + ", and there are no sources to build it from");
  }
  const bool has_source =
      std::ranges::any_of(files, [](const auto& file) { return is_source(file.first); });
  throw CandidateError(
      has_source
          ? "none of its source files has a main function; a renderer needs one, and functions for "
            "raycheck must be in the file that the rubric names, such as rays.cpp"
          : "there is nothing to build or run: no Makefile, no CMakeLists.txt, no sources in C, "
            "C++, Java, JavaScript or Python, no program");
}

}  // namespace raycheck::tools
