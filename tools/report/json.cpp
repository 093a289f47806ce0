#include "tools/report/json.h"

#include <cmath>

#include "scene/fields.h"
#include "scene/number.h"
#include "scene/text.h"
#include "tools/report/version.h"
#include "tools/report/words.h"

namespace raycheck::tools {

using properties::Discrepancy;
using properties::ExcuseKind;
using properties::Tally;

namespace {

/// The JSON library escapes ASCII control characters, but not DEL, C1 and characters that change
/// the writing direction.
std::string spelled(const Json& json, int indent) {
  const std::string text = json.dump(indent, ' ', false, Json::error_handler_t::replace);
  std::string without_delete;
  for (const char c : text) {
    // Logs of GitHub workflows interpret "##[error]" anywhere.
    const bool begins_command = c == '[' && without_delete.ends_with("##");
    without_delete += c == '\x7f' ? "\\u007f" : begins_command ? "\\u005b" : std::string(1, c);
  }
  return scene::visible(without_delete) + "\n";
}

}  // namespace

std::string json_text(const Json& json) { return spelled(json, 2); }
std::string json_line(const Json& json) { return spelled(json, -1); }

Json json_header(std::string_view command) {
  return {{"program", "raycheck"},
          {"version", kVersion},
          {"schema_version", kSchemaVersion},
          {"command", command}};
}

std::string interrupted_json_text(std::string_view command) {
  Json json = json_header(command);
  json["interrupted"] = true;
  return json_text(json);
}

Json error_json(std::optional<double> error) {
  if (!error) return nullptr;
  if (std::isinf(*error)) return "infinity";
  return *error;
}

Json hexfloats(const std::vector<double>& numbers) { return list_json(numbers, scene::hexfloat); }

Json hexfloat_or_null(std::optional<double> number) { return or_null(number, scene::hexfloat); }

Json conventions_json(const scene::Conventions& conventions) {
  Json json;
  const auto add = [&](const char* key, const auto& value) {
    if constexpr (std::is_same_v<decltype(value), const double&>) {
      json[key] = error_json(value);
    } else {
      json[key] = name(value);
    }
  };
  for_each_choice(conventions, add);
  for_each_field(conventions.valid, add);
  return json;
}

Json explanations_json(const std::vector<properties::Explanation>& explanations) {
  return list_json(explanations, [](const properties::Explanation& one) -> Json {
    return {{"sentence", one.sentence}, {"wrong", one.errors}, {"explained", one.explained}};
  });
}

Json pixel_json(const scene::Pixel& pixel) { return {pixel.i, pixel.j}; }

Json place_json(const properties::Place& place) {
  return {{"pixel", or_null(place.pixel, pixel_json)},
          {"ray", place.ray},
          {"sphere", or_null(place.sphere)}};
}

void add_scene(Json& json, const std::string& path, const scene::Scene& scene) {
  json["scene"] = path;
  json["width"] = or_null(scene.camera, [](const scene::Camera& camera) { return camera.width; });
  json["height"] = or_null(scene.camera, [](const scene::Camera& camera) { return camera.height; });
}

Json too_few_json(const std::pair<properties::Quantity, properties::Expected>& too_few) {
  return {{"quantity", info(too_few.first).name}, {"question", name(too_few.second)}};
}

Json excuse_json(const Discrepancy& d) {
  const properties::Excuse& excuse = d.excuse;
  if (excuse.kind == ExcuseKind::kNone) return nullptr;
  const bool has_amount = excuse.kind != ExcuseKind::kOutsideDomain;
  Json json = {{"kind", name(excuse.kind)},
               {"amount", has_amount ? error_json(excuse.amount) : Json(nullptr)},
               {"witness", nullptr},
               {"sentence", excuse_text(d)}};
  if (excuse.kind != ExcuseKind::kWitness) return json;
  json["witness"] = Json::array();
  for (std::size_t k = 0; k < excuse.witness.size(); ++k) {
    if (excuse.witness[k] == 0) continue;
    json["witness"].push_back(
        {{"input", input_name(d, k)}, {"share", scene::hexfloat(excuse.witness[k])}});
  }
  return json;
}

Json discrepancy_json(const Discrepancy& d) {
  Json json;
  json["law"] = d.law;
  json["quantity"] = info(d.quantity).name;
  json.update(place_json(d.place));
  json["what"] = d.what;
  json["wrong"] = d.wrong == properties::Wrong::kNot ? Json(nullptr) : Json(name(d.wrong));
  json["symbol"] = d.symbol;
  json["got"] = hexfloats(d.got);
  json["exact"] = hexfloats(d.exact);
  json["error"] = error_json(d.error);
  json["unit"] = unit_name(d.quantity, d.precision);
  json["condition"] = error_json(d.condition);
  json["standing"] = name(d.excuse.standing());
  json["excuse"] = excuse_json(d);
  json["excluded_by"] = d.excluded_by ? Json(interval_text(*d.excluded_by)) : Json(nullptr);
  json["failed"] = nullptr;
  if (d.wrong == properties::Wrong::kFailed) {
    json["failed"] = {
        {"blame", name(d.failed.blame)},
        {"questions", d.failed.count},
        {"scene", or_null(d.failed.scene,
                          [](const scene::Scene& scene) { return scene::write_toml(scene); })},
        {"at", or_null(d.failed.line, [](const properties::CodeLine& at) {
           return Json{{"file", at.file}, {"line", at.line}, {"text", at.text}};
         })}};
  }
  return json;
}

Json tally_json(properties::Quantity quantity, const Tally& tally, scene::Precision precision) {
  const bool measured = !tally.errors.empty();
  const bool weighed = measured && tally.is_weighed();
  const bool has_worst = tally.worst > 0 && has_place(quantity);
  Json json;
  json["name"] = info(quantity).name;
  json["unit"] = unit_name(quantity, precision);
  json["cases"] = tally.cases;
  json["right"] = tally.right;
  json["wrong"] = tally.wrong_answers();
  for (std::size_t k = 1; k < properties::kWrongCount; ++k) {
    const auto kind = static_cast<properties::Wrong>(k);
    json["wrong_by_kind"][std::string(name(kind))] = tally.count(kind);
  }
  for (std::size_t k = 0; k < properties::kStandingCount; ++k) {
    const auto standing = static_cast<properties::Standing>(k);
    json["wrong_by_standing"][std::string(name(standing))] = tally.count(standing);
  }
  json["answered"] = Json::object();
  for (std::size_t k = 0; k < properties::kExpectedCount; ++k) {
    const properties::Answered& answers = tally.answered[k];
    if (answers.asked == 0) continue;
    json["answered"][std::string(properties::kExpectedNames[k])] = {{"asked", answers.asked},
                                                                    {"right", answers.right}};
  }
  json["measured"] = tally.errors.count();
  json["median"] = error_json(tally.median());
  json["p999"] = error_json(tally.quantile(0.999));
  json["max"] = error_json(tally.max());
  json["bound"] = error_json(tally.bound());
  json["ill_conditioned"] = tally.ill_conditioned;
  json["worst_at"] = has_worst ? place_json(tally.worst_place) : Json(nullptr);
  json["median_condition"] = error_json(tally.condition_quantile(0.5));
  json["max_over_growth"] = error_json(tally.max_over_growth);
  json["max_ratio"] = error_json(tally.worst_ratio);
  json["outcomes"] = nullptr;
  if (measured && !weighed) return json;
  for (std::size_t k = 0; k < properties::kOutcomeCount; ++k) {
    json["outcomes"][std::string(properties::kOutcomeNames[k])] = tally.outcomes[k];
  }
  return json;
}

Json tallies_json(const properties::Verdict& verdict, scene::Precision precision) {
  return list_json(verdict.tallies(),
                   [&](const auto& of) { return tally_json(of.first, of.second, precision); });
}

Json standings_json(const properties::Verdict& verdict) {
  Json json;
  for (std::size_t k = 0; k < properties::kStandingCount; ++k) {
    const auto standing = static_cast<properties::Standing>(k);
    json[std::string(name(standing))] = verdict.count(standing);
  }
  return json;
}

Json decided_by_json(const reference::DecidedBy& decided_by) {
  return {{"filter", decided_by.filter},
          {"intervals", decided_by.stages[0]},
          {"double_doubles", decided_by.stages[1]},
          {"balls", decided_by.stages[2]},
          {"field", decided_by.stages[3]}};
}

}  // namespace raycheck::tools
