#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <map>

#include "tools/grade/html.h"
#include "tools/grade/views.h"
#include "tools/grade/wording.h"
#include "tools/report/words.h"

namespace raycheck::tools {
namespace {

constexpr int kBins = 10;

/// 0 for what has no points.
double share_of(const SubmissionGrade& grade) {
  return grade.points > 0 ? grade.score / grade.points : 0;
}

std::string bar(double share, const char* kind) {
  return fmt::format(
      "<td class=\"{}\" style=\"width: 50%\"><span class=\"bar\" style=\"width: "
      "{:.1f}%\"></span></td>",
      kind, 100 * share);
}

std::string distribution(const ClassGrade& graded) {
  std::array<std::size_t, kBins + 1> counts{};
  for (const SubmissionGrade& grade : graded.submissions) {
    ++counts[static_cast<std::size_t>(std::clamp(share_of(grade), 0.0, 1.0) * kBins)];
  }
  const std::size_t most =
      std::max<std::size_t>(1, *std::max_element(counts.begin(), counts.end()));
  std::string html = "<h2>Scores</h2>\n<table>\n";
  for (int bin = kBins; bin >= 0; --bin) {
    const std::size_t count = counts[static_cast<std::size_t>(bin)];
    const std::string label =
        bin == kBins ? "100% and more"
                     : fmt::format("{}% to {}%", bin * 100 / kBins, (bin + 1) * 100 / kBins);
    html += fmt::format("<tr><td>{}</td><td class=\"number\">{}</td>{}</tr>\n", label, count,
                        bar(static_cast<double>(count) / static_cast<double>(most), "score"));
  }
  return html + "</table>\n";
}

std::string failing_items(const ClassGrade& graded) {
  struct Row {
    const Item* item;
    std::size_t asked = 0, failing = 0, left_out = 0;
  };
  std::vector<Row> rows;
  for (std::size_t k = 0; k < graded.rubric.items.size(); ++k) {
    Row row{&graded.rubric.items[k]};
    for (const SubmissionGrade& grade : graded.submissions) {
      const ItemGrade& item = grade.items[k];
      if (item.state == ItemState::kNotAsked || grade.refused) continue;
      ++row.asked;
      row.failing += item.state == ItemState::kFails ? 1 : 0;
      row.left_out +=
          item.state == ItemState::kLeftOut || item.state == ItemState::kNotJudged ? 1 : 0;
    }
    rows.push_back(row);
  }
  std::stable_sort(rows.begin(), rows.end(),
                   [](const Row& a, const Row& b) { return a.failing > b.failing; });
  std::string html =
      "<h2>Items that fail most</h2>\n<table>\n<tr><th>item</th><th "
      "class=\"number\">fail</th><th class=\"number\">left out</th><th class=\"number\">asked"
      "</th><th></th></tr>\n";
  for (const Row& row : rows) {
    html += fmt::format(
        "<tr><td>{}</td><td class=\"number\">{}</td><td class=\"number\">{}</td><td "
        "class=\"number\">{}</td>{}</tr>\n",
        escaped(row.item->name), row.failing, row.left_out, row.asked,
        bar(row.asked == 0 ? 0 : static_cast<double>(row.failing) / static_cast<double>(row.asked),
            "fail"));
  }
  return html + "</table>\n";
}

std::string link(const SubmissionGrade& grade) {
  std::string address;
  for (const char c : grade.name) {
    const bool is_plain = std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' || c == '_';
    address += is_plain ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
  }
  return fmt::format("<a href=\"{}/report.html\">{}</a>", address, escaped(grade.name));
}

using Members = std::vector<const SubmissionGrade*>;

/// What several submissions have in common: items of which they give the same wrong answer to the
/// same case.
struct Alike {
  Members members;
  std::vector<std::pair<std::string, std::string>> wrong;  ///< Items, and what is wrong.
};

std::string first_wrong_text(const FirstWrongAnswer& first) {
  const std::string text = origin_text(first.origin) + ": " + answer_text(first.answer);
  return first.answer.got.empty() ? text : text + ", " + got_text(first.answer);
}

std::vector<Alike> find_alike(const ClassGrade& graded) {
  std::vector<Alike> found;
  for (std::size_t k = 0; k < graded.rubric.items.size(); ++k) {
    std::map<std::string, Members> by_answer;
    for (const SubmissionGrade& grade : graded.submissions) {
      const auto& wrong = grade.items[k].first_wrong;
      if (wrong) by_answer[first_wrong_text(*wrong)].push_back(&grade);
    }
    for (const auto& [wrong, members] : by_answer) {
      if (members.size() < 2) continue;
      // A lambda cannot capture a structured binding by clang 14.
      auto known = std::find_if(found.begin(), found.end(), [&these = members](const Alike& one) {
        return one.members == these;
      });
      if (known == found.end()) known = found.insert(found.end(), Alike{members, {}});
      known->wrong.emplace_back(graded.rubric.items[k].name, wrong);
    }
  }
  std::stable_sort(found.begin(), found.end(), [](const Alike& a, const Alike& b) {
    return std::pair(a.members.size(), a.wrong.size()) >
           std::pair(b.members.size(), b.wrong.size());
  });
  return found;
}

/// Empty where they differ.
std::string mistake_of_all(const Members& members) {
  const std::string mistake = mistake_text(*members.front());
  const bool is_same = std::all_of(members.begin(), members.end(), [&](const auto* member) {
    return mistake_text(*member) == mistake;
  });
  return is_same ? mistake : "";
}

std::string alike(const ClassGrade& graded) {
  std::string html = "<h2>Alike</h2>\n<p>The same wrong answers to the same cases.</p>\n";
  const std::vector<Alike> found = find_alike(graded);
  if (found.empty()) return html + "<p>None.</p>\n";
  for (const Alike& one : found) {
    html += fmt::format(
        "<details><summary><span class=\"name\">{} alike in {}</span><span>{}"
        "</span></summary>\n<p>",
        one.members.size(), count_text(one.wrong.size(), "item"),
        escaped(mistake_of_all(one.members)));
    for (const SubmissionGrade* member : one.members) {
      html += (member == one.members.front() ? "" : ", ") + link(*member);
    }
    html += "</p>\n<dl>\n";
    for (const auto& [item, wrong] : one.wrong) {
      html += fmt::format("<dt>{}</dt><dd>{}</dd>\n", escaped(item), escaped(wrong));
    }
    html += "</dl></details>\n";
  }
  return html;
}

std::string everyone(const ClassGrade& graded) {
  std::string html =
      "<h2>Submissions</h2>\n<div class=\"wide\"><table>\n<tr><th>submission</th><th "
      "class=\"number\">score</th>";
  for (const Item& item : graded.rubric.items) {
    html += "<th class=\"number\">" + escaped(item.name) + "</th>";
  }
  html += "</tr>\n";
  for (const SubmissionGrade& grade : graded.submissions) {
    html += fmt::format("<tr><td>{}</td><td class=\"number\">{} of {}</td>", link(grade),
                        points_text(grade.score), points_text(grade.points));
    if (grade.refused) {
      html += fmt::format("<td colspan=\"{}\">{}</td>", graded.rubric.items.size(),
                          escaped(grade.refused->why));
    } else {
      for (const ItemGrade& item : grade.items) {
        html += fmt::format("<td class=\"number\">{}</td>",
                            item.state == ItemState::kNotAsked ? "-" : points_text(item.score));
      }
    }
    html += "</tr>\n";
  }
  return html + "</table></div>\n";
}

std::string summary(const ClassGrade& graded) {
  std::vector<double> shares;
  for (const SubmissionGrade& grade : graded.submissions) shares.push_back(share_of(grade));
  std::sort(shares.begin(), shares.end());
  const std::string median =
      shares.empty() ? "-" : fmt::format("{:.0f}%", 100 * shares[(shares.size() - 1) / 2]);
  std::string html =
      fmt::format("<h1>{}</h1>\n<p>{}, median {}</p>\n", escaped(graded.rubric.title),
                  count_text(graded.submissions.size(), "submission"), median);
  if (graded.interrupted) {
    html += "<p><strong>Interrupted: these are the submissions that were reached.</strong></p>\n";
  }
  return html;
}

}  // namespace

/// A self-contained page for instructors: the scores, the items that fail most, the submissions
/// that fail on the same case in the same way.
std::string class_page(const ClassGrade& graded) {
  return page(graded.rubric.title, summary(graded) + distribution(graded) + failing_items(graded) +
                                       alike(graded) + everyone(graded));
}

}  // namespace raycheck::tools
