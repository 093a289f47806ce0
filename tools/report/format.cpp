#include "tools/report/format.h"

#include <fmt/color.h>
#include <fmt/core.h>

#include <array>
#include <cmath>

#include "scene/number.h"
#include "tools/report/version.h"

namespace raycheck::tools {

using properties::Discrepancy;

std::string red(std::string_view text, bool colours) {
  return colours ? fmt::format(fmt::fg(fmt::terminal_color::red), "{}", text) : std::string(text);
}

namespace {

/// Errors are upper bounds from enclosures 70 bits wide or better; below this an error may well be
/// 0.
constexpr double kSmallestShown = 1e-9;

}  // namespace

std::string error_text(std::optional<double> error) {
  if (!error) return "-";
  if (*error == 0) return "0";
  if (*error < kSmallestShown) return fmt::format("<{:.0e}", kSmallestShown);
  return fmt::format("{:.3g}", *error);
}

Json error_json(std::optional<double> error) {
  if (!error) return nullptr;
  if (std::isinf(*error)) return "infinity";
  return *error;
}

std::string numbers_text(const std::vector<double>& numbers) {
  if (numbers.empty()) return "miss";
  std::string text;
  for (const double x : numbers) {
    if (!text.empty()) text += ", ";
    text += scene::digits_and_hexfloat(x);
  }
  return text;
}

Json hexfloats(const std::vector<double>& numbers) {
  Json list = Json::array();
  for (const double x : numbers) list.push_back(scene::hexfloat(x));
  return list;
}

Json hexfloat_or_null(std::optional<double> number) {
  return number ? Json(scene::hexfloat(*number)) : Json(nullptr);
}

bool has_place(properties::Quantity quantity) {
  return quantity != properties::Quantity::kFrame &&
         quantity != properties::Quantity::kOrthonormality &&
         quantity != properties::Quantity::kRefusal;
}

std::string place_text(const properties::Place& place) {
  std::string text = place.pixel ? fmt::format("pixel ({}, {})", place.pixel->i, place.pixel->j)
                                 : fmt::format("ray {}", place.ray);
  if (place.sphere) text += fmt::format(", sphere {}", *place.sphere);
  return text;
}

std::string conventions_text(const scene::Conventions& conventions) {
  return fmt::format("rows {}, samples {}, origin {}, root {}, tangent {}", name(conventions.rows),
                     name(conventions.samples), name(conventions.origin), name(conventions.root),
                     name(conventions.tangent));
}

Json conventions_json(const scene::Conventions& conventions) {
  return {{"rows", name(conventions.rows)},
          {"samples", name(conventions.samples)},
          {"origin", name(conventions.origin)},
          {"root", name(conventions.root)},
          {"tangent", name(conventions.tangent)}};
}

std::string discrepancy_text(const Discrepancy& d, std::string_view indent, bool colours) {
  const properties::QuantityInfo& quantity = info(d.quantity);
  std::string head(quantity.name);
  if (has_place(d.quantity)) head += ", " + place_text(d.place);
  if (!d.what.empty()) head += fmt::format(", {}", d.what);
  if (d.wrong != properties::Wrong::kNot) {
    head += fmt::format(": {}", name(d.wrong));
  } else {
    head += fmt::format(": off by {} {}", error_text(d.error), quantity.unit);
  }
  std::string text = fmt::format("{}{}\n", indent,
                                 d.excuse == properties::Excuse::kNone ? red(head, colours) : head);
  if (d.quantity != properties::Quantity::kRefusal) {
    text += fmt::format("{}  got   {}\n", indent, numbers_text(d.got));
    if (!d.exact.empty() || d.wrong != properties::Wrong::kNot) {
      text += fmt::format("{}  exact {}\n", indent, numbers_text(d.exact));
    }
  }
  if (d.condition) {
    text += fmt::format("{}  condition number about {}\n", indent, error_text(d.condition));
  }
  if (d.excuse != properties::Excuse::kNone) {
    text += fmt::format("{}  excused: {}\n", indent, name(d.excuse));
  }
  return text;
}

Json discrepancy_json(const Discrepancy& d) {
  Json json;
  json["law"] = d.law;
  json["quantity"] = info(d.quantity).name;
  json["pixel"] = d.place.pixel ? Json{d.place.pixel->i, d.place.pixel->j} : Json(nullptr);
  json["ray"] = d.place.ray;
  json["sphere"] = d.place.sphere ? Json(*d.place.sphere) : Json(nullptr);
  json["what"] = d.what;
  json["wrong"] = d.wrong == properties::Wrong::kNot ? Json(nullptr) : Json(name(d.wrong));
  json["got"] = hexfloats(d.got);
  json["exact"] = hexfloats(d.exact);
  json["error"] = error_json(d.error);
  json["unit"] = info(d.quantity).unit;
  json["condition"] = error_json(d.condition);
  json["excuse"] = d.excuse == properties::Excuse::kNone ? Json(nullptr) : Json(name(d.excuse));
  return json;
}

namespace {

Json tally_json(const properties::Tally& tally, std::string_view unit) {
  Json json;
  json["cases"] = tally.cases;
  for (const auto& [wrong, number] : tally.wrong) json["wrong"][std::string(name(wrong))] = number;
  json["wrong_excused"] = tally.wrong_excused;
  if (!tally.errors.empty()) {
    json["unit"] = unit;
    json["median"] = error_json(tally.median());
    json["p999"] = error_json(tally.quantile(0.999));
    json["max"] = error_json(tally.max());
    json["max_ratio"] =
        error_json(tally.worst_ratio < 0 ? std::nullopt : std::optional(tally.worst_ratio));
    json["median_condition"] = error_json(tally.condition_quantile(0.5));
  }
  for (std::size_t k = 0; k < properties::kOutcomeCount; ++k) {
    json["outcomes"][std::string(properties::kOutcomeNames[k])] = tally.outcomes[k];
  }
  return json;
}

}  // namespace

Json weighed_json(const properties::Verdict& verdict) {
  Json json = Json::object();
  for (const auto& [quantity, tally] : verdict.tallies()) {
    json[std::string(info(quantity).name)] = tally_json(tally, info(quantity).unit);
  }
  return json;
}

namespace {

constexpr std::array<std::string_view, 4> kRungNames = {"intervals", "double-doubles", "balls",
                                                        "the field"};

}  // namespace

std::string decided_by_text(const reference::DecidedBy& decided_by) {
  std::string rungs;
  for (std::size_t k = 0; k < kRungNames.size(); ++k) {
    if (decided_by.rungs[k] == 0) continue;
    rungs +=
        fmt::format("{}{} by {}", rungs.empty() ? "" : ", ", decided_by.rungs[k], kRungNames[k]);
  }
  return fmt::format("{} by the filter, {} exactly{}", decided_by.filter, decided_by.fallback(),
                     rungs.empty() ? "" : " (" + rungs + ")");
}

Json decided_by_json(const reference::DecidedBy& decided_by) {
  return {{"filter", decided_by.filter},
          {"intervals", decided_by.rungs[0]},
          {"double_doubles", decided_by.rungs[1]},
          {"balls", decided_by.rungs[2]},
          {"field", decided_by.rungs[3]}};
}

std::string count_text(std::uint64_t count, std::string_view noun) {
  return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

Json json_header(std::string_view command) {
  return {{"program", "raycheck"}, {"version", kVersion}, {"command", command}};
}

}  // namespace raycheck::tools
