#include "tools/external/pictures/driver_form.h"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <boost/algorithm/string/classification.hpp>
#include <boost/algorithm/string/predicate.hpp>
#include <boost/algorithm/string/split.hpp>
#include <stdexcept>

#include "scene/number.h"
#include "scene/text.h"

namespace raycheck::tools {
namespace {

using scene::FileFormat;
using scene::FormatStatement;

constexpr std::string_view kAuto = "auto";
constexpr std::string_view kNoLight = "no-light";
constexpr std::string_view kLight = "light";
constexpr std::string_view kOrder = "order=";
constexpr std::string_view kExtra = "extra";
std::string_view number_name(DriverNumbers numbers) {
  return kDriverNumberNames[static_cast<std::size_t>(numbers)];
}

bool is_count(std::string_view part) {
  return !part.empty() && std::ranges::all_of(part, [](char c) { return c >= '0' && c <= '9'; });
}

bool has_count(const FileFormat& format, std::int64_t numbers) {
  return std::ranges::find(format.sphere_numbers, numbers) != format.sphere_numbers.end();
}

std::int64_t sphere_numbers_of(std::string_view part, const FileFormat& format) {
  for (const std::int64_t numbers : format.sphere_numbers) {
    if (std::to_string(numbers) == part) return numbers;
  }
  throw std::invalid_argument(fmt::format("{} numbers: a sphere line has one of {}", part,
                                          fmt::join(format.sphere_numbers, ", ")));
}

std::vector<std::string> split(std::string_view text, const char* mark) {
  std::vector<std::string> parts;
  return boost::split(parts, text, boost::is_any_of(mark));
}

/// "A, B, C, 2017, ..."
std::string preset_names() { return scene::joined(driver_presets(), ", ", &DriverPreset::name); }

std::vector<std::string> order_of(std::string_view part, const FileFormat& format) {
  std::vector<std::string> order = split(part.substr(kOrder.size()), ",");
  const std::vector<std::string> usual = usual_order(format);
  if (!std::ranges::is_permutation(order, usual)) {
    throw std::invalid_argument(
        fmt::format("'{}' must list each of these once: {}", part, fmt::join(usual, ",")));
  }
  return order;
}

/// The format in this form. A sphere's line is cut after its numbers.
FileFormat deviating(const DriverForm& form) {
  FileFormat format = *form.format;
  if (!format.has_forms()) return format;
  format.has_exponents = form.numbers == DriverNumbers::kShortest;
  std::erase_if(format.statements, [&](const FormatStatement& statement) {
    return (statement.keyword() == kLight && form.light == DriverLight::kNone) ||
           (statement.keyword() == kExtra && form.extra_lines.empty());
  });
  for (FormatStatement& statement : format.statements) {
    if (statement.keyword() == kExtra) {
      statement.parts.front().written = scene::joined(form.extra_lines, "\n");
    }
    std::size_t count = 0;
    for (scene::FormatPart& part : statement.parts) {
      count += part.numbers;
      if (part.slot != "*" || !statement.has("centre")) continue;
      std::vector<std::string> more = split(part.written, " ");
      more.resize(static_cast<std::size_t>(form.sphere_numbers) - count);
      part.written = fmt::format("{}", fmt::join(more, " "));
    }
  }
  std::ranges::stable_sort(format.statements, {}, [&](const FormatStatement& statement) {
    return std::ranges::find(form.order, statement.keyword()) - form.order.begin();
  });
  return format;
}

/// The form with the deviations of DriverForm::name(), without its first part.
DriverForm deviating_form(DriverForm form, const std::vector<std::string>& parts) {
  std::vector<std::string> lines;
  for (std::size_t k = 1; k < parts.size(); ++k) {
    const std::string& part = parts[k];
    if (is_count(part)) {
      form.sphere_numbers = sphere_numbers_of(part, *form.format);
    } else if (part == kNoLight || part == kLight) {
      form.light = part == kLight ? DriverLight::kBehind : DriverLight::kNone;
    } else if (part.starts_with(kOrder)) {
      form.order = order_of(part, *form.format);
    } else if (part == number_name(DriverNumbers::kFixed)) {
      form.numbers = DriverNumbers::kFixed;
    } else if (part == number_name(DriverNumbers::kShortest)) {
      form.numbers = DriverNumbers::kShortest;
    } else {
      lines.push_back(part);
    }
  }
  if (!lines.empty()) form.extra_lines = std::move(lines);
  return form;
}

/// The lines of an entry of FileFormat::extra_lines.
std::vector<std::string> extra_of(const std::string& extra) {
  return extra.empty() ? std::vector<std::string>{} : split(extra, "\n");
}

}  // namespace

std::string DriverForm::ending() const {
  return format->endings.empty() ? ".txt" : format->endings.front();
}

std::string DriverForm::file_name() const { return "scene" + ending(); }

bool is_scene_file(std::string_view name) {
  const auto has_it = [&](const auto& format) {
    return DriverForm{.format = &format.second}.file_name() == name;
  };
  return name == DriverForm{}.file_name() || std::ranges::any_of(scene::formats(), has_it);
}

std::string DriverForm::text() const {
  if (!format->has_forms()) return format->name;
  std::string said = fmt::format("{}, spheres of {} numbers", format->name, sphere_numbers);
  for (const std::string& line : extra_lines) said += ", " + line;
  said += light == DriverLight::kBehind ? ", a light" : ", no light";
  if (numbers == DriverNumbers::kFixed) said += ", no exponents";
  if (!order.empty()) said += fmt::format(", in the order {}", fmt::join(order, " "));
  return said;
}

std::vector<std::string> usual_order(const FileFormat& format) {
  std::vector<std::string> keywords;
  for (const FormatStatement& statement : format.statements) {
    keywords.emplace_back(statement.keyword());
  }
  return keywords;
}

const std::vector<DriverPreset>& driver_presets() {
  static const std::vector<DriverPreset> kPresets = [] {
    std::vector<DriverPreset> presets;
    for (const auto& [name, format] : scene::formats()) {
      if (format.has_forms()) presets.push_back({name, {&format}});
    }
    const std::vector<DriverPreset> of_formats = presets;
    for (const DriverPreset& one : of_formats) {
      for (const auto& [name, form] : one.form.format->presets) {
        presets.push_back({name, deviating_form(one.form, split(form, ":"))});
      }
    }
    return presets;
  }();
  return kPresets;
}

std::optional<DriverForm> driver_preset(std::string_view name) {
  for (const DriverPreset& preset : driver_presets()) {
    if (boost::iequals(name, preset.name)) return preset.form;
  }
  return {};
}

std::string DriverForm::name() const {
  if (!format->has_forms()) return format->name;
  std::string said;
  for (const DriverPreset& preset : driver_presets()) {
    const bool is_base = preset.form.format == format &&
                         preset.form.sphere_numbers == sphere_numbers &&
                         preset.form.extra_lines == extra_lines;
    if (is_base) said = preset.name;
  }
  if (said.empty()) {
    said = fmt::format("{}:{}", format->name, sphere_numbers);
    for (const std::string& line : extra_lines) said += ":" + line;
  }
  if (light == DriverLight::kNone) said += fmt::format(":{}", kNoLight);
  if (numbers == DriverNumbers::kFixed) said += fmt::format(":{}", number_name(numbers));
  if (!order.empty()) said += fmt::format(":{}{}", kOrder, fmt::join(order, ","));
  return said;
}

DriverForm driver_form(std::string_view name) {
  const std::vector<std::string> parts = split(name, ":");
  const auto preset = driver_preset(parts.front());
  if (!preset) {
    throw std::invalid_argument(
        fmt::format("the dialects are {}, and forms such as B:17:no-light", preset_names()));
  }
  return deviating_form(*preset, parts);
}

DriverRule driver_rule(std::string_view name, const std::filesystem::path& folder) {
  if (name == kAuto) return {};
  constexpr std::string_view kFile = ".toml";
  const std::size_t at = name.find(kFile);
  const bool is_file =
      at != name.npos && (name.ends_with(kFile) || name.substr(at + kFile.size()).starts_with(':'));
  const std::size_t end = is_file ? at + kFile.size() : name.size();
  if (const auto* format = scene::format_named(is_file ? folder / name.substr(0, end) : name)) {
    if (!is_file || end == name.size()) return {{format}, !variants_of(*format).empty(), true};
    const std::string variant(name.substr(end + 1));
    if (std::ranges::find(format->variants, variant) == format->variants.end()) {
      const std::string has = scene::joined(format->variants);
      throw std::invalid_argument(fmt::format("{} has no variant {}; it has {}",
                                              name.substr(0, end), variant,
                                              has.empty() ? "none" : has));
    }
    return {{scene::format_named(folder / name.substr(0, end), variant)}, false, true};
  }
  if (name.find(':') != std::string_view::npos) return {driver_form(name), false, true};
  if (const auto form = driver_preset(name)) return {*form, false, true};
  std::string formats;
  for (const auto& [known, format] : scene::formats()) {
    if (!format.has_forms()) formats += known + ", ";
  }
  throw std::invalid_argument(fmt::format(
      "must be one of {}, {}, or a form such as B:17:no-light; or a format: {}or FORMAT.toml",
      preset_names(), kAuto, formats));
}

DriverRule read_driver(scene::TomlFields& fields, const scene::TomlFields::Table& from,
                       const std::filesystem::path& folder) {
  fields.require_known(from, {"preset", "others"});
  DriverRule rule;
  if (const auto field = fields.optional(from, "preset")) {
    const std::string preset = fields.text(*field);
    if (preset.find(".toml") != std::string::npos && preset.find('/') != std::string::npos) {
      fields.fail(*field, "must be a file name, without a folder");
    }
    try {
      rule = driver_rule(fields.text(*field), folder);
    } catch (const std::invalid_argument& error) {
      fields.fail(*field, error.what());
    }
  }
  if (const auto field = fields.optional(from, "others")) rule.tries_others = fields.flag(*field);
  return rule;
}

std::vector<DriverForm> fuller_forms(const DriverForm& form) {
  std::vector<DriverForm> fuller;
  if (!form.extra_lines.empty()) return fuller;
  for (const DriverPreset& preset : driver_presets()) {
    const DriverForm& year = preset.form;
    if (year.format != form.format || year.extra_lines.empty() ||
        year.sphere_numbers < form.sphere_numbers) {
      continue;
    }
    fuller.insert(fuller.begin(), form);
    fuller.front().sphere_numbers = year.sphere_numbers;
    fuller.front().extra_lines = year.extra_lines;
  }
  return fuller;
}

std::vector<DriverForm> known_forms(const DriverForm& first) {
  std::vector<DriverForm> forms = {first};
  for (const FileFormat* variant : scene::variants_of(*first.format)) {
    forms.push_back(first);
    forms.back().format = variant;
  }
  if (!first.format->has_forms()) return forms;
  const auto add = [&](DriverForm form) {
    form.numbers = first.numbers;
    if (form.format == first.format) form.order = first.order;
    if (std::ranges::find(forms, form) == forms.end()) forms.push_back(form);
  };
  std::vector<const FileFormat*> formats = {first.format};
  for (const std::string& name : first.format->similar) {
    if (const FileFormat* other = scene::format_named(name)) formats.push_back(other);
  }
  for (const DriverPreset& preset : driver_presets()) {
    if (std::ranges::find(formats, preset.form.format) != formats.end()) add(preset.form);
  }
  for (std::size_t k = 0; k < first.format->extra_lines.size(); ++k) {
    for (const DriverLight light : {DriverLight::kBehind, DriverLight::kNone}) {
      for (const std::int64_t numbers : first.format->sphere_numbers) {
        for (const FileFormat* format : formats) {
          if (k < format->extra_lines.size() && has_count(*format, numbers)) {
            add({format, numbers, extra_of(format->extra_lines[k]), light});
          }
        }
      }
    }
  }
  return forms;
}

std::string driver_text(const scene::Scene& scene, const DriverForm& form,
                        const std::vector<Colour>& colours) {
  std::vector<std::array<double, 3>> parts;
  for (const auto& [red, green, blue] : colours) {
    parts.push_back({red / 255.0, green / 255.0, blue / 255.0});
  }
  return write_formatted(deviating(form), scene, parts);
}

}  // namespace raycheck::tools
