#include <functional>

#include "scene/files/scene_file.h"
#include "scene/number.h"
#include "tools/grade/pages/views.h"

namespace raycheck::tools {
namespace {

template <class Triple>
Json triple_json(const Triple& v) {
  return hexfloats({v.x, v.y, v.z});
}

/// A picture as runs of equal pixels. "12x- 3x0 4x?" is twelve background pixels, three of sphere 0
/// and four of an unidentified sphere; ~ is a pixel that is unclear.
std::string runs_of(const properties::ImageAnswer& image) {
  std::string text;
  for (std::size_t k = 0, count = 1; k < image.size(); k += count, count = 1) {
    while (k + count < image.size() && image[k + count] == image[k]) ++count;
    text += (text.empty() ? "" : " ") + std::to_string(count) + "x";
    if (!image[k]) {
      text += "-";
    } else {
      text += *image[k] == properties::kSomeSphere ? "?"
              : *image[k] == properties::kUnclear  ? "~"
                                                   : std::to_string(*image[k]);
    }
  }
  return text;
}

Json origin_json(const CaseOrigin& origin) {
  if (!origin.scene.empty()) return {{"scene", origin.scene}};
  return {{"source", origin.source}, {"case", origin.number}};
}

Json answer_json(const properties::Discrepancy& answer) {
  Json json = {{"quantity", info(answer.quantity).name}};
  json.update(place_json(answer.place));
  json["part"] = plain_text(answer.what);
  json["wrong"] = name(answer.wrong);
  json["symbol"] = answer.symbol;
  json["got"] = hexfloats(answer.got);
  json["exact"] = hexfloats(answer.exact);
  const bool is_measured = answer.wrong == properties::Wrong::kNot;
  json["error"] = is_measured ? error_json(answer.error) : Json(nullptr);
  json["unit"] = unit_name(answer.quantity, answer.precision);
  json["condition"] = error_json(answer.condition);
  return json;
}

Json pictures_json(const ComparedPictures& pictures) {
  return {{"got", runs_of(pictures.got)}, {"exact", or_null(pictures.exact, runs_of)}};
}

Json frame_json(const properties::FrameAnswer& frame) {
  return {{"U", triple_json(frame.U)}, {"V", triple_json(frame.V)}, {"W", triple_json(frame.W)}};
}

Json ray_json(const scene::Ray& ray) {
  return {{"origin", triple_json(ray.origin)}, {"direction", triple_json(ray.direction)}};
}

Json hits_json(const std::map<std::size_t, properties::HitAnswer>& hits) {
  return list_json(hits, [](const auto& hit) -> Json {
    return {{"sphere", hit.first},
            {"s", scene::hexfloat(hit.second.parameter)},
            {"Q", triple_json(hit.second.point)}};
  });
}

Json answers_json(const RayAnswers& answers) {
  return {{"frame", or_null(answers.frame, frame_json)},
          {"pixel_point", or_null(answers.pixel_point, triple_json<scene::Point3>)},
          {"ray", or_null(answers.ray, ray_json)},
          {"hits", or_null(answers.hits, hits_json)}};
}

Json failing_json(const FailingCase& failing) {
  return {{"law", failing.answer.law},
          {"origin", origin_json(failing.origin)},
          {"step", or_null(failing.step)},
          {"answer", answer_json(failing.answer)},
          {"scene", scene::write_toml(failing.the_case.scene)},
          {"pixels", list_json(failing.the_case.pixels, pixel_json)},
          {"pictures", or_null(failing.pictures, pictures_json)},
          {"answers", or_null(failing.answers, answers_json)}};
}

Json first_wrong_json(const FirstWrongAnswer& first) {
  return {{"origin", origin_json(first.origin)}, {"answer", answer_json(first.answer)}};
}

Json reason_json(const ItemReason& reason) {
  using Kind = ItemReason::Kind;
  if (reason.kind == Kind::kNone) return nullptr;
  Json json = {{"kind", kReasons[static_cast<std::size_t>(reason.kind)].name}};
  const auto is = [&](Kind kind) { return reason.kind == kind; };
  if (is(Kind::kNeeds) || is(Kind::kFollows)) json["item"] = reason.item;
  if (is(Kind::kNeeds)) json["state"] = name(reason.state);
  if (is(Kind::kTimeUp)) json["seconds"] = reason.seconds;
  if (is(Kind::kUnanswered)) json["law"] = reason.law;
  if (is(Kind::kUnanswered)) json["said"] = reason.said;
  if (is(Kind::kNeverRight)) json["quantity"] = reason.quantity;
  return json;
}

Json mistake_json(const ExplainingMistake& mistake) {
  return {{"sentence", mistake.sentence()},
          {"wrong", mistake.wrong},
          {"explained", mistake.explained},
          {"each", mistake.sentences}};
}

Json item_json(const ItemGrade& item) {
  return {{"name", item.name},
          {"state", name(item.state)},
          {"reason", reason_json(item.reason)},
          {"points", item.points},
          {"score", item.score},
          {"bonus", item.bonus},
          {"pictures", item.pictures},
          {"cases", item.cases},
          {"held", item.held},
          {"unsaid", item.unsaid},
          {"comparisons", item.comparisons},
          {"mistakes", list_json(item.mistakes, mistake_json)},
          {"failing", or_null(item.failing, failing_json)},
          {"first_wrong", or_null(item.first_wrong, first_wrong_json)}};
}

Json file_json(const OpaqueFile& file) {
  return {{"name", file.name}, {"kind", file.kind}, {"bytes", file.bytes}};
}

}  // namespace

Json refusal_json(const Refusal& refusal) {
  return {{"why", plain_text(refusal.why)}, {"said", plain_text(refusal.said)}};
}

Json driver_json(const DriverForm& form) {
  return {{"dialect", form.format->name},
          {"sphere_numbers", form.sphere_numbers},
          {"extra_lines", form.extra_lines},
          {"light", kDriverLightNames[static_cast<std::size_t>(form.light)]},
          {"numbers", kDriverNumberNames[static_cast<std::size_t>(form.numbers)]},
          {"order", form.order}};
}

Json record_json(const SubmissionGrade& grade) {
  return {{"name", grade.name},
          {"program", or_null(grade.found.program, std::mem_fn(&CandidateSpec::text))},
          {"build", grade.found.build_words},
          {"driver", driver_json(grade.found.driver())},
          {"notes", grade.notes},
          {"opaque_files", list_json(grade.found.opaque_files, file_json)},
          {"isolated_by", grade.isolation.text()},
          {"refused", or_null(grade.refused, refusal_json)},
          {"build_seconds", grade.build_seconds},
          {"build_is_stored", grade.build_is_stored},
          {"judge_seconds", grade.judge_seconds},
          {"seed", grade.seed},
          {"finished", grade.finished},
          {"points", grade.points},
          {"score", grade.score},
          {"bonus", grade.bonus},
          {"items", list_json(grade.items, item_json)}};
}

}  // namespace raycheck::tools
