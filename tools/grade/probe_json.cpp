#include <nlohmann/json.hpp>

#include "tools/grade/probe.h"
#include "tools/grade/results/plain_text.h"
#include "tools/grade/results/record.h"
#include "tools/report/json.h"

namespace raycheck::tools {
namespace {

template <class Value>
Json or_null(const std::optional<Value>& value) {
  return value ? Json(*value) : Json(nullptr);
}

Json dry_run_json(const DryRun& dry) {
  const Colour& background = dry.colours.background;
  return {{"driver", driver_json(dry.driver)},
          {"dialect", dry.driver.name()},
          {"seconds", dry.seconds},
          {"needed_seconds", or_null(dry.needed_seconds)},
          {"writes", dry.picture_name.empty() ? Json(nullptr) : Json(dry.picture_name)},
          {"shows_a_sphere", dry.shows_a_sphere()},
          {"background", {background.red, background.green, background.blue}},
          {"channels", dry.colours.channels},
          {"tells_spheres", dry.colours.tells_spheres},
          {"said", plain_text(dry.said)}};
}

Json submission_json(const SubmissionProbe& probe) {
  Json notes = Json::array();
  for (const std::string& note : probe.found.notes) notes.push_back(plain_text(note));
  const auto& dry = probe.found.dry_run;
  if (dry) {
    for (const std::string& note : dry->notes) notes.push_back(plain_text(note));
    if (!dry->shows_nothing.empty()) notes.push_back(plain_text(dry->shows_nothing));
  }
  Json refused = nullptr;
  if (probe.refusal) {
    refused = {{"why", plain_text(probe.refusal->why)}, {"said", plain_text(probe.refusal->said)}};
  }
  const auto& program = probe.found.program;
  return {
      {"name", probe.name},
      {"program", program ? Json(program->text()) : Json(nullptr)},
      {"build", probe.found.build_words.empty() ? Json(nullptr) : Json(probe.found.build_words)},
      {"build_seconds", or_null(probe.found.build_seconds)},
      {"functions", probe.functions},
      {"dry_run", dry ? dry_run_json(*dry) : Json(nullptr)},
      {"notes", std::move(notes)},
      {"refused", std::move(refused)}};
}

}  // namespace

std::string probe_json(const ProbeReport& report, const ViewOptions& /*options*/) {
  Json json = json_header("grade");
  json["rubric"] = report.rubric.title;
  json["interrupted"] = report.interrupted;
  json["submissions"] = Json::array();
  for (const SubmissionProbe& probe : report.submissions) {
    json["submissions"].push_back(submission_json(probe));
  }
  json["suggestion"] = suggestion(report);
  return json_text(json);
}

}  // namespace raycheck::tools
