#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "scene/text.h"
#include "tools/grade/pages/views.h"
#include "tools/grade/results/result.h"
#include "tools/report/words.h"

namespace raycheck::tools {
namespace {

constexpr int kBins = 10;

/// The share of the points; 0 if there are no points to earn.
double share_of(const SubmissionGrade& grade) {
  return grade.points > 0 ? (grade.score - grade.bonus) / grade.points : 0;
}

std::string bar(double share, const char* kind) {
  return fmt::format(
      "<td class=\"{}\" style=\"width: 50%\"><span class=\"bar\" style=\"width: "
      "{:.1f}%\"></span></td>",
      kind, 100 * share);
}

std::string distribution(const ClassGrade& graded) {
  std::array<std::size_t, kBins + 1> counts{};
  for (const SubmissionGrade* grade : submissions_that(graded, true)) {
    ++counts[static_cast<std::size_t>(std::clamp(share_of(*grade), 0.0, 1.0) * kBins)];
  }
  const std::size_t most = std::max<std::size_t>(1, *std::ranges::max_element(counts));
  std::string html = "<h2>Scores</h2>\n<table>\n";
  for (int bin = kBins; bin >= 0; --bin) {
    const std::size_t count = counts[static_cast<std::size_t>(bin)];
    const std::string label =
        bin == kBins ? "100%"
                     : fmt::format("{}% to {}%", bin * 100 / kBins, (bin + 1) * 100 / kBins);
    html += fmt::format("<tr><td>{}</td><td class=\"number\">{}</td>{}</tr>\n", label, count,
                        bar(static_cast<double>(count) / static_cast<double>(most), "score"));
  }
  return html + "</table>\n";
}

/// A row that says what an item tests, and why.
std::string about(const Item& item) {
  std::string html;
  for (const std::string& text : {item.asks, item.why}) {
    if (!text.empty()) html += (html.empty() ? "" : "<br>") + escaped(text);
  }
  return "<tr class=\"about\"><td colspan=\"5\">" + html + "</td></tr>\n";
}

/// An item, and the numbers of judged submissions of each outcome.
struct ItemRow {
  const Item* item;
  std::size_t asked = 0, failing = 0;
  std::size_t left_out = 0;  ///< Left out, or not judged because the time was up.
};

std::string failing_items(const ClassGrade& graded) {
  std::vector<ItemRow> rows;
  for (std::size_t k = 0; k < graded.rubric.items.size(); ++k) {
    ItemRow& row = rows.emplace_back(ItemRow{&graded.rubric.items[k]});
    for (const SubmissionGrade* grade : submissions_that(graded, true)) {
      const ItemState state = grade->items[k].state;
      row.asked += state != ItemState::kNotAsked ? 1 : 0;
      row.failing += state == ItemState::kFails ? 1 : 0;
      row.left_out += state == ItemState::kLeftOut || state == ItemState::kNotJudged ? 1 : 0;
    }
  }
  std::ranges::stable_sort(rows, std::greater{}, &ItemRow::failing);
  std::string html =
      "<h2>Items that fail most</h2>\n<div class=\"wide\"><table>\n<tr><th>item</th><th "
      "class=\"number\">fail</th><th class=\"number\">left out</th><th class=\"number\">asked"
      "</th><th>share that fails</th></tr>\n";
  for (const ItemRow& row : rows) {
    html += fmt::format(
        "<tr class=\"head\"><td>{}</td><td class=\"number\">{}</td><td class=\"number\">{}</td><td "
        "class=\"number\">{}</td>{}</tr>\n",
        escaped(row.item->name), row.failing, row.left_out, row.asked,
        bar(row.asked == 0 ? 0 : static_cast<double>(row.failing) / static_cast<double>(row.asked),
            "fail"));
    html += about(*row.item);
  }
  return html + "</table></div>\n";
}

/// The address of a file in a submission's folder.
std::string address_of(const SubmissionGrade& grade, std::string_view file) {
  return fmt::format("{}/{}", percent_encoded(grade.name, "-_"), file);
}

std::string link(const SubmissionGrade& grade) {
  return fmt::format("<a href=\"{}\">{}</a>", address_of(grade, kReportFile), escaped(grade.name));
}

/// A link to a submission's page of figures; empty if its student gets no figures.
std::string figures_link(const ClassGrade& graded, const SubmissionGrade& grade) {
  if (!has_figures(student_grade(graded.rubric, grade, HiddenBy::kUs))) return "";
  return fmt::format(" <a href=\"{}\" aria-label=\"figures of {}\">figures</a>",
                     address_of(grade, kFiguresFile), escaped(grade.name));
}

std::string links(const Submissions& members) {
  const auto link_of = [](const SubmissionGrade* member) { return link(*member); };
  return "<p>" + scene::joined(members, ", ", link_of) + "</p>\n";
}

/// The smallest failing case of a mistake, shown and for download.
std::string smallest_case(const ItemGrade& item, const Preparation& found) {
  const FailingCase& failing = *item.failing;
  const std::string name = file_name(item.name);
  const std::string driver = driver_file_text(failing, found);
  std::string html = "<p>The smallest failing case, from item " + escaped(item.name) + ": ";
  if (!driver.empty()) html += download(name + found.driver().ending(), driver) + ", ";
  html += download(name + ".toml", scene_text(failing)) + "</p>\n";
  return html + pictures_html(failing, "theirs") + "<p>" + escaped(answer_text(failing)) + "</p>\n";
}

/// A collapsed part of the page, with its name and a remark as the line that opens it.
std::string details(std::string_view name, std::string_view remark, const std::string& html) {
  return fmt::format(
      "<details><summary><span class=\"name\">{}</span><span>{}</span></summary>\n{}</details>\n",
      escaped(name), escaped(remark), html);
}

std::string mistakes(const ClassGrade& graded) {
  const std::size_t judged = submissions_that(graded, true).size();
  std::string html =
      "<h2>Mistakes</h2>\n<p>Sorted by the number of students whose wrong answers they explain; if "
      "several explain the same answers, each is counted.</p>\n";
  const std::vector<MistakeStatistics> all = mistake_statistics(graded.submissions);
  if (all.empty()) return html + "<p>No mistake was identified.</p>\n";
  for (const MistakeStatistics& one : all) {
    const std::string smallest =
        one.smallest != nullptr ? smallest_case(*one.smallest, one.whose->found) : "";
    html += details(one.sentence,
                    fmt::format("{} of {}", one.students.size(), count_text(judged, "student")),
                    links(one.students) + smallest);
  }
  return html;
}

std::string not_judged(const ClassGrade& graded) {
  const Submissions all = submissions_that(graded, false);
  if (all.empty()) return "";
  std::string html =
      "<h2>Could not be judged</h2>\n<p>The numbers above do not include these submissions.";
  if (graded.rubric.unjudged > 0) {
    html +=
        fmt::format(" The rubric gives them {:g}% of the points.", 100 * graded.rubric.unjudged);
  }
  html += "</p>\n";
  for (const SubmissionGrade* grade : all) {
    const std::string& said = grade->refused->said;
    html += details(grade->name, grade->refused->why,
                    "<p>Report: " + link(*grade) + "</p>\n" +
                        (said.empty() ? "" : "<pre>" + escaped(said) + "</pre>\n"));
  }
  return html;
}

/// A text about the submissions whose totals lack cases that cannot be written in their input
/// format.
std::string inexpressible(const ClassGrade& graded) {
  std::string html;
  for (const SubmissionGrade& grade : graded.submissions) {
    const std::string text = inexpressible_text(grade);
    if (!text.empty()) html += "<p>" + link(grade) + ": " + text + "</p>\n";
  }
  return html.empty() ? "" : "<h2>Cases that were not asked</h2>\n" + html;
}

std::string everyone(const ClassGrade& graded) {
  std::string html =
      "<h2>Submissions</h2>\n<div class=\"wide\"><table>\n<tr><th>submission</th><th "
      "class=\"number\">score</th>";
  for (const Item& item : graded.rubric.items) {
    html += "<th class=\"number\">" + escaped(item.name) + "</th>";
  }
  html += "<th class=\"number\">built</th><th class=\"number\">judged</th></tr>\n";
  for (const SubmissionGrade& grade : graded.submissions) {
    const bool is_judged = could_be_judged(grade);
    html += fmt::format("<tr><td>{}{}</td><td class=\"number\">{}{}</td>", link(grade),
                        figures_link(graded, grade), score_text(grade), of_points_text(grade));
    if (!is_judged) {
      html += fmt::format("<td colspan=\"{}\">{}</td>", graded.rubric.items.size(),
                          escaped(not_judged_text(grade)));
    } else {
      for (const ItemGrade& item : grade.items) {
        html += fmt::format("<td class=\"number\">{}</td>",
                            item.state == ItemState::kNotAsked ? "-" : points_text(item.score));
      }
    }
    const std::string built = grade.build_is_stored ? "0 s, from the store"
                                                    : fmt::format("{:.1f} s", grade.build_seconds);
    html += fmt::format("<td class=\"number\">{}</td><td class=\"number\">{:.1f} s</td></tr>\n",
                        built, grade.judge_seconds);
  }
  return html + "</table></div>\n";
}

/// A list of files whose content a human reader cannot judge: binaries, pictures, large files.
std::string opaque(const ClassGrade& graded) {
  constexpr std::size_t kMostListed = 8;
  std::string rows;
  for (const SubmissionGrade& grade : graded.submissions) {
    const std::string text =
        first_text(grade.found.opaque_files, kMostListed, [](const OpaqueFile& file) {
          return fmt::format("{} ({}, {:.0f} KiB)", file.name, file.kind,
                             std::ceil(static_cast<double>(file.bytes) / 1024));
        });
    if (!text.empty())
      rows += "<tr><td>" + link(grade) + "</td><td>" + escaped(text) + "</td></tr>\n";
  }
  if (rows.empty()) return "";
  return "<h2>Files to look at</h2>\n<p>Programs, archives, pictures and large files that were "
         "handed in. They are allowed, and most are harmless; but such a file can contain raycheck "
         "itself, or results computed elsewhere, and no test can detect that.</p>\n"
         "<div class=\"wide\"><table>\n" +
         rows + "</table></div>\n";
}

std::string summary(const ClassGrade& graded) {
  std::vector<double> shares;
  for (const SubmissionGrade* grade : submissions_that(graded, true)) {
    shares.push_back(share_of(*grade));
  }
  std::ranges::sort(shares);
  const std::size_t count = shares.size(), not_judged = graded.submissions.size() - count;
  const std::string times = times_text(graded);
  std::string html = fmt::format(
      "<h1>{}</h1>\n<p>{}, median {}{}{}</p>\n", escaped(graded.rubric.title),
      count_text(graded.submissions.size(), "submission"),
      count > 0 ? fmt::format("{:.0f}%", 50 * (shares[(count - 1) / 2] + shares[count / 2])) : "-",
      not_judged > 0 ? fmt::format(", {} could not be judged", not_judged) : "",
      times.empty() ? "" : "; " + times);
  if (graded.isolation) {
    html += "<p class=\"quiet\">" + escaped(isolation_text(*graded.isolation)) + "</p>\n";
  }
  if (graded.interrupted) {
    html += "<p><strong>Interrupted: these are the results so far.</strong></p>\n";
  }
  return html;
}

}  // namespace

/// A self-contained page for instructors with the scores, the items that fail most and the most
/// frequent mistakes.
std::string class_page(const ClassGrade& graded) {
  return page(graded.rubric.title, summary(graded) + distribution(graded) + failing_items(graded) +
                                       mistakes(graded) + not_judged(graded) +
                                       inexpressible(graded) + opaque(graded) + everyone(graded));
}

}  // namespace raycheck::tools
