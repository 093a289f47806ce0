#include <fmt/core.h>
#include <fmt/ranges.h>

#include <functional>
#include <sstream>

#include "tools/grade/pages/wording.h"
#include "tools/grade/probe.h"
#include "tools/grade/results/record.h"
#include "tools/report/table.h"
#include "tools/report/words.h"

namespace raycheck::tools {
namespace {

constexpr std::string_view kNone = "-";

std::string shown_text(const DryRun& dry) {
  if (!dry.shows_a_sphere()) return "not the scene";
  std::string text = "spheres";
  if (!dry.colours.tells_spheres) {
    text += ", not which";
  } else if (dry.colours.channels != ColourHabit{}.channels) {
    text += ", channels exchanged";
  }
  const auto& [red, green, blue] = dry.colours.background;
  if (!(dry.colours.background == Colour{})) {
    text += fmt::format(", on ({}, {}, {})", red, green, blue);
  }
  return text;
}

std::vector<std::string> row(const SubmissionProbe& probe) {
  const auto& build = probe.found.build_seconds;
  std::vector<std::string> cells = {line_text(probe.name),
                                    build ? fmt::format("{:6.1f} s", *build) : std::string(kNone)};
  const auto& dry = probe.found.dry_run;
  const bool draws = dry && !probe.refusal;
  if (dry && dry->needed_seconds) {
    cells.push_back(fmt::format("{:6.2f} s", *dry->needed_seconds));
  } else {
    cells.push_back(draws ? fmt::format("{:6.2f} s", dry->seconds) : std::string(kNone));
  }
  cells.push_back(draws && dry->shows_a_sphere() ? dry->driver.name() : std::string(kNone));
  cells.push_back(!draws                      ? std::string(kNone)
                  : dry->picture_name.empty() ? "as told"
                                              : line_text(dry->picture_name));
  cells.push_back(draws ? shown_text(*dry) : std::string(kNone));
  return cells;
}

/// The remarks on a submission, one per line.
std::string notes_text(const SubmissionProbe& probe) {
  std::string text;
  const auto add = [&](const std::string& said) {
    if (!said.empty()) text += plain_text(said) + "\n";
  };
  for (const std::string& note : probe.found.notes) add(note);
  if (!probe.functions.empty()) add(fmt::format("offers {}", fmt::join(probe.functions, ", ")));
  if (const auto& dry = probe.found.dry_run) {
    for (const std::string& note : dry->notes) add(note);
    add(dry->shows_nothing);
    if (!dry->said.empty()) add("it said:\n" + indented(dry->said, "  "));
  }
  if (probe.refusal) {
    add("could not be judged: " + probe.refusal->why);
    if (!probe.refusal->said.empty()) add(indented(probe.refusal->said, "  "));
  }
  while (text.ends_with("\n\n")) text.pop_back();
  return text;
}

std::string table_text(const ProbeReport& report) {
  using Align = Table::Align;
  Table table({{"submission", Align::kLeft},
               {"built in", Align::kRight},
               {"draws in", Align::kRight},
               {"reads", Align::kLeft},
               {"writes", Align::kLeft},
               {"shows", Align::kLeft}});
  for (const SubmissionProbe& probe : report.submissions) table.add(row(probe));
  std::istringstream lines(table.text(""));
  std::string line, text;
  std::getline(lines, line);
  text += line + "\n";
  for (const SubmissionProbe& probe : report.submissions) {
    std::getline(lines, line);
    text += line + "\n" + indented(notes_text(probe), "    ");
  }
  return text;
}

}  // namespace

std::string probe_text(const ProbeReport& report, const ViewOptions& /*options*/) {
  std::string text = report.rubric.title + "\n" + table_text(report);
  std::size_t refused = 0;
  for (const SubmissionProbe& probe : report.submissions) refused += probe.refusal ? 1 : 0;
  text += count_text(report.submissions.size(), "submission") + " tried";
  text += refused > 0 ? fmt::format(", {} could not be judged\n", refused) : "\n";
  if (report.interrupted) text += "INTERRUPTED: these are the submissions that were reached.\n";
  const std::string suggested = suggestion(report);
  if (suggested.empty()) return text;
  return text +
         "\n# What does the same, in place of the rubric's [driver] and of its form with build = "
         "\"auto\":\n" +
         suggested;
}

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
