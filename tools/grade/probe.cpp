#include "tools/grade/probe.h"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <functional>
#include <sstream>
#include <string_view>
#include <utility>

#include "tools/grade/pages/views.h"
#include "tools/grade/results/record.h"
#include "tools/report/table.h"
#include "tools/report/words.h"

namespace raycheck::tools {
namespace {

SubmissionProbe probed(const Submission& submission, const Rubric& rubric, const Layers& layers,
                       const properties::RunControl& control, bool alone) {
  const auto surroundings = std::make_shared<Surroundings>(alone);
  SubmissionProbe probe;
  probe.name = submission.name;
  try {
    const RunnableSubmission runnable =
        prepare(submission, rubric, {layers, surroundings}, until_blamed(control, *surroundings));
    probe.found = runnable.found;
    probe.functions = runnable.external.introduction.functions;
  } catch (const SubmissionError& error) {
    probe.found = error.found();
    probe.refusal = error.refusal();
  }
  probe.outside = surroundings->cause();
  if (!probe.outside.empty()) probe.refusal = outside_refusal(probe.outside);
  return probe;
}

}  // namespace

bool ProbeReport::holds() const {
  return std::ranges::none_of(submissions,
                              [](const SubmissionProbe& one) { return one.refusal.has_value(); });
}

ProbeReport probe(const GradeOptions& options, const properties::RunControl& control) {
  ProbeReport report;
  report.rubric = load_rubric(options.rubric, options.dialect);
  const Layers layers = chosen_layers(options.sandbox).layers;
  test_environment(report.rubric, layers);
  const std::vector<Submission> submissions = find_submissions(options.submissions, {});
  report.submissions =
      done_for_each<SubmissionProbe>(submissions, control, [&](const Submission& each, bool alone) {
        return probed(each, report.rubric, layers, control, alone);
      });
  report.interrupted = control.interrupted();
  return report;
}

namespace {

using Probes = std::vector<const SubmissionProbe*>;

/// Files that determine the build although the build command does not name them.
constexpr std::array<std::string_view, 2> kRecipes = {"CMakeLists.txt", "package.json"};

constexpr std::size_t kMostNamed = 4;

/// A TOML basic string.
std::string toml_text(std::string_view text) {
  std::string result = "\"";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      result += std::string("\\") + c;
    } else if (byte < ' ' || byte == 0x7f) {
      result += fmt::format("\\u{:04X}", byte);
    } else {
      result += c;
    }
  }
  return result + "\"";
}

/// The form that most submissions read; if two are equally frequent, the first.
std::string driver_part(const ProbeReport& report) {
  std::vector<std::pair<DriverForm, int>> counts;
  for (const SubmissionProbe& probe : report.submissions) {
    const auto& dry = probe.found.dry_run;
    if (!dry || !dry->shows_a_sphere()) continue;
    const auto known =
        std::ranges::find_if(counts, [&](const auto& count) { return count.first == dry->driver; });
    if (known == counts.end()) {
      counts.emplace_back(dry->driver, 1);
    } else {
      ++known->second;
    }
  }
  if (counts.empty()) return "";
  const auto most = std::ranges::max_element(
      counts, [](const auto& a, const auto& b) { return a.second < b.second; });
  return fmt::format("[driver]\npreset = {}\n{}", toml_text(most->first.name()),
                     counts.size() > 1 ? "others = true\n" : "");
}

/// Submissions with the same build and start commands.
struct BuiltAlike {
  std::string build, candidate;
  Probes members;
};

std::vector<BuiltAlike> built_alike(const ProbeReport& report) {
  std::vector<BuiltAlike> found;
  for (const SubmissionProbe& probe : report.submissions) {
    if (probe.refusal || !probe.found.built_automatically) continue;
    const std::string candidate = probe.found.program->text();
    auto known = std::ranges::find_if(found, [&](const BuiltAlike& one) {
      return one.build == probe.found.build_words && one.candidate == candidate;
    });
    if (known == found.end()) {
      known = found.insert(found.end(), {probe.found.build_words, candidate, {}});
    }
    known->members.push_back(&probe);
  }
  std::ranges::stable_sort(found, [](const BuiltAlike& a, const BuiltAlike& b) {
    return a.members.size() > b.members.size();
  });
  return found;
}

bool has_file(const SubmissionProbe& probe, const std::string& name) {
  return std::ranges::find(probe.found.files, name) != probe.found.files.end();
}

/// A file name that only these submissions have, so that a form can select them; empty if there is
/// none.
std::string distinguishing_file(const BuiltAlike& alike, const ProbeReport& report) {
  for (const std::string& name : alike.members.front()->found.files) {
    const bool is_what_it_is_of = alike.build.find(name) != std::string::npos ||
                                  alike.candidate.find(name) != std::string::npos ||
                                  std::ranges::find(kRecipes, name) != kRecipes.end();
    if (!is_what_it_is_of || name.find_first_of("*?[\\") != std::string::npos) continue;
    const auto having = std::ranges::count_if(
        report.submissions, [&](const SubmissionProbe& probe) { return has_file(probe, name); });
    const bool all_have = std::ranges::all_of(
        alike.members, [&](const auto* probe) { return has_file(*probe, name); });
    if (all_have && static_cast<std::size_t>(having) == alike.members.size()) return name;
  }
  return "";
}

std::string form_table(const std::string& has, const std::string& build,
                       const std::string& candidate) {
  std::string text = fmt::format("\n[[form]]\nhas = {}\n", toml_text(has));
  if (!build.empty()) text += fmt::format("build = {}\n", toml_text(build));
  return text + fmt::format("candidate = {}\n", toml_text(candidate));
}

std::string names_of(const Probes& members) {
  std::string names;
  for (std::size_t k = 0; k < std::min(members.size(), kMostNamed); ++k) {
    names += (k == 0 ? "" : ", ") + line_text(members[k]->name);
  }
  if (members.size() > kMostNamed)
    names += fmt::format(" and {} more", members.size() - kMostNamed);
  return names;
}

}  // namespace

std::string suggestion(const ProbeReport& report) {
  std::string text = driver_part(report);
  bool any_automatic = false;
  for (const BuiltAlike& alike : built_alike(report)) {
    any_automatic = true;
    const std::string has = distinguishing_file(alike, report);
    if (has.empty()) continue;
    text += "\n# " + names_of(alike.members) + form_table(has, alike.build, alike.candidate);
  }
  for (const Form& form : report.rubric.forms) {
    if (any_automatic && form.is_built_automatically()) {
      text += form_table(form.has, form.build, form.program.text());
    }
  }
  return text;
}

namespace {

constexpr std::string_view kNone = "-";

std::string shown_text(const DryRun& dry) {
  if (!dry.shows_a_sphere()) return "not the scene";
  std::string text = "spheres";
  if (!dry.colours.tells_spheres) {
    text += ", not told apart";
  } else if (dry.colours.channels != ColourHabit{}.channels) {
    text += ", channels exchanged";
  }
  const auto& [red, green, blue] = dry.colours.background;
  if (!(dry.colours.background == Colour{})) {
    text += fmt::format(", background ({}, {}, {})", red, green, blue);
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
                  : dry->picture_name.empty() ? "as asked"
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
  for (const std::string& note : probe.found.all_notes()) add(note);
  if (!probe.functions.empty()) add(fmt::format("implements {}", fmt::join(probe.functions, ", ")));
  if (const auto& dry = probe.found.dry_run) {
    add(dry->shows_nothing);
    if (!dry->said.empty()) add("its output:\n" + indented(dry->said, "  "));
  }
  if (probe.refusal) {
    add("could not be judged: " + probe.refusal->why);
    if (!probe.refusal->said.empty()) add(indented(probe.refusal->said, "  "));
  }
  while (text.ends_with("\n\n")) text.pop_back();
  return text;
}

std::string table_text(const ProbeReport& report) {
  Table table({"submission", ">built in", ">draws in", "reads", "writes", "shows"});
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
  if (report.interrupted) text += "INTERRUPTED: these are the results so far.\n";
  const std::string suggested = suggestion(report);
  if (suggested.empty()) return text;
  return text +
         "\n# To write this into the rubric, replace its [driver] and its form with build = "
         "\"auto\" by:\n" +
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
  Json notes = probe.found.all_notes();
  const auto& dry = probe.found.dry_run;
  if (dry && !dry->shows_nothing.empty()) notes.push_back(plain_text(dry->shows_nothing));
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
