#include "scene/files/format.h"

#include <algorithm>
#include <mutex>
#include <numbers>
#include <set>

#include "scene/files/file_text.h"
#include "scene/files/format_texts.h"
#include "scene/files/toml_fields.h"

namespace raycheck::scene {
namespace {

constexpr std::string_view kBlanks = " \t\v\f\r\n";
const std::set<std::string_view> kOfSpheres = {"centre", "radius",    "diameter", "scale",
                                               "colour", "colour255", "name",     "index"};
const std::set<std::string_view> kWithoutMeaning = {"_", "*", "count", "image"};
const std::set<std::string_view> kOfCameras = {"eye",  "look_at",  "view",  "up",    "near",
                                               "left", "right",    "top",   "width", "bottom",
                                               "size", "distance", "height"};

bool is_known(std::string_view slot) {
  return kOfSpheres.contains(slot) || kOfCameras.contains(slot) || kWithoutMeaning.contains(slot) ||
         angle_slot(slot);
}

class FormatReader {
 public:
  FormatReader(std::string_view file, std::string_view variant)
      : file_(file), variant_(variant), fields_(file) {}

  FileFormat read(std::string_view text) {
    const toml::table root = parse_toml(text, file_);
    const Table from{root, "format", "", 1};
    fields_.require_known(from, {"title", "source", "endings", "comments", "separators", "joint",
                                 "lines", "exponents", "digits", "template", "ignored", "refused",
                                 "conventions", "fixed", "default", "variant"});
    format_.title = fields_.text(fields_.required(from, "title"));
    const auto text_of = [&](const char* key, std::string& value) {
      if (const auto field = fields_.optional(from, key)) value = fields_.text(*field);
    };
    text_of("comments", format_.comments);
    text_of("separators", format_.separators);
    text_of("joint", format_.joint);
    if (const auto field = fields_.optional(from, "endings")) {
      format_.endings = fields_.texts(*field);
    }
    if (const auto field = fields_.optional(from, "lines")) format_.by_lines = fields_.flag(*field);
    if (const auto field = fields_.optional(from, "digits")) {
      format_.digits = std::clamp(static_cast<int>(fields_.number(*field)), 1, 17);
    }
    if (const auto field = fields_.optional(from, "exponents")) {
      format_.has_exponents = fields_.flag(*field);
    }
    for (const auto& [key, words] :
         {std::pair("ignored", &format_.ignored), std::pair("refused", &format_.refused)}) {
      const auto field = fields_.optional(from, key);
      if (!field) continue;
      const Table table = fields_.table(*field);
      for (const auto& [word, node] : table.keys) {
        words->emplace(word.str(), fields_.text(fields_.required(table, word.str())));
      }
    }
    if (const auto field = fields_.optional(from, "conventions")) {
      const Table table = fields_.table(*field);
      fields_.require_known(table, {"rows", "samples", "origin"});
      fields_.choose(table, "rows", kRowsNames, format_.rows);
      fields_.choose(table, "samples", kSamplesNames, format_.samples);
      fields_.choose(table, "origin", kOriginNames, format_.origin);
    }
    for (const auto& [key, numbers] :
         {std::pair("fixed", &format_.fixed), std::pair("default", &format_.defaults)}) {
      if (const auto field = fields_.optional(from, key))
        read_fixed(fields_.table(*field), *numbers);
    }
    const Field field = fields_.required(from, "template");
    std::string text_of_files = fields_.text(field);
    if (const auto variants = fields_.optional(from, "variant")) {
      const Table table = fields_.table(*variants);
      for (const auto& [name, node] : table.keys) {
        format_.variants.emplace_back(name.str());
        if (name.str() == variant_)
          replace(fields_.table(fields_.required(table, name)), text_of_files);
      }
    }
    read_template(field, text_of_files);
    return std::move(format_);
  }

 private:
  using Table = TomlFields::Table;
  using Field = TomlFields::Field;

  void read_fixed(const Table& from,
                  std::map<std::string, std::vector<double>, std::less<>>& fixed) const {
    for (const auto& [key, node] : from.keys) {
      const Field field = fields_.required(from, key.str());
      if (!is_known(key.str())) fields_.fail(field, "is not the name of a slot");
      std::vector<double>& numbers = fixed[std::string(key.str())];
      if (node.is_array()) {
        for (const Field& one : fields_.list(field)) numbers.push_back(fields_.number(one));
      } else {
        numbers.push_back(fields_.number(field));
      }
    }
  }

  /// Replaces the keys of a table by their values.
  void replace(const Table& by, std::string& text) const {
    for (const auto& [from, node] : by.keys) {
      const Field to = fields_.required(by, from);
      const std::size_t at = text.find(from.str());
      if (at == std::string::npos) fields_.fail(to, "replaces what the template does not have");
      text.replace(at, from.str().size(), fields_.text(to));
    }
  }

  /// A statement is a line, or, in free form, the text up to an empty line.
  void read_template(const Field& field, const std::string& text) {
    const std::string between = format_.by_lines ? "\n" : "\n\n";
    for (std::size_t at = 0; at < text.size();) {
      const std::size_t end = std::min(text.find(between, at), text.size() - 1) + 1;
      std::string one = text.substr(at, end - at);
      at = end;
      if (one.find_first_not_of(kBlanks) == std::string::npos) {
        if (!format_.statements.empty()) format_.statements.back().text += one;
        continue;
      }
      format_.statements.push_back(statement(field, std::move(one)));
    }
    if (!format_.has("centre")) fields_.fail(field, "has no {centre}: no spheres can be read");
    const auto is_angle = [](const auto& one) { return angle_slot(one.first).has_value(); };
    bool has_angle = std::ranges::any_of(format_.fixed, is_angle);
    for (const FormatStatement& one : format_.statements) {
      for (const FormatPart& part : one.parts) has_angle = has_angle || angle_slot(part.slot);
    }
    if (format_.has_angle() && !has_angle) {
      fields_.fail(field, "has neither a window, {left} to {top}, nor an angle of view, {fovy}");
    }
  }

  FormatStatement statement(const Field& field, std::string text) const {
    FormatStatement result;
    const std::string separators = format_.separators + std::string(kBlanks);
    const std::string ends = separators + "{";
    for (std::size_t at = 0; at < text.size();) {
      if (text[at] == '{' && at + 1 < text.size() && is_slot(text, at)) {
        const std::size_t end = text.find('}', at);
        const std::string slot = text.substr(at + 1, end - at - 1);
        const std::size_t colon = std::min(slot.find(':'), slot.size());
        FormatPart part{"", slot.substr(0, colon), slot.substr(std::min(colon + 1, slot.size()))};
        const bool is_unit = part.written == kUnit && (part.slot == "view" || part.slot == "up");
        if (!is_known(part.slot) ||
            !(part.written.empty() || is_unit || kWithoutMeaning.contains(part.slot))) {
          fields_.fail(field, "{" + slot + "} is not a slot");
        }
        result.is_of_sphere = result.is_of_sphere || kOfSpheres.contains(part.slot);
        result.parts.push_back(std::move(part));
        at = end + 1;
      } else if (separators.find(text[at]) != std::string::npos) {
        ++at;
      } else {
        const std::size_t end = std::min(text.find_first_of(ends, at + 1), text.size());
        result.parts.push_back({text.substr(at, end - at), "", ""});
        at = end;
      }
    }
    result.text = std::move(text);
    return result;
  }

  /// Braces around a name without blanks are a slot; others are the format's own.
  static bool is_slot(std::string_view text, std::size_t at) {
    const std::size_t end = text.find('}', at);
    if (end == std::string_view::npos) return false;
    const std::string_view name = text.substr(at + 1, end - at - 1);
    return !name.empty() && name.find('\n') == std::string_view::npos && name.front() != ' ';
  }

  std::string_view file_, variant_;
  TomlFields fields_;
  FileFormat format_;
};

/// Many formats have names that end in this; they are told by their keywords.
constexpr std::string_view kSharedEnding = ".txt";
/// The bytes in which all keywords of a camera are looked for.
constexpr std::size_t kMostLooked = std::size_t{1} << 16;

/// The first words of the lines of a text.
std::set<std::string_view> first_words(std::string_view text) {
  std::set<std::string_view> words;
  while (!text.empty()) {
    const std::size_t length = std::min(text.find_first_of("\r\n"), text.size());
    std::string_view line = text.substr(0, length);
    text.remove_prefix(std::min(length + 1, text.size()));
    line.remove_prefix(std::min(line.find_first_not_of(kBlanks), line.size()));
    words.insert(line.substr(0, line.find_first_of(kBlanks)));
  }
  return words;
}

/// Whether all keywords of the format's camera are there.
bool fits(const FileFormat& format, const std::set<std::string_view>& keywords) {
  const auto is_there = [&](const FormatStatement& statement) {
    const bool is_of_camera = std::ranges::any_of(statement.parts, [](const FormatPart& part) {
      return !part.slot.empty() && !kWithoutMeaning.contains(part.slot);
    });
    return statement.parts.empty() || statement.is_of_sphere || !is_of_camera ||
           keywords.contains(statement.parts.front().word);
  };
  return format.by_lines && std::ranges::all_of(format.statements, is_there);
}

}  // namespace

std::optional<AngleSlot> angle_slot(std::string_view slot) {
  using Side = AngleSlot::Side;
  double half = std::numbers::pi / 360;  // of degrees
  const auto drop = [&](std::string_view ending) {
    if (!slot.ends_with(ending)) return false;
    slot.remove_suffix(ending.size());
    return true;
  };
  if (drop("_radians")) half = 0.5;
  if (drop("_half")) half *= 2;
  constexpr std::array<std::pair<std::string_view, Side>, 4> kSides = {
      {{"fovy", Side::kVertical},
       {"fovx", Side::kHorizontal},
       {"fov_larger", Side::kLarger},
       {"fov_smaller", Side::kSmaller}}};
  for (const auto& [name, side] : kSides) {
    if (slot == name) return AngleSlot{side, half};
  }
  return {};
}

bool FileFormat::has(std::string_view slot) const {
  return std::ranges::any_of(statements, [&](const FormatStatement& statement) {
    return std::ranges::any_of(statement.parts,
                               [&](const FormatPart& part) { return part.slot == slot; });
  });
}

FileFormat read_format(std::string_view text, std::string_view file, std::string_view variant) {
  FileFormat format = FormatReader(file, variant).read(text);
  format.name = std::filesystem::path(file).stem().string();
  if (!variant.empty()) format.name += "-" + std::string(variant);
  return format;
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

const FileFormat* format_named(const std::filesystem::path& name) {
  if (name.extension() != ".toml") {
    const auto found = formats().find(name.string());
    return found == formats().end() ? nullptr : &found->second;
  }
  static std::mutex mutex;
  static std::map<std::filesystem::path, FileFormat> all;  // keeps the addresses
  const std::lock_guard lock(mutex);
  const auto [known, is_new] = all.try_emplace(std::filesystem::absolute(name));
  if (is_new) {
    try {
      known->second = read_format(file_text(name), name.string());
      known->second.name = name.filename().string();  // as --dialect has it
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
    const auto known = formats().find(format.name + "-" + variant);
    if (known != formats().end()) all.push_back(&known->second);
  }
  return all;
}

const FileFormat* format_of(std::string_view file, std::string_view text) {
  const std::set<std::string_view> keywords = first_words(text.substr(0, kMostLooked));
  for (const auto& [name, format] : formats()) {
    if (fits(format, keywords)) return &format;
  }
  for (const auto& [name, format] : formats()) {
    for (const std::string& ending : format.endings) {
      if (ending != kSharedEnding && file.ends_with(ending)) return &format;
    }
  }
  return nullptr;
}

}  // namespace raycheck::scene
