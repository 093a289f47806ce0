#include <fmt/core.h>

#include "tools/grade/html.h"
#include "tools/grade/pages.h"
#include "tools/grade/words.h"

namespace raycheck::tools {
namespace {

const char* class_of(const ItemGrade& grade) {
  return grade.state == kHolds ? "holds" : grade.state == kFails ? "fails" : "other";
}

std::string row(std::string_view term, std::string_view text) {
  if (text.empty()) return "";
  return fmt::format("<dt>{}</dt><dd>{}</dd>\n", term, escaped(text));
}

std::string failing_html(const FailingCase& failing, const std::string& name) {
  std::string html =
      "<dl>\n" + row("the law", failing.law) + row("smallest failing case", failing.what);
  html += row("yours", failing.actual) + row("exact", failing.expected);
  html += row("goes wrong at", failing.step) + row("found in", failing.origin) + "</dl>\n";
  html += "<p>The case to try: " + download(name + ".toml", failing.scene);
  if (!failing.driver.empty()) html += ", " + download(name + ".txt", failing.driver);
  return html + "</p>\n<pre>" + escaped(failing.scene) + "</pre>\n";
}

/// What a student may see: the visible items, thinned.
SubmissionGrade shown(const Rubric& rubric, SubmissionGrade grade) {
  std::vector<ItemGrade> items;
  for (std::size_t k = 0; k < grade.items.size(); ++k) {
    if (rubric.items[k].visibility != Visibility::kVisible) continue;
    items.push_back(thinned(rubric, rubric.items[k], grade.items[k]));
  }
  grade.items = std::move(items);
  return grade;
}

std::string item_html(const Item& item, const ItemGrade& grade) {
  const std::string of = item.bonus ? " of " + points_text(grade.points) + " (bonus)"
                                    : " of " + points_text(grade.points);
  std::string html = fmt::format(
      "<details class=\"{}\"{}>\n<summary><span class=\"name\">{}</span><span class=\"points\">"
      "{}</span></summary>\n",
      class_of(grade), grade.state == kFails ? " open" : "", escaped(item.name),
      grade.state == kNotAsked ? "not asked" : points_text(grade.score) + of);
  if (!item.asks.empty()) html += "<p>" + escaped(item.asks) + "</p>\n";
  html += "<p>" + escaped(state_text(grade)) + "</p>\n";
  for (const std::string& sentence : grade.sentences) {
    html += "<p><strong>" + escaped(sentence) + "</strong></p>\n";
  }
  if (grade.state == kFails && !item.hint.empty()) {
    html += "<p>Hint: " + escaped(item.hint) + "</p>\n";
  }
  for (const FailingCase& failing : grade.failing) {
    html += failing_html(failing, file_name(item.name));
  }
  return html + "</details>\n";
}

}  // namespace

std::string student_page(const Rubric& rubric, const SubmissionGrade& grade) {
  std::string html =
      fmt::format("<h1>{}</h1>\n<p>{}</p>\n", escaped(rubric.title), escaped(grade.name));
  html += fmt::format("<p class=\"total\">{} of {}</p>\n", points_text(grade.score),
                      points_text(grade.points));
  const std::string mistake = mistake_text(shown(rubric, grade));
  if (!mistake.empty()) html += "<p><strong>" + escaped(mistake) + "</strong></p>\n";
  if (!grade.finished) {
    html += "<p><strong>Grading was cut short: this is what was judged.</strong></p>\n";
  }
  if (!grade.refused.empty()) {
    html += "<h2>Nothing could be run</h2>\n<pre>" + escaped(grade.refused) + "</pre>\n";
  }
  std::size_t hidden = 0;
  for (std::size_t k = 0; k < grade.items.size(); ++k) {
    if (rubric.items[k].visibility != Visibility::kVisible) {
      ++hidden;
    } else if (grade.refused.empty()) {
      html += item_html(rubric.items[k], thinned(rubric, rubric.items[k], grade.items[k]));
    }
  }
  if (hidden > 0) {
    html += fmt::format("<p class=\"quiet\">{} in the score and not shown.</p>\n",
                        hidden == 1 ? "1 item is" : fmt::format("{} items are", hidden));
  }
  if (!grade.form.empty()) {
    html += fmt::format("<p class=\"quiet\">run as {}, kept by {}</p>\n", escaped(grade.form),
                        escaped(grade.kept_by));
  }
  return page(rubric.title + ": " + grade.name, html);
}

}  // namespace raycheck::tools
