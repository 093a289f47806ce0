#include <fmt/core.h>

#include <filesystem>
#include <stdexcept>

#include "scene/files/file_text.h"
#include "scene/files/format.h"
#include "tools/commands/new_format.h"
#include "tools/edge.h"
#include "tools/external/sandbox/launch.h"
#include "tools/report/version.h"
#include "tools/report/words.h"

namespace raycheck::tools {
namespace {

namespace fs = std::filesystem;

struct Language {
  std::string_view name, extension;
  std::string_view beside;  ///< A file in adapters() that is copied beside it, or empty.
  std::string_view judged;  ///< The option with which NAME is judged.
  /// Reserved words, with spaces around each; empty if NAME names only files in this language.
  std::string_view reserved = "";
};
constexpr Language kLanguages[] = {
    {"cpp", ".cpp", "", "--candidate source:NAME.cpp"},
    {"c", ".c", "", "--candidate source:NAME.c"},
    {"python", ".py", "", "--candidate 'command:python3 NAME.py'"},
    {"node", ".mjs", "raycheck_candidate.mjs", "--candidate 'command:node NAME.mjs'"},
    {"java", ".java", "RaycheckCandidate.java",
     "--candidate 'command:java -cp . NAME', once `javac NAME.java RaycheckCandidate.java` has "
     "compiled it",
     " abstract assert boolean break byte case catch char class const continue default do double "
     "else enum extends false final finally float for goto if implements import instanceof int "
     "interface long native new null package permits private protected public record return "
     "sealed short static strictfp super switch synchronized this throw throws transient true try "
     "var void volatile while yield _ RaycheckCandidate "}};

struct NewArguments {
  std::string name, language = "cpp", out = ".", from;
};

std::string named(std::string_view text, const std::string& name) {
  constexpr std::string_view kName = "NAME";
  std::string result(text);
  for (std::size_t at = 0; (at = result.find(kName, at)) != std::string::npos; at += name.size()) {
    result.replace(at, kName.size(), name);
  }
  return result;
}

/// The path of a file to write. Error: std::invalid_argument if it exists.
fs::path new_path(const NewArguments& arguments, const std::string& file) {
  const fs::path path = (fs::path(arguments.out) / file).lexically_normal();
  if (fs::exists(path)) {
    throw std::invalid_argument(fmt::format(
        "{} already exists; give another NAME, or another folder by --out", path.string()));
  }
  return path;
}

/// Writes a draft of a format from an example file, and says how far it reads the example.
std::string write_format(const NewArguments& arguments) {
  std::string draft;
  try {
    draft = drafted_format(arguments.name, arguments.from, scene::file_text(arguments.from));
  } catch (const scene::SceneFileError& error) {
    throw std::invalid_argument(fmt::format("--from {}", error.what()));
  }
  const fs::path path = new_path(arguments, arguments.name + ".toml");
  make_folder("out", arguments.out);
  OutputFile("out", path).write(draft);
  std::string said;
  try {
    const auto loaded = scene::load_scene(arguments.from, scene::format_named(path));
    said = fmt::format(
        "reads {} as {} x {} pixels and {}{}", arguments.from, loaded.scene.camera->width,
        loaded.scene.camera->height, count_text(loaded.scene.spheres.size(), "sphere"),
        loaded.not_needed.empty() ? "" : ", without " + scene::joined(loaded.not_needed));
  } catch (const scene::SceneFileError& error) {
    said = fmt::format("does not read {} yet: {}", arguments.from, error.what());
  }
  return fmt::format(
      "wrote {}: it {}\nComplete it and its conventions (its first lines say what is left), then "
      "try it:\n  raycheck check {} --dialect {}\n",
      path.string(), said, arguments.from, path.string());
}

std::string write_adapter(const NewArguments& arguments) {
  const auto* const language = std::ranges::find(kLanguages, arguments.language, &Language::name);
  if (language->reserved.find(" " + arguments.name + " ") != std::string_view::npos) {
    throw std::invalid_argument(fmt::format("NAME {}: is a reserved word of {}; give another name",
                                            arguments.name, arguments.language));
  }
  const fs::path installed = prefix() / "share/raycheck/new";
  const fs::path templates =
      fs::exists(installed) ? installed : fs::path(kSourceFolder) / "examples/new";
  const std::string file = arguments.name + std::string(language->extension);
  std::vector<std::pair<std::string, std::string>> texts = {
      {file, named(scene::file_text(templates / ("candidate" + std::string(language->extension))),
                   arguments.name)}};
  if (!language->beside.empty()) {
    const std::string beside(language->beside);
    texts.emplace_back(beside, scene::file_text(adapters() / beside));
  }
  const fs::path out = arguments.out;
  const fs::path path = new_path(arguments, file);
  make_folder("out", out);
  for (const auto& [name, text] : texts) OutputFile("out", out / name).write(text);
  return fmt::format(
      "wrote {}: call your code in its functions, then judge it:\n"
      "  raycheck properties {}\n",
      path.string(), named(language->judged, (out / arguments.name).lexically_normal().string()));
}

}  // namespace

CommandRun add_new(CLI::App& command) {
  const auto given = std::make_shared<NewArguments>();
  command
      .add_option("NAME", given->name,
                  "the name of the adapter or the format: its file is named after it")
      ->required()
      ->check([](const std::string& name) {
        constexpr std::string_view kLetters =
            "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ_0123456789";
        const bool is_name = !name.empty() &&
                             kLetters.substr(0, 52).find(name.front()) != std::string_view::npos &&
                             name.find_first_not_of(kLetters) == std::string::npos;
        return is_name ? std::string()
                       : "give a letter, then letters, digits and _, not '" + name + "'";
      });
  command.add_option("--language", given->language, "the language of the adapter")
      ->check(CLI::IsMember(names_of(kLanguages)))
      ->capture_default_str();
  command.add_option("--out", given->out, "the folder for the adapter")->capture_default_str();
  command
      .add_option(
          "--from", given->from,
          "instead of an adapter, draft a format of scene files, NAME.toml, from this example")
      ->excludes(command.get_option("--language"));
  return [given] {
    print_report(given->from.empty() ? write_adapter(*given) : write_format(*given));
    return kExitNothingFound;
  };
}

}  // namespace raycheck::tools
