// Which ways there are to build what was handed in.

#include <elf.h>
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cstring>

#include "tools/grade/intake/building.h"
#include "tools/grade/intake/sources.h"
#include "tools/report/words.h"

namespace raycheck::tools {
namespace {

#if defined(__x86_64__)
constexpr Elf64_Half kMachine = EM_X86_64;
#elif defined(__aarch64__)
constexpr Elf64_Half kMachine = EM_AARCH64;
#else
#error "which machine is this?"
#endif

/// Whether a file could be the source of a program.
bool is_source(const std::string& name) {
  constexpr std::array<std::string_view, 5> kEndings = {".java", ".js", ".mjs", ".cjs", ".py"};
  return is_c_or_cpp(name) ||
         std::find(kEndings.begin(), kEndings.end(), ending_of(name)) != kEndings.end();
}

/// Programs for other machines in the submission, as a reason why nothing runs.
std::string foreign_program(const HandedInFiles& files) {
  for (const auto& [name, file] : files) {
    if (file.text.starts_with("MZ")) return name + " is a program of Windows";
    const bool is_mach =
        file.text.starts_with("\xCF\xFA\xED\xFE") || file.text.starts_with("\xCA\xFE\xBA\xBE");
    if (is_mach && ending_of(name) != ".class") return name + " is a program of macOS";
    if (is_elf(file.text) && !is_program_here(file.text)) {
      return name + " is no program of this kind of machine";
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

void plan_built_before(const HandedInFiles& files, BuildPlan& plan) {
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
  if (!programs.empty()) {
    const std::string& program = programs.front();
    plan.attempts.push_back({"its program",
                             "chmod +x " + program,
                             "",
                             "chmod +x " + single_quoted(program),
                             candidate_word("./" + program),
                             {},
                             {fmt::format("{} is run as it was handed in", program)}});
  } else if (!scripts.empty()) {
    const std::string& script = scripts.front();
    const bool has_interpreter = files.at(script).text.starts_with("#!");
    plan.attempts.push_back({"its script", "chmod +x " + script, "",
                             "chmod +x " + single_quoted(script),
                             (has_interpreter ? "" : "sh ") + candidate_word("./" + script)});
  }
}

BuildPlan build_plan(const HandedInFiles& files) {
  BuildPlan plan;
  plan_make(files, plan);
  plan_cmake(files, plan);
  const std::size_t by_recipe = plan.attempts.size();
  for (const auto add :
       {plan_c_family, plan_java, plan_javascript, plan_python, plan_built_before}) {
    if (plan.attempts.size() == by_recipe) add(files, plan);
  }
  if (!plan.attempts.empty()) return plan;
  const std::string foreign = foreign_program(files);
  if (!foreign.empty()) {
    plan.why_none = foreign + ", and there is nothing to build it of";
  } else if (std::any_of(files.begin(), files.end(),
                         [](const auto& file) { return is_source(file.first); })) {
    plan.why_none = "none of its sources is a program's main one";
  } else {
    plan.why_none =
        "there is nothing in it to build or run: no Makefile, no CMakeLists.txt, no sources of C, "
        "C++, Java, JavaScript or Python, no program";
  }
  return plan;
}

}  // namespace raycheck::tools
