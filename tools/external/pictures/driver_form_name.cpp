// The names of forms of driver files, for command lines and reports.

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <stdexcept>

#include "tools/external/pictures/driver_form.h"

namespace raycheck::tools {
namespace {

constexpr std::string_view kAuto = "auto";
constexpr std::string_view kNoLight = "no-light";
constexpr std::string_view kLight = "light";
constexpr std::string_view kOrder = "order=";
/// Characters that end a part, or that shells interpret within quotes of either kind.
constexpr std::string_view kEncoded = ":%'\"$`\\!";

std::string_view number_name(DriverNumbers numbers) {
  return kDriverNumberNames[static_cast<std::size_t>(numbers)];
}

std::string encoded(char c) { return fmt::format("%{:02X}", static_cast<unsigned char>(c)); }

bool is_count(std::string_view part) {
  return !part.empty() &&
         std::all_of(part.begin(), part.end(), [](char c) { return c >= '0' && c <= '9'; });
}

/// Whether a part of a name is not an extra line.
bool is_other_than_line(std::string_view part) {
  return is_count(part) || part == kNoLight || part == kLight || part.starts_with(kOrder) ||
         std::find(kDriverNumberNames.begin(), kDriverNumberNames.end(), part) !=
             kDriverNumberNames.end();
}

std::string line_part(const std::string& line) {
  std::string part;
  for (const char c : line) {
    part += kEncoded.find(c) != std::string_view::npos ? encoded(c) : std::string(1, c);
  }
  return is_other_than_line(part) ? encoded(part.front()) + part.substr(1) : part;
}

std::string line_of(std::string_view part) {
  std::string line;
  for (std::size_t at = 0; at < part.size(); ++at) {
    if (part[at] != '%') {
      line += part[at];
      continue;
    }
    unsigned int byte = 0;
    const std::string_view digits = part.substr(at + 1, 2);
    const auto read = std::from_chars(digits.data(), digits.data() + digits.size(), byte, 16);
    if (digits.size() < 2 || read.ptr != digits.data() + 2) {
      throw std::invalid_argument(
          fmt::format("'{}': write % as %25, or two hexadecimal digits after it", part));
    }
    if (byte == '\n' || byte == '\r') {
      throw std::invalid_argument(fmt::format("'{}': an extra line is one line", part));
    }
    line += static_cast<char>(byte);
    at += 2;
  }
  return line;
}

int sphere_numbers_of(std::string_view part) {
  const auto* const known =
      std::find_if(kSphereNumbers.begin(), kSphereNumbers.end(),
                   [&](int numbers) { return std::to_string(numbers) == part; });
  if (known == kSphereNumbers.end()) {
    throw std::invalid_argument(
        fmt::format("{} numbers: a sphere has one of {}", part, fmt::join(kSphereNumbers, ", ")));
  }
  return *known;
}

std::vector<std::string_view> split(std::string_view text, char mark) {
  std::vector<std::string_view> parts;
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t end = std::min(text.find(mark, at), text.size());
    parts.push_back(text.substr(at, end - at));
    at = end + 1;
  }
  return parts;
}

std::vector<std::string> order_of(std::string_view part, scene::Dialect dialect) {
  std::vector<std::string> order;
  for (const auto keyword : split(part.substr(kOrder.size()), ',')) order.emplace_back(keyword);
  const std::vector<std::string> usual = usual_order(dialect);
  if (!std::is_permutation(order.begin(), order.end(), usual.begin(), usual.end())) {
    throw std::invalid_argument(
        fmt::format("'{}' must have each of these once: {}", part, fmt::join(usual, ",")));
  }
  return order;
}

}  // namespace

std::string DriverForm::name() const {
  std::string said;
  for (const DriverPreset& preset : driver_presets()) {
    const bool is_base = preset.form.dialect == dialect &&
                         preset.form.sphere_numbers == sphere_numbers &&
                         preset.form.extra_lines == extra_lines;
    if (is_base) said = preset.name;
  }
  if (said.empty()) {
    said = fmt::format("{}:{}", kDialectNames[static_cast<std::size_t>(dialect)], sphere_numbers);
    for (const std::string& line : extra_lines) said += ":" + line_part(line);
  }
  if (light == DriverLight::kNone) said += fmt::format(":{}", kNoLight);
  if (numbers == DriverNumbers::kFixed) said += fmt::format(":{}", number_name(numbers));
  if (!order.empty()) said += fmt::format(":{}{}", kOrder, fmt::join(order, ","));
  return said;
}

DriverForm driver_form(std::string_view name) {
  const std::vector<std::string_view> parts = split(name, ':');
  const auto preset = driver_preset(parts.front());
  if (!preset) {
    std::string names;
    for (const DriverPreset& one : driver_presets()) {
      names += (names.empty() ? "" : ", ") + std::string(one.name);
    }
    throw std::invalid_argument(
        fmt::format("the dialects are {}, and forms such as B:17:no-light", names));
  }
  DriverForm form = *preset;
  std::vector<std::string> lines;
  for (std::size_t k = 1; k < parts.size(); ++k) {
    const std::string_view part = parts[k];
    if (is_count(part)) {
      form.sphere_numbers = sphere_numbers_of(part);
    } else if (part == kNoLight || part == kLight) {
      form.light = part == kLight ? DriverLight::kBehind : DriverLight::kNone;
    } else if (part.starts_with(kOrder)) {
      form.order = order_of(part, form.dialect);
    } else if (part == number_name(DriverNumbers::kFixed)) {
      form.numbers = DriverNumbers::kFixed;
    } else if (part == number_name(DriverNumbers::kShortest)) {
      form.numbers = DriverNumbers::kShortest;
    } else {
      lines.push_back(line_of(part));
    }
  }
  if (!lines.empty()) form.extra_lines = std::move(lines);
  return form;
}

DriverRule driver_rule(std::string_view name) {
  if (name == kAuto) return {};
  if (name.find(':') != std::string_view::npos) return {driver_form(name), false, true};
  if (const auto form = driver_preset(name)) return {*form, false, true};
  std::string names;
  for (const DriverPreset& preset : driver_presets()) names += std::string(preset.name) + ", ";
  throw std::invalid_argument(fmt::format("must be one of {}{}", names, kAuto));
}

DriverRule read_driver(scene::TomlFields& fields, const scene::TomlFields::Table& from) {
  fields.require_known(from, {"preset", "others"});
  DriverRule rule;
  if (const auto field = fields.optional(from, "preset")) {
    try {
      rule = driver_rule(fields.text(*field));
    } catch (const std::invalid_argument& error) {
      fields.fail(*field, error.what());
    }
  }
  if (const auto field = fields.optional(from, "others")) rule.tries_others = fields.flag(*field);
  return rule;
}

}  // namespace raycheck::tools
