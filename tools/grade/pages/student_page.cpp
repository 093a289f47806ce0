#include <fmt/core.h>

#include <boost/algorithm/string/replace.hpp>
#include <utility>

#include "scene/number.h"
#include "tools/grade/pages/views.h"
#include "tools/report/words.h"

namespace raycheck::tools {
namespace {

const char* class_of(const ItemGrade& grade) {
  return grade.state == ItemState::kHolds   ? "holds"
         : grade.state == ItemState::kFails ? "fails"
                                            : "other";
}

std::string row(std::string_view term, std::string_view text) {
  if (text.empty()) return "";
  return fmt::format("<dt>{}</dt><dd>{}</dd>\n", term, escaped(text));
}

/// The text of a file, collapsed at first.
std::string file_html(const std::string& name, const std::string& text) {
  return "<details class=\"file\"><summary>" + escaped(name) + "</summary><pre>" + escaped(text) +
         "</pre></details>\n";
}

std::string failing_html(const FailingCase& failing) {
  return pictures_html(failing) + "<dl>\n" + row("the law", law_text(failing)) +
         row("wrong answer", answer_text(failing)) + row("yours", got_text(failing)) +
         row("exact", exact_text(failing)) + row("goes wrong at", step_text(failing)) +
         row("smallest case found, from", origin_text(failing.origin)) + "</dl>\n";
}

std::string command_html(const HomeCommand& command) {
  return escaped(command.purpose) + ":<pre class=\"command\">" + escaped(command.words) + "</pre>";
}

/// The mistake, the hint, the failing case and the commands that repeat it.
std::string next_steps(const StudentGrade& grade, std::size_t k) {
  const Item& item = *grade.items[k];
  const ItemGrade& graded = grade.submission.items[k];
  std::string steps;
  const auto step = [&](const std::string& html) { steps += "<li>" + html + "</li>\n"; };
  for (const ExplainingMistake& mistake : graded.mistakes) {
    step("Correct the mistake: <strong>" + escaped(mistake_text(graded, mistake)) + "</strong>");
  }
  if (const std::string hint = hint_text(item, graded); !hint.empty()) {
    step("Hint: " + escaped(hint));
  }
  std::string files;
  if (graded.failing) {
    const std::string name = file_name(item.name);
    const std::string scene = scene_text(*graded.failing);
    const DriverForm form = grade.submission.found.driver();
    const std::string driver = driver_file_text(*graded.failing, grade.submission.found);
    std::string links = "Save the case beside your program: ";
    if (!driver.empty()) {
      links += download(name + form.ending(), driver) + " (driver file), ";
      files += file_html(name + form.ending(), driver);
    }
    step(links + download(name + ".toml", scene) + " (scene)");
    files += file_html(name + ".toml", scene);
    for (const HomeCommand& command : commands_for_case(grade, k)) step(command_html(command));
  }
  if (steps.empty()) return "";
  return "<h3>What to do next</h3>\n<ol>\n" + steps + "</ol>\n" + files;
}

/// The command that grades the submission again in its folder, as far as students may see.
HomeCommand command_for_all(const StudentGrade& grade) {
  const std::string& adapter = grade.submission.found.adapter;
  return {shipped_rubric(grade.rubric)
              ? "To grade your submission again, run in its folder"
              : "To grade your submission again, run in its folder, with " + grade.rubric +
                    (adapter.empty() ? "" : " and " + adapter) + " in it",
          fmt::format("raycheck try {} .{}", shell_word(grade.rubric),
                      grade.dialect.empty() ? "" : " --dialect " + shell_word(grade.dialect))};
}

/// `figure`: the address of the item's figure, or empty.
std::string item_html(const StudentGrade& all, std::size_t k, const std::string& figure) {
  const Item& item = *all.items[k];
  const ItemGrade& grade = all.submission.items[k];
  const bool fails = grade.state == ItemState::kFails;
  std::string html = fmt::format(
      "<details class=\"{}\"{}>\n<summary><h2 class=\"name\">{}</h2><span class=\"points\">"
      "{}</span></summary>\n",
      class_of(grade), fails ? " open" : "", escaped(item.name),
      grade.state == ItemState::kNotAsked ? "not asked"
                                          : points_text(grade.score) + of_points_text(grade));
  if (!item.asks.empty()) html += "<p>" + escaped(item.asks) + "</p>\n";
  if (!item.why.empty()) html += "<p class=\"quiet\">Why: " + escaped(item.why) + "</p>\n";
  html += "<p>" + escaped(state_text(grade)) + "</p>\n";
  if (grade.failing) html += failing_html(*grade.failing);
  if (!figure.empty()) {
    html += fmt::format(
        "<p><a href=\"{}\"><strong>See this case drawn, in space and step by "
        "step</strong></a></p>\n",
        escaped(figure));
  }
  if (fails) html += next_steps(all, k);
  return html + "</details>\n";
}

}  // namespace

std::vector<HomeCommand> commands_for_case(const StudentGrade& grade, std::size_t k) {
  const ItemGrade& item = grade.submission.items[k];
  const auto& program = grade.submission.found.program;
  if (!item.failing || !program) return {};
  const std::string name = file_name(item.name);
  const bool is_renderer = program->kind == CandidateKind::kRenderer;
  std::vector<HomeCommand> commands;
  if (!grade.submission.found.build_words.empty()) {
    commands.push_back({"Build it as the grader did, in a copy of your folder",
                        "(" + grade.submission.found.build_words + ")"});
  }
  if (is_renderer) {
    const DriverForm form = grade.submission.found.driver();
    std::string words = boost::replace_all_copy(program->what, "{scene}", name + form.ending());
    boost::replace_all(words, "{image}", "out.ppm");
    if (const auto& camera = item.failing->the_case.scene.camera) {
      boost::replace_all(words, "{width}", std::to_string(camera->width));
      boost::replace_all(words, "{height}", std::to_string(camera->height));
    }
    commands.push_back({"Draw the case", std::move(words)});
  }
  std::string check =
      fmt::format("raycheck check {}.toml --candidate {}", name, shell_word(program->text()));
  if (is_renderer && !(grade.submission.found.driver() == DriverForm{})) {
    check += " --dialect " + shell_word(grade.submission.found.driver().name());
  }
  if (is_renderer && !grade.depth.empty()) check += " --depth " + shell_word(grade.depth);
  const auto precision = grade.submission.items[k].failing->answer.precision;
  if (is_renderer && precision != scene::Precision::kDouble) {
    check += fmt::format(" --precision {}", scene::name(precision));
  }
  const auto& pictures = grade.items[k]->pictures;
  if (is_renderer && pictures && pictures->image_change) {
    check += " --image-change " + scene::shortest(*pictures->image_change);
  }
  const std::string& adapter = grade.submission.found.adapter;
  commands.push_back({(is_renderer ? "Check every pixel" : "Check every ray") +
                          (adapter.empty() ? "" : ", with " + adapter + " in your folder"),
                      std::move(check)});
  return commands;
}

std::string report_page(const StudentGrade& grade) {
  const SubmissionGrade& submission = grade.submission;
  std::string html =
      fmt::format("<h1>{}</h1>\n<p>{}</p>\n", escaped(grade.title), escaped(submission.name));
  // Mistakes first, so that a bonus does not hide them.
  const std::string mistake = mistake_text(submission);
  if (!mistake.empty()) html += "<p><strong>" + escaped(mistake) + "</strong></p>\n";
  const std::string total = score_text(submission) + of_points_text(submission);
  html += "<p class=\"total\">" +
          (could_be_judged(submission) ? total
           : submission.score > 0      ? "could not be judged; such a submission gets " + total
                                       : "could not be judged") +
          "</p>\n";
  if (!submission.finished) {
    html += "<p><strong>Grading was interrupted: these are the results so far.</strong></p>\n";
  }
  for (const std::string& note : submission.notes) {
    html += "<p>Your program: " + escaped(note) + "</p>\n";
  }
  if (submission.refused) {
    html += "<h2>Why your submission could not be judged</h2>\n<pre>" +
            escaped(refusal_text(*submission.refused)) + "</pre>\n";
  } else {
    std::size_t shown = 0;
    std::string failing, others;
    for (std::size_t k = 0; k < grade.items.size(); ++k) {
      const bool fails = submission.items[k].state == ItemState::kFails;
      (fails ? failing : others) += item_html(
          grade, k,
          has_figure(grade, k) ? fmt::format("{}#finding-{}", kFiguresFile, ++shown) : "");
    }
    html += failing + others;
  }
  html += "<div>" + command_html(command_for_all(grade)) + "</div>\n";
  if (grade.unlisted > 0) html += "<p class=\"quiet\">" + unlisted_text(grade) + ".</p>\n";
  // A refused program may be none: its command line may still have the rubric's placeholders.
  if (submission.found.program && could_be_judged(submission)) {
    html += fmt::format("<p class=\"quiet\">raycheck ran it as {}; it was isolated by {}.</p>\n",
                        escaped(submission.found.program->text()),
                        escaped(submission.isolation.text()));
  }
  return page(grade.title + ": " + submission.name, html);
}

}  // namespace raycheck::tools
