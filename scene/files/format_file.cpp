#include <algorithm>
#include <boost/algorithm/string/replace.hpp>
#include <cmath>
#include <numbers>

#include "scene/files/format.h"
#include "scene/files/toml_fields.h"
#include "scene/text.h"

namespace raycheck::scene {
namespace {

/// A slot other than an angle: how many numbers it has (0: words), and whose it is.
struct Slot {
  std::string_view name;
  std::size_t numbers;
  enum class Of { kCamera, kSphere, kNothing } of;
};
constexpr Slot kSlots[] = {
    {"eye", 3, Slot::Of::kCamera},       {"look_at", 3, Slot::Of::kCamera},
    {"view", 3, Slot::Of::kCamera},      {"up", 3, Slot::Of::kCamera},
    {"near", 1, Slot::Of::kCamera},      {"distance", 1, Slot::Of::kCamera},
    {"left", 1, Slot::Of::kCamera},      {"right", 1, Slot::Of::kCamera},
    {"bottom", 1, Slot::Of::kCamera},    {"top", 1, Slot::Of::kCamera},
    {"width", 1, Slot::Of::kCamera},     {"height", 1, Slot::Of::kCamera},
    {"size", 1, Slot::Of::kCamera},      {"window_width", 1, Slot::Of::kCamera},
    {"centre", 3, Slot::Of::kSphere},    {"number", 0, Slot::Of::kSphere},
    {"radius", 1, Slot::Of::kSphere},    {"diameter", 1, Slot::Of::kSphere},
    {"scale", 3, Slot::Of::kSphere},     {"colour", 3, Slot::Of::kSphere},
    {"colour255", 3, Slot::Of::kSphere}, {"name", 0, Slot::Of::kSphere},
    {"index", 0, Slot::Of::kSphere},     {"_", 0, Slot::Of::kNothing},
    {"*", 0, Slot::Of::kNothing},        {"count", 0, Slot::Of::kNothing},
    {"image", 0, Slot::Of::kNothing},    {"behind", 0, Slot::Of::kNothing},
    {"at_eye", 0, Slot::Of::kNothing},   {"extra", 0, Slot::Of::kNothing},
    {kAxis, 0, Slot::Of::kNothing}};

/// Empty: there is no slot of this name.
std::optional<Slot> slot_named(std::string_view name) {
  if (angle_slot(name)) return Slot{name, 1, Slot::Of::kCamera};
  const auto* const found = std::ranges::find(kSlots, name, &Slot::name);
  return found == std::end(kSlots) ? std::nullopt : std::optional(*found);
}
bool is_of(std::string_view name, Slot::Of whose) {
  const auto slot = slot_named(name);
  return slot && slot->of == whose;
}

class FormatReader {
 public:
  FormatReader(std::string_view file, std::string_view variant)
      : file_(file), variant_(variant), fields_(file) {}

  FileFormat read(std::string_view text) {
    const toml::table root = parse_toml(text, file_);
    const Table from{root, "format", "", 1};
    fields_.require_known(
        from, {"title",    "source",         "endings",     "comments",    "separators",
               "joint",    "lines",          "left_handed", "exponents",   "digits",
               "template", "ignored",        "refused",     "conventions", "assumed",
               "fixed",    "default",        "variant",     "forms",       "preset",
               "nesting",  "transformation", "definition",  "synonyms",    "up_widens"});
    format_.title = fields_.text(fields_.required(from, "title"));
    const auto text_of = [&](const char* key, std::string& value) {
      if (const auto field = fields_.optional(from, key)) value = fields_.text(*field);
    };
    text_of("comments", format_.comments);
    text_of("separators", format_.separators);
    text_of("joint", format_.joint);
    text_of("transformation", format_.transformation);
    fields_.choose(from, "nesting", kNestingNames, format_.nesting);
    if (const auto field = fields_.optional(from, "definition")) {
      auto words = fields_.texts(*field);
      words.resize(format_.definition.size());
      std::ranges::move(words, format_.definition.begin());
    }
    if (const auto field = fields_.optional(from, "endings")) {
      format_.endings = fields_.texts(*field);
    }
    if (const auto field = fields_.optional(from, "lines")) format_.by_lines = fields_.flag(*field);
    if (const auto field = fields_.optional(from, "left_handed")) {
      format_.is_left_handed = fields_.flag(*field);
    }
    if (const auto field = fields_.optional(from, "up_widens")) {
      format_.up_widens = fields_.flag(*field);
    }
    if (const auto field = fields_.optional(from, "digits")) {
      const std::int64_t digits = fields_.integer(*field, "a whole number of digits");
      format_.digits = static_cast<int>(std::clamp<std::int64_t>(digits, 1, 17));
    }
    if (const auto field = fields_.optional(from, "exponents")) {
      format_.has_exponents = fields_.flag(*field);
    }
    for (const auto& [key, words] :
         {std::pair("ignored", &format_.ignored), std::pair("refused", &format_.refused),
          std::pair("preset", &format_.presets), std::pair("synonyms", &format_.synonyms)}) {
      const auto field = fields_.optional(from, key);
      if (!field) continue;
      const Table table = fields_.table(*field);
      for (const auto& [word, node] : table.keys) {
        words->emplace(word.str(), fields_.text(fields_.required(table, word.str())));
      }
    }
    for (const char* const key : {"conventions", "assumed"}) {
      const auto field = fields_.optional(from, key);
      if (!field) continue;
      format_.is_of_programs = key == std::string_view("conventions");
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
    if (const auto field = fields_.optional(from, "forms")) read_forms(fields_.table(*field));
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
    require_counts(from);
    return std::move(format_);
  }

 private:
  using Table = TomlFields::Table;
  using Field = TomlFields::Field;

  void read_fixed(const Table& from,
                  std::map<std::string, std::vector<double>, std::less<>>& fixed) const {
    for (const auto& [key, node] : from.keys) {
      const Field field = fields_.required(from, key.str());
      const auto slot = slot_named(key.str());
      if (!slot) fields_.fail(field, "is not the name of a slot");
      std::vector<double>& numbers = fixed[std::string(key.str())];
      if (node.is_array()) {
        for (const Field& one : fields_.list(field)) numbers.push_back(fields_.number(one));
      } else {
        numbers.push_back(fields_.number(field));
      }
      if (numbers.size() != slot->numbers) {
        fields_.fail(field, "must have " + std::to_string(slot->numbers) + " numbers");
      }
      if (is_pixels(slot->name) && !is_whole(numbers.front())) {
        fields_.fail(field, "is not a whole number of pixels");
      }
    }
  }

  void read_forms(const Table& from) {
    fields_.require_known(from, {"numbers", "extra", "similar"});
    for (const Field& one : fields_.list(fields_.required(from, "numbers"))) {
      format_.sphere_numbers.push_back(fields_.integer(one, "a whole number of numbers"));
    }
    format_.extra_lines = fields_.texts(fields_.required(from, "extra"));
    format_.similar = fields_.texts(fields_.required(from, "similar"));
  }

  /// The counts of numbers are possible for a sphere of the template.
  void require_counts(const Table& from) const {
    std::int64_t least = 0, most = 0;
    for (const FormatStatement& statement : format_.statements) {
      for (const FormatPart& part : statement.parts) {
        if (!statement.has("centre")) continue;
        least += static_cast<std::int64_t>(part.numbers);
        if (part.slot != "*") continue;
        most += std::ranges::count(part.written, ' ') + (part.written.empty() ? 0 : 1);
      }
    }
    most += least;
    for (const std::int64_t count : format_.sphere_numbers) {
      if (least <= count && count <= most) continue;
      const Field field =
          fields_.required(fields_.table(fields_.required(from, "forms")), "numbers");
      fields_.fail(field, "a sphere of the template has " + std::to_string(least) + " to " +
                              std::to_string(most) + " numbers");
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

  // Stand for the braces of slots, which in YAML have a meaning.
  static constexpr const char *kOpen = "\u27e8", *kClose = "\u27e9";

  std::vector<NestedRow> rows_of_template(const Field& field, std::string text) const {
    for (std::size_t at = 0; (at = text.find('{', at)) != std::string::npos; ++at) {
      if (!is_slot(text, at)) continue;
      text.replace(text.find('}', at), 1, kClose);
      text.replace(at, 1, kOpen);
    }
    try {
      return nested_rows(format_.nesting, text, format_.separators, "line");
    } catch (const SceneFileError& error) {
      fields_.fail(field, error.what());
    }
  }

  /// A statement is a line, or, in free form, the text up to an empty line.
  void read_template(const Field& field, const std::string& text) {
    const std::string between = format_.by_lines && !format_.is_nested() ? "\n" : "\n\n";
    const std::vector<NestedRow> rows = rows_of_template(field, text);
    auto row = rows.begin();
    for (std::size_t at = 0, line = 1; at < text.size();) {
      const std::size_t end = std::min(text.find(between, at), text.size() - 1) + 1;
      std::string one = text.substr(at, end - at);
      at = end;
      line += static_cast<std::size_t>(std::ranges::count(one, '\n'));
      if (one.find_first_not_of(kBlanks) == std::string::npos) {
        if (!format_.statements.empty()) format_.statements.back().text += one;
        continue;
      }
      format_.statements.push_back(statement(field, std::move(one)));
      if (!format_.is_nested()) format_.statements.back().rows = {format_.statements.back().parts};
      for (; row != rows.end() && row->line < line; ++row) {
        std::string words = joined(row->words, " ");
        boost::replace_all(words, kOpen, "{");
        boost::replace_all(words, kClose, "}");
        format_.statements.back().rows.push_back(parts_of(field, words));
      }
    }
    if (!format_.has("centre")) fields_.fail(field, "has no {centre}: no spheres can be read");
    const auto is_angle = [](const auto& one) { return angle_slot(one.first).has_value(); };
    bool has_angle = format_.has("window_width") || std::ranges::any_of(format_.fixed, is_angle);
    for (const FormatStatement& one : format_.statements) {
      for (const FormatPart& part : one.parts) has_angle = has_angle || angle_slot(part.slot);
    }
    if (format_.has_angle() && !has_angle) {
      fields_.fail(field, "has neither a window, {left} to {top}, nor an angle of view, {fovy}");
    }
  }

  FormatStatement statement(const Field& field, std::string text) const {
    FormatStatement result;
    result.parts = parts_of(field, text);
    result.is_of_sphere = std::ranges::any_of(result.parts, [](const FormatPart& part) {
      return part.word.empty() && is_of(part.slot, Slot::Of::kSphere);
    });
    result.text = std::move(text);
    require_readable(field, result);
    return result;
  }

  std::vector<FormatPart> parts_of(const Field& field, const std::string& text) const {
    std::vector<FormatPart> parts;
    const std::string separators = format_.separators + std::string(kBlanks);
    const std::string ends = separators + "{";
    for (std::size_t at = 0; at < text.size();) {
      if (text[at] == '{' && at + 1 < text.size() && is_slot(text, at)) {
        const std::size_t end = text.find('}', at);
        const std::string slot = text.substr(at + 1, end - at - 1);
        const std::size_t colon = std::min(slot.find(':'), slot.size());
        FormatPart part{"", slot.substr(0, colon), slot.substr(std::min(colon + 1, slot.size()))};
        if (const auto known = slot_named(part.slot)) part.numbers = known->numbers;
        const bool is_unit = part.written == kUnit && (part.slot == "view" || part.slot == "up");
        const bool is_optional = part.written == kOptional && part.slot.starts_with("colour");
        if (!slot_named(part.slot) || !(part.written.empty() || is_unit || is_optional ||
                                        is_of(part.slot, Slot::Of::kNothing))) {
          fields_.fail(field, "{" + slot + "} is not a slot");
        }
        parts.push_back(std::move(part));
        at = end + 1;
      } else if (separators.find(text[at]) != std::string::npos) {
        ++at;
      } else {
        const std::size_t end = std::min(text.find_first_of(ends, at + 1), text.size());
        parts.push_back({text.substr(at, end - at), "", "", 0});
        at = end;
      }
    }
    return parts;
  }

  /// A statement with numbers needs a word by which it is known, and a sphere a size.
  void require_readable(const Field& field, const FormatStatement& statement) const {
    const auto has_one = [&](std::initializer_list<std::string_view> slots) {
      return std::ranges::any_of(statement.parts, [&](const FormatPart& part) {
        return !part.slot.empty() && std::ranges::find(slots, part.slot) != slots.end();
      });
    };
    const bool has_numbers = std::ranges::any_of(
        statement.parts, [](const FormatPart& part) { return part.numbers > 0; });
    if (has_numbers && statement.parts.front().word.empty()) {
      fields_.fail(field, "has a statement that begins with a slot, not with a word");
    }
    if (has_one({"centre"}) && !has_one({"radius", "diameter", "scale"})) {
      fields_.fail(field, "has a {centre} without {radius}, {diameter} or {scale} beside it");
    }
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

bool is_pixels(std::string_view slot) {
  return slot == "width" || slot == "height" || slot == "size";
}

bool is_whole(double number) { return number == std::floor(number) && std::abs(number) < 0x1p53; }

int sign_of_slot(std::string_view slot) { return slot == "distance" ? 1 : slot == "near" ? -1 : 0; }

bool is_of_camera(std::string_view slot) { return is_of(slot, Slot::Of::kCamera); }

bool FileFormat::has(std::string_view slot) const {
  return std::ranges::any_of(statements,
                             [&](const FormatStatement& statement) { return statement.has(slot); });
}

FileFormat read_format(std::string_view text, std::string_view file, std::string_view variant) {
  FileFormat format = FormatReader(file, variant).read(text);
  format.name = std::filesystem::path(file).stem().string();
  if (!variant.empty()) format.name += "-" + std::string(variant);
  return format;
}

}  // namespace raycheck::scene
