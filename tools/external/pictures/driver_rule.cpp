#include "tools/external/pictures/driver_rule.h"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <stdexcept>

namespace raycheck::tools {
namespace {

constexpr std::string_view kAuto = "auto";

}  // namespace

DriverRule driver_rule(std::string_view name) {
  if (name == kAuto) return {};
  if (name.find(':') != std::string_view::npos) return {driver_form(name), false, true};
  if (const auto form = driver_preset(name)) return {*form, false, true};
  std::string names;
  for (const DriverPreset& preset : driver_presets()) names += std::string(preset.name) + ", ";
  throw std::invalid_argument(fmt::format("must be one of {}{}", names, kAuto));
}

DriverRule read_driver(scene::TomlFields& fields, const scene::TomlFields::Table& from) {
  fields.require_known(
      from, {"preset", "others", "sphere_numbers", "extra_lines", "light", "numbers", "order"});
  DriverRule rule;
  if (const auto field = fields.optional(from, "preset")) {
    try {
      rule = driver_rule(fields.text(*field));
    } catch (const std::invalid_argument& error) {
      fields.fail(*field, error.what());
    }
  }
  if (const auto field = fields.optional(from, "others")) rule.tries_others = fields.flag(*field);
  DriverForm& form = rule.form;
  if (const auto field = fields.optional(from, "sphere_numbers")) {
    const auto count = fields.integer(*field, "a whole number of numbers");
    if (std::find(kSphereNumbers.begin(), kSphereNumbers.end(), count) == kSphereNumbers.end()) {
      fields.fail(*field, fmt::format("must be one of {}", fmt::join(kSphereNumbers, ", ")));
    }
    form.sphere_numbers = static_cast<int>(count);
  }
  if (const auto field = fields.optional(from, "extra_lines")) {
    form.extra_lines = fields.texts(*field);
    for (const scene::TomlFields::Field& line : fields.list(*field)) {
      if (fields.text(line).find('\n') != std::string::npos) fields.fail(line, "must be one line");
    }
  }
  fields.choose(from, "light", kDriverLightNames, form.light);
  fields.choose(from, "numbers", kDriverNumberNames, form.numbers);
  if (const auto field = fields.optional(from, "order")) {
    form.order = fields.texts(*field);
    const std::vector<std::string> usual = usual_order(form.dialect);
    if (!std::is_permutation(form.order.begin(), form.order.end(), usual.begin(), usual.end())) {
      fields.fail(*field, fmt::format("must have each of these once: {}", fmt::join(usual, ", ")));
    }
  }
  rule.is_asked_for = rule.is_asked_for || !(form == DriverForm{});
  return rule;
}

}  // namespace raycheck::tools
