#include "tools/grade/results/record.h"

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "properties/laws/law.h"
#include "scene/files/scene_file.h"
#include "scene/number.h"
#include "tools/grade/results/earlier.h"
#include "tools/grade/results/image_runs.h"
#include "tools/grade/results/record_answers.h"
#include "tools/grade/results/record_parts.h"
#include "tools/report/json.h"
#include "tools/report/words.h"

namespace raycheck::tools {
namespace {

using properties::Quantity;
using properties::Wrong;

template <class Enum, std::size_t kCount>
Enum named(const Json& json, const std::array<std::string_view, kCount>& names) {
  const auto text = json.get<std::string>();
  const auto* const found = std::find(names.begin(), names.end(), text);
  if (found == names.end()) throw std::invalid_argument(text + ": no such name");
  return static_cast<Enum>(found - names.begin());
}

Quantity quantity_named(const std::string& text) {
  for (std::size_t k = 0; k < properties::kQuantityCount; ++k) {
    if (properties::kQuantities[k].name == text) return static_cast<Quantity>(k);
  }
  throw std::invalid_argument(text + ": no such quantity");
}

double error_of(const Json& json) {
  return json.is_string() ? std::numeric_limits<double>::infinity() : json.get<double>();
}

Json origin_json(const CaseOrigin& origin) {
  if (!origin.scene.empty()) return {{"scene", origin.scene}};
  return {{"source", origin.source}, {"case", origin.number}};
}

CaseOrigin origin_of(const Json& json) {
  if (json.contains("scene")) return {json.at("scene"), "", 0};
  return {"", json.at("source"), json.at("case")};
}

Json pixel_json(const scene::Pixel& pixel) { return {pixel.i, pixel.j}; }
scene::Pixel pixel_of(const Json& json) { return {json.at(0), json.at(1)}; }

Json answer_json(const WrongAnswer& answer) {
  return {{"quantity", info(answer.quantity).name},
          {"pixel", or_null(answer.place.pixel, pixel_json)},
          {"ray", answer.place.ray},
          {"sphere", or_null(answer.place.sphere, [](std::size_t sphere) { return sphere; })},
          {"part", answer.part},
          {"wrong", name(answer.wrong)},
          {"symbol", answer.symbol},
          {"got", hexfloats(answer.got)},
          {"exact", or_null(answer.exact, hexfloats)},
          {"error", error_json(answer.error)},
          {"unit", unit_name(answer.quantity, answer.precision)},
          {"condition", error_json(answer.condition)}};
}

WrongAnswer answer_of(const Json& json) {
  WrongAnswer answer;
  answer.quantity = quantity_named(json.at("quantity"));
  answer.place.pixel = if_any(json.at("pixel"), pixel_of);
  answer.place.ray = json.at("ray");
  answer.place.sphere =
      if_any(json.at("sphere"), [](const Json& sphere) { return sphere.get<std::size_t>(); });
  answer.part = json.at("part");
  answer.wrong = named<Wrong>(json.at("wrong"), properties::kWrongNames);
  answer.symbol = json.at("symbol");
  answer.got = numbers(json.at("got"));
  answer.exact = if_any(json.at("exact"), numbers);
  answer.error = if_any(json.at("error"), error_of);
  answer.condition = if_any(json.at("condition"), error_of);
  if (json.at("unit") != info(answer.quantity).unit) answer.precision = scene::Precision::kSingle;
  return answer;
}

Json pictures_json(const ComparedPictures& pictures) {
  return {{"got", runs_of(pictures.got)}, {"exact", or_null(pictures.exact, runs_of)}};
}

ComparedPictures pictures_of(const Json& json, const scene::Scene& scene) {
  if (!scene.camera) throw std::invalid_argument("a picture without a camera");
  const auto pixels = static_cast<std::size_t>(scene.camera->width * scene.camera->height);
  const auto image = [&](const Json& runs) { return image_of(runs.get<std::string>(), pixels); };
  return {image(json.at("got")), if_any(json.at("exact"), image)};
}

Json failing_json(const FailingCase& failing) {
  Json pixels = Json::array();
  for (const scene::Pixel& pixel : failing.the_case.pixels) pixels.push_back(pixel_json(pixel));
  return {{"law", failing.law},
          {"origin", origin_json(failing.origin)},
          {"step", or_null(failing.step, [](const std::string& step) { return step; })},
          {"answer", answer_json(failing.answer)},
          {"scene", scene::write_toml(failing.the_case.scene)},
          {"pixels", std::move(pixels)},
          {"pictures", or_null(failing.pictures, pictures_json)},
          {"answers", or_null(failing.answers, answers_json)}};
}

FailingCase failing_of(const Json& json) {
  FailingCase failing;
  failing.law = json.at("law");
  if (properties::find_law(failing.law) == nullptr) throw std::invalid_argument("no such law");
  failing.origin = origin_of(json.at("origin"));
  failing.step = if_any(json.at("step"), [](const Json& step) { return step.get<std::string>(); });
  failing.answer = answer_of(json.at("answer"));
  failing.the_case.scene = scene::read_toml(json.at("scene").get<std::string>(), "scene").scene;
  for (const Json& pixel : json.at("pixels")) failing.the_case.pixels.push_back(pixel_of(pixel));
  failing.pictures = if_any(json.at("pictures"), [&](const Json& pictures) {
    return pictures_of(pictures, failing.the_case.scene);
  });
  failing.answers = if_any(json.at("answers"), answers_of);
  return failing;
}

Json first_wrong_json(const FirstWrongAnswer& first) {
  return {{"origin", origin_json(first.origin)}, {"answer", answer_json(first.answer)}};
}

FirstWrongAnswer first_wrong_of(const Json& json) {
  return {origin_of(json.at("origin")), answer_of(json.at("answer"))};
}

Json reason_json(const ItemReason& reason) {
  using Kind = ItemReason::Kind;
  if (reason.kind == Kind::kNone) return nullptr;
  Json json = {{"kind", kReasonNames[static_cast<std::size_t>(reason.kind)]}};
  if (reason.kind == Kind::kNeeds) {
    json["item"] = reason.item;
    json["state"] = name(reason.state);
  } else if (reason.kind == Kind::kFollows) {
    json["item"] = reason.item;
  } else if (reason.kind == Kind::kTimeUp) {
    json["seconds"] = reason.seconds;
  } else if (reason.kind == Kind::kUnanswered) {
    json["law"] = reason.law;
    json["said"] = reason.said;
  } else if (reason.kind == Kind::kNeverRight) {
    json["quantity"] = reason.quantity;
  }
  return json;
}

ItemReason reason_of(const Json& json) {
  using Kind = ItemReason::Kind;
  ItemReason reason;
  if (json.is_null()) return reason;
  reason.kind = named<Kind>(json.at("kind"), kReasonNames);
  if (reason.kind == Kind::kFollows) {
    reason.item = json.at("item");
  } else if (reason.kind == Kind::kNeeds) {
    reason.item = json.at("item");
    reason.state = named<ItemState>(json.at("state"), kItemStateNames);
  } else if (reason.kind == Kind::kTimeUp) {
    reason.seconds = json.at("seconds");
  } else if (reason.kind == Kind::kUnanswered) {
    reason.law = json.at("law");
    reason.said = json.at("said");
  } else if (reason.kind == Kind::kNeverRight) {
    reason.quantity = json.at("quantity");
  }
  return reason;
}

Json item_json(const ItemGrade& item) {
  Json mistakes = Json::array();
  for (const ExplainingMistake& one : item.mistakes) {
    mistakes.push_back({{"sentence", one.sentence},
                        {"wrong", one.wrong},
                        {"explained", one.explained},
                        {"each", one.each()}});
  }
  return {{"name", item.name},
          {"state", name(item.state)},
          {"reason", reason_json(item.reason)},
          {"points", item.points},
          {"score", item.score},
          {"bonus", item.bonus},
          {"pictures", item.pictures},
          {"cases", item.cases},
          {"held", item.held},
          {"comparisons", item.comparisons},
          {"mistakes", std::move(mistakes)},
          {"failing", or_null(item.failing, failing_json)},
          {"first_wrong", or_null(item.first_wrong, first_wrong_json)}};
}

ItemGrade item_of(const Json& json) {
  ItemGrade item;
  item.name = json.at("name");
  item.state = named<ItemState>(json.at("state"), kItemStateNames);
  item.reason = reason_of(json.at("reason"));
  item.points = json.at("points");
  item.score = json.at("score");
  item.bonus = json.at("bonus");
  item.pictures = json.at("pictures");
  item.cases = json.at("cases");
  item.held = json.at("held");
  item.comparisons = json.at("comparisons");
  for (const Json& one : json.at("mistakes")) {
    item.mistakes.push_back(
        {one.at("sentence"), one.at("wrong"), one.at("explained"), one.at("each")});
  }
  item.failing = if_any(json.at("failing"), failing_of);
  item.first_wrong = if_any(json.at("first_wrong"), first_wrong_of);
  return item;
}

DriverForm driver_of(const Json& json) {
  return {named<scene::Dialect>(json.at("dialect"), kDialectNames),
          json.at("sphere_numbers"),
          json.at("extra_lines"),
          named<DriverLight>(json.at("light"), kDriverLightNames),
          named<DriverNumbers>(json.at("numbers"), kDriverNumberNames),
          json.at("order")};
}

}  // namespace

Json driver_json(const DriverForm& form) {
  return {{"dialect", kDialectNames[static_cast<std::size_t>(form.dialect)]},
          {"sphere_numbers", form.sphere_numbers},
          {"extra_lines", form.extra_lines},
          {"light", kDriverLightNames[static_cast<std::size_t>(form.light)]},
          {"numbers", kDriverNumberNames[static_cast<std::size_t>(form.numbers)]},
          {"order", form.order}};
}

std::string record_text(const SubmissionGrade& grade) {
  Json json = {
      {"name", grade.name},
      {"program", or_null(grade.program, [](const CandidateSpec& spec) { return spec.text(); })},
      {"build", grade.build_words},
      {"driver", driver_json(grade.driver)},
      {"notes", grade.notes},
      {"opaque_files", Json::array()},
      {"isolated_by", grade.isolation.text()},
      {"refused", or_null(grade.refused,
                          [](const Refusal& refused) {
                            return Json{{"why", refused.why}, {"said", refused.said}};
                          })},
      {"build_seconds", grade.build_seconds},
      {"build_is_stored", grade.build_is_stored},
      {"judge_seconds", grade.judge_seconds},
      {"seed", grade.seed},
      {"key", grade.key},
      {"inputs", inputs_json(grade.inputs)},
      {"finished", grade.finished},
      {"points", grade.points},
      {"score", grade.score},
      {"bonus", grade.bonus},
      {"items", Json::array()}};
  for (const auto& [file, kind, bytes] : grade.opaque_files) {
    json["opaque_files"].push_back({{"name", file}, {"kind", kind}, {"bytes", bytes}});
  }
  for (const ItemGrade& item : grade.items) json["items"].push_back(item_json(item));
  return json_text(json);
}

SubmissionGrade read_record(std::string_view text) {
  const Json json = Json::parse(text);
  SubmissionGrade grade;
  grade.name = json.at("name");
  grade.key = json.at("key");
  grade.program = if_any(json.at("program"), [](const Json& program) {
    return parse_candidate(program.get<std::string>());
  });
  grade.build_words = json.at("build");
  grade.driver = driver_of(json.at("driver"));
  grade.notes = json.at("notes").get<std::vector<std::string>>();
  grade.refused = if_any(json.at("refused"), [](const Json& refused) {
    return Refusal{refused.at("why"), refused.at("said")};
  });
  for (const Json& file : json.at("opaque_files")) {
    grade.opaque_files.push_back({file.at("name"), file.at("kind"), file.at("bytes")});
  }
  grade.inputs = inputs_of(json.at("inputs"));
  grade.build_seconds = json.at("build_seconds");
  grade.build_is_stored = json.at("build_is_stored");
  grade.judge_seconds = json.at("judge_seconds");
  grade.seed = json.at("seed");
  grade.finished = json.at("finished");
  grade.points = json.at("points");
  grade.score = json.at("score");
  grade.bonus = json.at("bonus");
  for (const Json& item : json.at("items")) grade.items.push_back(item_of(item));
  return grade;
}

}  // namespace raycheck::tools
