
#include "tools/grade/probe.h"
#include "tools/grade/results/record.h"
#include "tools/grade/results/result.h"
#include "tools/report/json.h"

namespace raycheck::tools {
namespace {

Json dry_run_json(const DryRun& dry) {
  const Colour& background = dry.colours.background;
  return {{"driver", driver_json(dry.driver)},
          {"dialect", dry.driver.name()},
          {"seconds", dry.seconds},
          {"needed_seconds", or_null(dry.needed_seconds)},
          {"writes", text_or_null(dry.picture_name)},
          {"shows_a_sphere", dry.shows_a_sphere()},
          {"background", {background.red, background.green, background.blue}},
          {"channels", dry.colours.channels},
          {"tells_spheres", dry.colours.tells_spheres},
          {"said", plain_text(dry.said)}};
}

Json submission_json(const SubmissionProbe& probe) {
  Json notes = list_json(probe.found.notes, plain_text);
  const auto& dry = probe.found.dry_run;
  if (dry) {
    for (const std::string& note : dry->notes) notes.push_back(plain_text(note));
    if (!dry->shows_nothing.empty()) notes.push_back(plain_text(dry->shows_nothing));
  }
  const auto refusal_json = [](const Refusal& refusal) {
    return Json{{"why", plain_text(refusal.why)}, {"said", plain_text(refusal.said)}};
  };
  return {{"name", probe.name},
          {"program", or_null(probe.found.program, std::mem_fn(&CandidateSpec::text))},
          {"build", text_or_null(probe.found.build_words)},
          {"build_seconds", or_null(probe.found.build_seconds)},
          {"functions", probe.functions},
          {"dry_run", or_null(dry, dry_run_json)},
          {"notes", std::move(notes)},
          {"refused", or_null(probe.refusal, refusal_json)}};
}

}  // namespace

std::string probe_json(const ProbeReport& report, const ViewOptions& /*options*/) {
  Json json = json_header("grade");
  json["rubric"] = report.rubric.title;
  json["interrupted"] = report.interrupted;
  json["submissions"] = list_json(report.submissions, submission_json);
  json["suggestion"] = suggestion(report);
  return json_text(json);
}

}  // namespace raycheck::tools
