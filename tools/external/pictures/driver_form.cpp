#include "tools/external/pictures/driver_form.h"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <boost/algorithm/string/classification.hpp>
#include <boost/algorithm/string/predicate.hpp>
#include <boost/algorithm/string/split.hpp>
#include <charconv>
#include <map>
#include <stdexcept>

#include "scene/number.h"
#include "scene/text.h"

namespace raycheck::tools {
namespace {

using scene::Dialect;

constexpr int kUpToSpecular = 13;
constexpr int kUpToReflected = 16;

/// The line from which renderers of a dialect read the number of reflections.
std::string recursion_line(Dialect dialect, int level) {
  return fmt::format("{} {}", dialect == Dialect::kA ? "recursionLevel" : "recursionlevel", level);
}

std::string number_text(double x, DriverNumbers numbers) {
  if (numbers == DriverNumbers::kShortest) return scene::shortest(x);
  std::array<char, 1100> text{};
  const auto end =
      std::to_chars(text.data(), text.data() + text.size(), x, std::chars_format::fixed);
  return {text.data(), end.ptr};
}

/// A position behind the eye, as far from it as the look-at point, but not the world's origin.
scene::Point3 light_position(const scene::Camera& camera) {
  const auto& E = camera.eye;
  const auto& A = camera.look_at;
  const auto behind = [&](double k) {
    return scene::Point3{E.x + k * (E.x - A.x), E.y + k * (E.y - A.y), E.z + k * (E.z - A.z)};
  };
  const scene::Point3 at = behind(1);
  return at.x == 0 && at.y == 0 && at.z == 0 ? behind(2) : at;
}

constexpr std::string_view kAuto = "auto";
constexpr std::string_view kNoLight = "no-light";
constexpr std::string_view kLight = "light";
constexpr std::string_view kOrder = "order=";
std::string_view number_name(DriverNumbers numbers) {
  return kDriverNumberNames[static_cast<std::size_t>(numbers)];
}

bool is_count(std::string_view part) {
  return !part.empty() && std::ranges::all_of(part, [](char c) { return c >= '0' && c <= '9'; });
}

int sphere_numbers_of(std::string_view part) {
  const auto* const known = std::ranges::find_if(
      kSphereNumbers, [&](int numbers) { return std::to_string(numbers) == part; });
  if (known == kSphereNumbers.end()) {
    throw std::invalid_argument(fmt::format("{} numbers: a sphere line has one of {}", part,
                                            fmt::join(kSphereNumbers, ", ")));
  }
  return *known;
}

std::vector<std::string> split(std::string_view text, const char* mark) {
  std::vector<std::string> parts;
  return boost::split(parts, text, boost::is_any_of(mark));
}

/// "A, B, C, 2017, ..."
std::string preset_names() { return scene::joined(driver_presets(), ", ", &DriverPreset::name); }

std::vector<std::string> order_of(std::string_view part, scene::Dialect dialect) {
  std::vector<std::string> order = split(part.substr(kOrder.size()), ",");
  const std::vector<std::string> usual = usual_order(dialect);
  if (!std::ranges::is_permutation(order, usual)) {
    throw std::invalid_argument(
        fmt::format("'{}' must list each of these once: {}", part, fmt::join(usual, ",")));
  }
  return order;
}

}  // namespace

std::string DriverForm::ending() const {
  return format == nullptr || format->endings.empty() ? ".txt" : format->endings.front();
}

std::string DriverForm::file_name() const { return "scene" + ending(); }

bool is_scene_file(std::string_view name) {
  const auto has_it = [&](const auto& format) {
    return DriverForm{.format = &format.second}.file_name() == name;
  };
  return name == DriverForm{}.file_name() || std::ranges::any_of(scene::formats(), has_it);
}

std::string DriverForm::text() const {
  if (format != nullptr) return format->name;
  std::string said = fmt::format("{}, spheres of {} numbers", scene::name(dialect), sphere_numbers);
  for (const std::string& line : extra_lines) said += ", " + line;
  said += light == DriverLight::kBehind ? ", a light" : ", no light";
  if (numbers == DriverNumbers::kFixed) said += ", no exponents";
  if (!order.empty()) said += fmt::format(", in the order {}", fmt::join(order, " "));
  return said;
}

std::vector<std::string> usual_order(Dialect dialect) {
  if (dialect == Dialect::kC) {
    return {"camera", "bounds", "res", "extra", "ambient", "light", "sphere"};
  }
  return {"eye", "look", "up", "d", "bounds", "res", "extra", "ambient", "light", "sphere"};
}

DriverForm form_of(Dialect dialect) {
  DriverForm form;
  form.dialect = dialect;
  return form;
}

std::span<const DriverPreset> driver_presets() {
  const auto year = [](Dialect dialect, int sphere_numbers) {
    DriverForm form = form_of(dialect);
    form.sphere_numbers = sphere_numbers;
    form.extra_lines = {recursion_line(dialect, 0)};
    return form;
  };
  static const std::vector<DriverPreset> kPresets = {
      {"A", form_of(Dialect::kA)},     {"B", form_of(Dialect::kB)},
      {"C", form_of(Dialect::kC)},     {"2017", year(Dialect::kA, 16)},
      {"2018", year(Dialect::kA, 20)}, {"2019", year(Dialect::kB, 16)},
      {"2020", year(Dialect::kC, 17)}};
  return kPresets;
}

std::optional<DriverForm> driver_preset(std::string_view name) {
  for (const DriverPreset& preset : driver_presets()) {
    if (boost::iequals(name, preset.name)) return preset.form;
  }
  return {};
}

std::string DriverForm::name() const {
  if (format != nullptr) return format->name;
  std::string said;
  for (const DriverPreset& preset : driver_presets()) {
    const bool is_base = preset.form.dialect == dialect &&
                         preset.form.sphere_numbers == sphere_numbers &&
                         preset.form.extra_lines == extra_lines;
    if (is_base) said = preset.name;
  }
  if (said.empty()) {
    said = fmt::format("{}:{}", scene::name(dialect), sphere_numbers);
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
  DriverForm form = *preset;
  std::vector<std::string> lines;
  for (std::size_t k = 1; k < parts.size(); ++k) {
    const std::string& part = parts[k];
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
      lines.push_back(part);
    }
  }
  if (!lines.empty()) form.extra_lines = std::move(lines);
  return form;
}

DriverRule driver_rule(std::string_view name, const std::filesystem::path& folder) {
  if (name == kAuto) return {};
  const bool is_file = name.ends_with(".toml");
  if (const auto* format = scene::format_named(is_file ? folder / name : name)) {
    DriverForm form;
    form.format = format;
    return {form, !scene::variants_of(*format).empty(), true};
  }
  if (name.find(':') != std::string_view::npos) return {driver_form(name), false, true};
  if (const auto form = driver_preset(name)) return {*form, false, true};
  const auto formats = scene::joined(scene::formats(), ", ", [](auto& one) { return one.first; });
  throw std::invalid_argument(fmt::format(
      "must be one of {}, {}, or a form such as B:17:no-light; or a format: {}, or FORMAT.toml",
      preset_names(), kAuto, formats));
}

DriverRule read_driver(scene::TomlFields& fields, const scene::TomlFields::Table& from,
                       const std::filesystem::path& folder) {
  fields.require_known(from, {"preset", "others"});
  DriverRule rule;
  if (const auto field = fields.optional(from, "preset")) {
    const std::string preset = fields.text(*field);
    if (preset.ends_with(".toml") && preset.find('/') != std::string::npos) {
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
  if (form.format != nullptr || !form.extra_lines.empty()) return fuller;
  for (const DriverPreset& preset : driver_presets()) {
    const DriverForm& year = preset.form;
    if (year.dialect != form.dialect || year.extra_lines.empty() ||
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
  if (first.format != nullptr) {
    for (const scene::FileFormat* variant : scene::variants_of(*first.format)) {
      forms.push_back(first);
      forms.back().format = variant;
    }
    return forms;
  }
  const auto add = [&](DriverForm form) {
    form.numbers = first.numbers;
    if (form.dialect == first.dialect) form.order = first.order;
    if (std::ranges::find(forms, form) == forms.end()) forms.push_back(form);
  };
  for (const DriverPreset& preset : driver_presets()) add(preset.form);
  std::vector<Dialect> dialects = {first.dialect};
  for (const Dialect other : {Dialect::kA, Dialect::kB, Dialect::kC}) {
    if (other != first.dialect) dialects.push_back(other);
  }
  const auto add_all = [&](const auto& recursion) {
    for (const DriverLight light : {DriverLight::kBehind, DriverLight::kNone}) {
      for (const int numbers : kSphereNumbers) {
        for (const Dialect dialect : dialects) add({dialect, numbers, recursion(dialect), light});
      }
    }
  };
  using Lines = std::vector<std::string>;
  add_all([](Dialect dialect) { return Lines{recursion_line(dialect, 0)}; });
  add_all([](Dialect) { return Lines{}; });
  add_all([](Dialect dialect) { return Lines{recursion_line(dialect, 1)}; });
  return forms;
}

std::string driver_text(const scene::Scene& scene, const DriverForm& form,
                        const std::vector<Colour>& colours) {
  if (form.format != nullptr) {
    std::vector<std::array<double, 3>> parts;
    for (const auto& [red, green, blue] : colours) {
      parts.push_back({red / 255.0, green / 255.0, blue / 255.0});
    }
    return write_formatted(*form.format, scene, parts);
  }
  const scene::Camera& c = *scene.camera;
  const auto number = [&](double x) { return number_text(x, form.numbers); };
  const auto words = [&](const auto& v) {
    return fmt::format("{} {} {}", number(v.x), number(v.y), number(v.z));
  };
  const bool is_a = form.dialect == Dialect::kA;
  const std::string d = number(is_a ? -c.near : c.near);
  std::map<std::string, std::string> lines;
  lines["camera"] =
      fmt::format("camera {} {} {} {}\n", words(c.eye), words(c.look_at), words(c.up), d);
  lines["eye"] = fmt::format("eye {}\n", words(c.eye));
  lines["look"] = fmt::format("look {}\n", words(c.look_at));
  lines["up"] = fmt::format("up {}\n", words(c.up));
  lines["d"] = fmt::format("d {}\n", d);
  lines["bounds"] =
      fmt::format("bounds {} {} {} {}\n", number(c.left), number(is_a ? c.bottom : c.right),
                  number(is_a ? c.right : c.bottom), number(c.top));
  lines["res"] = fmt::format("res {} {}\n", c.width, c.height);
  for (const std::string& line : form.extra_lines) lines["extra"] += line + "\n";
  lines["ambient"] = "ambient 1 1 1\n";
  if (form.light == DriverLight::kBehind) {
    lines["light"] = fmt::format("light {} 1 1 1 1\n", words(light_position(c)));
  }
  for (std::size_t k = 0; k < scene.spheres.size(); ++k) {
    const auto& [centre, radius] = scene.spheres[k];
    const auto& [red, green, blue] = colours[k];
    std::string line =
        fmt::format("sphere {} {} {} {} {} 0 0 0 0 0 0", words(centre), number(radius),
                    number(red / 255.0), number(green / 255.0), number(blue / 255.0));
    for (int n = kUpToSpecular; n < form.sphere_numbers; ++n) {
      line += n < kUpToReflected ? " 0" : " 1";
    }
    lines["sphere"] += line + "\n";
  }
  std::string text;
  for (const std::string& keyword : form.order.empty() ? usual_order(form.dialect) : form.order) {
    text += lines[keyword];
  }
  return text;
}

}  // namespace raycheck::tools
