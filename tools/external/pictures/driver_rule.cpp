#include "tools/external/pictures/driver_rule.h"

#include <fmt/core.h>

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
