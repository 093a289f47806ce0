#include "scene/files/format.h"

#include <algorithm>
#include <mutex>

#include "scene/files/file_text.h"
#include "scene/files/format_texts.h"
#include "scene/files/located_fields.h"
#include "scene/number.h"
#include "scene/text.h"

namespace raycheck::scene {
namespace {

/// Many formats have names that end in this; they are told by their keywords.
constexpr std::string_view kSharedEnding = ".txt";
/// A file that has this share of the keywords of a format's camera is meant to be of that format.
constexpr double kNearlyFits = 0.5;
/// The bytes in which the keywords of a camera are looked for.
constexpr std::size_t kMostLooked = std::size_t{1} << 16;

/// The first words of the lines of a text, and what follows each where it first begins a line.
struct Keywords {
  std::map<std::string_view, std::string_view> all;
  std::vector<std::string_view> first;  ///< The first three.
};
Keywords keywords_of(std::string_view text) {
  constexpr std::size_t kFirst = 3;
  Keywords words;
  while (!text.empty()) {
    const std::size_t length = std::min(text.find_first_of("\r\n"), text.size());
    std::string_view line = text.substr(0, length);
    text.remove_prefix(std::min(length + 1, text.size()));
    line.remove_prefix(std::min(line.find_first_not_of(kBlanks), line.size()));
    const std::string_view word = line.substr(0, line.find_first_of(kBlanks));
    if (word.empty() || !words.all.emplace(word, line.substr(word.size())).second) continue;
    if (words.first.size() < kFirst) words.first.push_back(word);
  }
  return words;
}

/// How well a format fits: which share of its camera's keywords is there, and whether their numbers
/// have the right signs.
std::pair<double, bool> fit(const FileFormat& format,
                            const std::map<std::string_view, std::string_view>& words) {
  if (!format.by_lines || format.is_nested()) return {};
  double asked = 0, found = 0;
  bool has_signs = true;
  for (const FormatStatement& statement : format.statements) {
    const bool is_for_camera = std::ranges::any_of(statement.parts, [](const FormatPart& part) {
      return part.word.empty() && is_of_camera(part.slot);
    });
    if (!is_for_camera) continue;
    asked += 1;
    const auto known = words.find(statement.parts.front().word);
    if (known == words.end()) continue;
    found += 1;
    has_signs = has_signs && !has_wrong_sign(statement, known->second);
  }
  return {asked == 0 ? 0 : found / asked, has_signs};
}

}  // namespace

bool has_wrong_sign(const FormatStatement& statement, std::string_view words) {
  for (std::size_t k = 1; k < statement.parts.size(); ++k) {
    const int sign = sign_of_slot(statement.parts[k].slot);
    std::size_t count = std::max<std::size_t>(statement.parts[k].numbers, 1);
    for (; count > 0; --count) {
      words.remove_prefix(std::min(words.find_first_not_of(kBlanks), words.size()));
      const std::string_view word = words.substr(0, words.find_first_of(kBlanks));
      words.remove_prefix(word.size());
      if (sign != 0 && parse_number(word).value_or(sign) * sign < 0) return true;
    }
  }
  return false;
}

const std::map<std::string, FileFormat, std::less<>>& formats() {
  static const auto kAll = [] {
    std::map<std::string, FileFormat, std::less<>> all;
    const auto add = [&](const FormatText& one, std::string_view variant) {
      FileFormat format = read_format(one.text, std::string(one.name) + ".toml", variant);
      return all.emplace(format.name, std::move(format)).first->second.variants;
    };
    for (const FormatText& one : kFormatTexts) {
      for (const std::string& variant : add(one, "")) add(one, variant);
    }
    return all;
  }();
  return kAll;
}

const FileFormat* format_named(const std::filesystem::path& name, const std::string& variant) {
  if (name.extension() != ".toml") {
    const std::string known = name.string() + (variant.empty() ? "" : "-" + variant);
    const auto found = formats().find(known);
    return found == formats().end() ? nullptr : &found->second;
  }
  static std::mutex mutex;
  static std::map<std::pair<std::filesystem::path, std::string>, FileFormat> all;
  const std::lock_guard lock(mutex);
  const std::filesystem::path path = std::filesystem::absolute(name);
  const auto [known, is_new] = all.try_emplace({path, variant});  // keeps the addresses
  if (is_new) {
    try {
      known->second = read_format(file_text(name), name.string(), variant);
      known->second.path = path;
      known->second.name = name.filename().string() + (variant.empty() ? "" : ":" + variant);
    } catch (...) {
      all.erase(known);
      throw;
    }
  }
  return &known->second;
}

std::vector<const FileFormat*> variants_of(const FileFormat& format) {
  std::vector<const FileFormat*> all;
  for (const std::string& variant : format.variants) {
    const auto* one = format_named(
        format.path.empty() ? std::filesystem::path(format.name) : format.path, variant);
    if (one != nullptr && one != &format) all.push_back(one);
  }
  return all;
}

const FileFormat* format_of(std::string_view file, std::string_view text) {
  const Keywords words = keywords_of(without_mark(text).substr(0, kMostLooked));
  std::pair<double, bool> best_fit = {};
  const FileFormat* best = nullptr;
  for (const auto& [name, format] : formats()) {
    const auto its = fit(format, words.all);
    if (its <= best_fit) continue;
    best_fit = its;
    best = &format;
  }
  if (best_fit.first == 1) return best;
  for (const auto& [name, format] : formats()) {
    for (const std::string& ending : format.endings) {
      if (ending != kSharedEnding && file.ends_with(ending)) return &format;
    }
  }
  return best_fit.first >= kNearlyFits ? best : nullptr;
}

namespace {

bool is_read(const FileFormat& format, std::string_view text) {
  try {
    read_formatted(format, text, "");
    return true;
  } catch (const SceneFileError&) {
    return false;
  }
}

}  // namespace

LoadedScene read_any_format(std::string_view text, std::string_view file, const FileFormat* asked) {
  const FileFormat* const found = format_of(file, text);
  if (asked != nullptr) {
    const Keywords words = keywords_of(without_mark(text).substr(0, kMostLooked));
    for (const FileFormat* variant : variants_of(*asked)) {
      if (fit(*variant, words.all) > fit(*asked, words.all)) asked = variant;
    }
  }
  if (asked == nullptr && found == nullptr) {
    LocatedFields(file).fail(1, "first words",
                             joined(keywords_of(text.substr(0, kMostLooked)).first),
                             "not a scene file of a known format; `raycheck list` shows them, "
                             "and the name of a TOML file must end in .toml");
  }
  try {
    return read_formatted(asked != nullptr ? *asked : *found, text, file);
  } catch (const SceneFileError& error) {
    if (asked == nullptr || found == nullptr || found == asked || !is_read(*found, text)) throw;
    throw SceneFileError(std::string(error.what()) + "; the file is of the format " + found->name);
  }
}

}  // namespace raycheck::scene
