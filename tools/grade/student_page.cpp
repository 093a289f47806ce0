#include <fmt/core.h>

#include "tools/grade/html.h"
#include "tools/grade/views.h"
#include "tools/grade/wording.h"
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

std::string failing_html(const FailingCase& failing, const std::string& name,
                         scene::Dialect dialect) {
  const WrongAnswer& answer = failing.answer;
  std::string html = "<dl>\n" + row("the law", law_text(failing)) +
                     row("smallest failing case", answer_text(answer));
  html += row("yours", got_text(answer)) + row("exact", exact_text(answer));
  html += row("goes wrong at", failing.step.value_or("")) +
          row("found in", origin_text(failing.origin)) + "</dl>\n";
  const std::string scene = scene_text(failing), driver = driver_file_text(failing, dialect);
  html += "<p>The case to try: " + download(name + ".toml", scene);
  if (!driver.empty()) html += ", " + download(name + ".txt", driver);
  return html + "</p>\n<pre>" + escaped(scene) + "</pre>\n";
}

std::string item_html(const Item& item, const ItemGrade& grade, scene::Dialect dialect) {
  const bool fails = grade.state == ItemState::kFails;
  const std::string of =
      fmt::format(" of {}{}", points_text(grade.points), item.bonus ? " (bonus)" : "");
  std::string html = fmt::format(
      "<details class=\"{}\"{}>\n<summary><span class=\"name\">{}</span><span class=\"points\">"
      "{}</span></summary>\n",
      class_of(grade), fails ? " open" : "", escaped(item.name),
      grade.state == ItemState::kNotAsked ? "not asked" : points_text(grade.score) + of);
  if (!item.asks.empty()) html += "<p>" + escaped(item.asks) + "</p>\n";
  html += "<p>" + escaped(state_text(grade)) + "</p>\n";
  for (const ExplainingMistake& mistake : grade.mistakes) {
    html += "<p><strong>" + escaped(mistake_text(grade, mistake)) + "</strong></p>\n";
  }
  if (fails && !item.hint.empty()) html += "<p>Hint: " + escaped(item.hint) + "</p>\n";
  if (grade.failing) html += failing_html(*grade.failing, file_name(item.name), dialect);
  return html + "</details>\n";
}

}  // namespace

std::string student_page(const StudentGrade& grade) {
  const SubmissionGrade& submission = grade.submission;
  std::string html =
      fmt::format("<h1>{}</h1>\n<p>{}</p>\n", escaped(grade.title), escaped(submission.name));
  html += fmt::format("<p class=\"total\">{} of {}</p>\n", points_text(submission.score),
                      points_text(submission.points));
  const std::string mistake = mistake_text(submission);
  if (!mistake.empty()) html += "<p><strong>" + escaped(mistake) + "</strong></p>\n";
  if (!submission.finished) {
    html += "<p><strong>Grading was cut short: this is what was judged.</strong></p>\n";
  }
  if (submission.refused) {
    html += "<h2>Nothing could be run</h2>\n<pre>" + escaped(refusal_text(*submission.refused)) +
            "</pre>\n";
  } else {
    for (std::size_t k = 0; k < grade.items.size(); ++k) {
      html += item_html(*grade.items[k], submission.items[k], grade.dialect);
    }
  }
  if (grade.unlisted > 0) {
    html += fmt::format(
        "<p class=\"quiet\">{} in the score and not shown.</p>\n",
        grade.unlisted == 1 ? "1 item is" : fmt::format("{} items are", grade.unlisted));
  }
  if (submission.program) {
    html += fmt::format("<p class=\"quiet\">run as {}, isolated by: {}</p>\n",
                        escaped(submission.program->text()), escaped(submission.isolation.text()));
  }
  return page(grade.title + ": " + submission.name, html);
}

}  // namespace raycheck::tools
