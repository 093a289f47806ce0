// The findings of a dry run of a class: grade() with `probe`.

#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <functional>
#include <sstream>
#include <string_view>
#include <type_traits>
#include <utility>

#include "tools/grade/pages/views.h"
#include "tools/report/table.h"
#include "tools/report/words.h"

namespace raycheck::tools {
namespace {

/// Files that determine the build although the build command does not name them.
constexpr std::array<std::string_view, 2> kRecipes = {"CMakeLists.txt", "package.json"};

constexpr std::size_t kMostNamed = 4;

/// The submissions of each key, the most frequent key first; those without a key are left out.
template <class KeyOf>
auto grouped(const ClassGrade& report, const KeyOf& key_of) {
  using Key = typename std::invoke_result_t<KeyOf, const SubmissionGrade&>::value_type;
  std::vector<std::pair<Key, Submissions>> groups;
  for (const SubmissionGrade& probe : report.submissions) {
    const std::optional<Key> key = key_of(probe);
    if (!key) continue;
    auto known = std::ranges::find(groups, *key, &std::pair<Key, Submissions>::first);
    if (known == groups.end()) known = groups.insert(groups.end(), {*key, {}});
    known->second.push_back(&probe);
  }
  std::ranges::stable_sort(groups, std::greater{},
                           [](const auto& group) { return group.second.size(); });
  return groups;
}

/// The form that most submissions read; if two are equally frequent, the first.
std::string driver_part(const ClassGrade& report) {
  const auto forms = grouped(report, [](const SubmissionGrade& probe) -> std::optional<DriverForm> {
    const auto& dry = probe.found.dry_run;
    return dry && dry->shows_a_sphere() ? std::optional(dry->driver) : std::nullopt;
  });
  if (forms.empty()) return "";
  return fmt::format("[driver]\npreset = {}\n{}", toml_text(forms.front().first.name()),
                     forms.size() > 1 ? "others = true\n" : "");
}

/// The commands that build and start a submission.
using Commands = std::pair<std::string, std::string>;

/// Those of a submission that was built automatically.
std::optional<Commands> automatic_commands(const SubmissionGrade& probe) {
  if (probe.refused || !probe.found.built_automatically) return {};
  return Commands{probe.found.build_words, probe.found.program->text()};
}

bool has_file(const SubmissionGrade& probe, const std::string& name) {
  return std::ranges::find(probe.found.files, name) != probe.found.files.end();
}

/// A file name that only these submissions have, so that a form can select them; empty if there is
/// none.
std::string distinguishing_file(const Commands& commands, const Submissions& members,
                                const ClassGrade& report) {
  const auto& [build, candidate] = commands;
  for (const std::string& name : members.front()->found.files) {
    const bool is_what_it_is_of = build.find(name) != std::string::npos ||
                                  candidate.find(name) != std::string::npos ||
                                  std::ranges::find(kRecipes, name) != kRecipes.end();
    if (!is_what_it_is_of || name.find_first_of("*?[\\") != std::string::npos) continue;
    const auto having = std::ranges::count_if(
        report.submissions, [&](const SubmissionGrade& probe) { return has_file(probe, name); });
    const bool all_have =
        std::ranges::all_of(members, [&](const auto* probe) { return has_file(*probe, name); });
    if (all_have && static_cast<std::size_t>(having) == members.size()) return name;
  }
  return "";
}

std::string form_table(const std::string& has, const std::string& build,
                       const std::string& candidate) {
  std::string text = fmt::format("\n[[form]]\nhas = {}\n", toml_text(has));
  if (!build.empty()) text += fmt::format("build = {}\n", toml_text(build));
  return text + fmt::format("candidate = {}\n", toml_text(candidate));
}

/// The findings of the dry run as a part of a rubric, in TOML. First comes the table [driver] with
/// the form that most submissions read. Then, for each group of automatically built submissions
/// that one file name selects, comes a [[form]] with their build commands; last comes the form with
/// `build = "auto"` for all others. Empty if no submission runs.
std::string suggestion(const ClassGrade& report) {
  std::string text = driver_part(report);
  const auto name_of_one = [](const SubmissionGrade* one) { return line_text(one->name); };
  const auto built_alike = grouped(report, automatic_commands);
  for (const auto& [commands, members] : built_alike) {
    const std::string has = distinguishing_file(commands, members, report);
    if (has.empty()) continue;
    text += "\n# " + first_text(members, kMostNamed, name_of_one) +
            form_table(has, commands.first, commands.second);
  }
  for (const Form& form : report.rubric.forms) {
    if (!built_alike.empty() && form.is_built_automatically()) {
      text += form_table(form.has, form.build, form.program.text());
    }
  }
  return text;
}

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

std::vector<std::string> row(const SubmissionGrade& probe) {
  const auto& build = probe.found.build_seconds;
  std::vector<std::string> cells = {line_text(probe.name),
                                    build ? fmt::format("{:6.1f} s", *build) : std::string(kNone)};
  const auto& dry = probe.found.dry_run;
  const bool draws = dry && !probe.refused;
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
std::string remarks_text(const SubmissionGrade& probe) {
  std::string text;
  const auto add = [&](const std::string& said) {
    if (!said.empty()) text += plain_text(said) + "\n";
  };
  for (const std::string& note : probe.notes) add(note);
  if (!probe.found.functions.empty())
    add(fmt::format("implements {}", fmt::join(probe.found.functions, ", ")));
  if (const auto& dry = probe.found.dry_run) {
    add(dry->shows_nothing);
    if (!dry->said.empty()) add("its output:\n" + indented(dry->said, "  "));
  }
  if (probe.refused) {
    add("could not be judged: " + probe.refused->why);
    if (!probe.refused->said.empty()) add(indented(probe.refused->said, "  "));
  }
  while (text.ends_with("\n\n")) text.pop_back();
  return text;
}

std::string table_text(const ClassGrade& report) {
  Table table({"submission", ">built in", ">draws in", "reads", "writes", "shows"});
  for (const SubmissionGrade& probe : report.submissions) table.add(row(probe));
  std::istringstream lines(table.text(""));
  std::string line, text;
  std::getline(lines, line);
  text += line + "\n";
  for (const SubmissionGrade& probe : report.submissions) {
    std::getline(lines, line);
    text += line + "\n" + indented(remarks_text(probe), "    ");
  }
  return text;
}

}  // namespace

std::string probe_text(const ClassGrade& report) {
  std::string text = report.rubric.title + "\n" + table_text(report);
  const std::size_t refused = submissions_that(report, false).size();
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

Json submission_json(const SubmissionGrade& probe) {
  Json notes = probe.notes;
  const auto& dry = probe.found.dry_run;
  if (dry && !dry->shows_nothing.empty()) notes.push_back(plain_text(dry->shows_nothing));
  return {{"name", probe.name},
          {"program", or_null(probe.found.program, std::mem_fn(&CandidateSpec::text))},
          {"build", text_or_null(probe.found.build_words)},
          {"build_seconds", or_null(probe.found.build_seconds)},
          {"functions", probe.found.functions},
          {"dry_run", or_null(dry, dry_run_json)},
          {"notes", std::move(notes)},
          {"refused", or_null(probe.refused, refusal_json)}};
}

}  // namespace

std::string probe_json(const ClassGrade& report) {
  Json json = json_header("grade");
  json["rubric"] = report.rubric.title;
  json["interrupted"] = report.interrupted;
  json["submissions"] = list_json(report.submissions, submission_json);
  json["suggestion"] = suggestion(report);
  return json_text(json);
}

}  // namespace raycheck::tools
