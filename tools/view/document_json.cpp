#include "scene/files/scene_file.h"
#include "tools/report/words.h"
#include "tools/view/document.h"
#include "tools/view/figure/figure.h"

namespace raycheck::tools {
namespace {

Json scene_json(const SceneView& view) {
  const auto run_json = [](const SeenRun& run) { return Json{run.pixels, run.sphere}; };
  return {{"name", view.name},
          {"command", view.command},
          {"toml", scene::write_toml(view.scene)},
          {"conventions", conventions_json(view.scene.conventions)},
          {"conventions_text", conventions_text(view.scene.conventions)},
          {"figure", view.figure},
          {"pictures", view.pictures},
          {"seen", view.seen.empty() ? Json(nullptr) : list_json(view.seen, run_json)},
          {"start", selection_json(view.start)},
          {"panels", list_json(view.panels, [](const Panel& panel) { return panel.json; })}};
}

Json finding_json(const FindingView& finding) {
  Json json = {{"sentence", finding.sentence},
               {"candidate", finding.candidate},
               {"method", finding.method},
               {"standing", finding.standing ? name(*finding.standing) : "within its bound"},
               {"looks_like", finding.looks_like},
               {"scene", finding.scene}};
  json.update(selection_json(finding.selection));
  return json;
}

/// Pairs [word, meaning] for the words that pages use.
std::vector<std::array<std::string, 2>> words_of_pages() {
  return {
      {"ulp",
       "the gap between the doubles (of a candidate in floats: the floats) around the exact "
       "value"},
      {"u", "half of that gap at 1: the relative error of one rounding"},
      {"goes wrong at", "the first step whose error is larger than a single step can explain"},
      {"class", "whether a ray hits a sphere, touches it or misses it"},
      {"false hit, missed", "a hit instead of a miss, a miss instead of a hit"},
      {"parameter", "s: the distance of the hit along the ray, in multiples of D"},
      {"sphere residual", "how far the answered point Q is from the sphere"},
      {"direct/quadratic", "rays made by the method direct, intersected by the method quadratic"},
      {"within its bound", "the method's largest error here is within its documented bound"},
      {"defect", "wrong, and rounding of the inputs does not excuse it: counts against the method"},
      {"excused",
       "wrong for these inputs, but right for inputs that differ by at most 16 u: as accurate as "
       "the inputs"},
      {"undecided", "wrong, but it could not be decided whether it is excused or a defect"},
      {"not judged", "outside the domain in which the method's bounds apply"},
      {"condition number",
       "the ratio of a relative change of the result to the relative change of "
       "the inputs"}};
}

Json dial_json(const DialView& dial) {
  return {{"sentence", dial.sentence}, {"scenes", dial.scenes}};
}

Json whole(const ViewDocument& document) {
  Json json = json_header("view");
  json.update({{"title", document.title},
               {"parts", document.scenes.empty() ? Json(nullptr) : parts_json()},
               {"scenes", list_json(document.scenes, scene_json)},
               {"findings", list_json(document.findings, finding_json)},
               {"found", document.found},
               {"worst", document.worst},
               {"words", words_of_pages()},
               {"dial", or_null(document.dial, dial_json)},
               {"chart", or_null(document.chart, chart_json)},
               {"left_out", document.left_out}});
  return json;
}

}  // namespace

Json selection_json(const Selection& selection) {
  return {{"pixel", or_null(selection.pixel, pixel_json)},
          {"ray", or_null(selection.ray)},
          {"sphere", or_null(selection.sphere)}};
}

std::string document_json(const ViewDocument& document) { return json_text(whole(document)); }
std::string document_line(const ViewDocument& document) { return json_line(whole(document)); }

}  // namespace raycheck::tools
