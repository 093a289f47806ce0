#include "tests/caught/page.h"

#include "tests/caught/places.h"
#include "tests/degenerate/judged.h"

namespace raycheck::caught {
namespace {

std::string line_of(const std::vector<std::string>& cells) {
  std::string line = "|";
  for (const std::string& cell : cells) line += " " + cell + (cell.empty() ? "|" : " |");
  return line + "\n";
}

std::string head_of(const std::vector<std::string>& cells) {
  std::string line = line_of(cells) + "|";
  for (std::size_t k = 0; k < cells.size(); ++k) line += "---|";
  return line + "\n";
}

std::string code(std::string_view word) { return "`" + std::string(word) + "`"; }

std::string joined(const std::vector<std::string>& words, const std::string& between = ", ") {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : between) + word;
  return text;
}

std::string power(const ErrorKind& kind, int k) {
  return std::to_string(kind.base) + "^-" + std::to_string(k);
}

const std::string kNever = "-";

}  // namespace

std::string cell_of(const FirstCaught& row, const CaseSource& source) {
  if (!row.severity) return kNever;
  return source.severities ? std::to_string(*row.severity) : "yes";
}

std::string cell_of(const Resolution& row) {
  return row.noticed ? std::to_string(*row.noticed) : kNever;
}

std::string line_of(const KnownReport& report, const FoundReport& found) {
  std::vector<std::string> said = found.sentences;
  for (std::string& one : said) {
    const bool is_true =
        std::find(report.sentences.begin(), report.sentences.end(), one) != report.sentences.end();
    if (!is_true) one = "false: " + one;
  }
  const bool is_found = !found.law.empty();
  std::vector<std::string> cells = {
      std::string(report.thread),
      std::string(report.said),
      code(report.mutant),
      is_found ? code(found.law) : "not found",
      is_found ? code(found.source) + ", case " + std::to_string(found.cases) : "",
      joined(said, "; "),
      std::string(report.needed)};
  for (std::string& cell : cells) {
    for (std::size_t at = 0; (at = cell.find('|', at)) != std::string::npos; at += 2) {
      cell.insert(at, 1, '\\');
    }
  }
  return line_of(cells);
}

std::string reports_table() {
  std::string table =
      head_of({"report", "what it says", "mutant", "law", "source", "sentence", "needed"});
  for (const KnownReport& report : known_reports()) {
    table += line_of(report, found(candidate_of(report)));
  }
  return table;
}

std::string degenerate_table() {
  using degenerate::Judgement;
  const degenerate::DegenerateRoom room;
  std::map<std::string, std::map<Judgement, int>> counts;
  for (const CaseSource& source : properties::case_sources()) {
    for (const auto& place : places_of(source)) {
      for (const degenerate::Judged& judged : room.judge(place, degenerate::kDegenerateCases)) {
        ++counts[judged.degenerate->candidate.name][judged.judgement];
      }
    }
  }
  std::string table = head_of({"candidate", "what it says", "laws that break it", "broken",
                               "right there", "nothing asked", "excused"});
  for (const degenerate::Degenerate& one : room.all()) {
    std::vector<std::string> laws;
    for (const std::string_view law : one.broken_by) laws.push_back(code(law));
    std::vector<std::string> cells = {code(one.candidate.name), std::string(one.sentence),
                                      joined(laws)};
    for (const Judgement judgement :
         {Judgement::kBroken, Judgement::kRight, Judgement::kNotAsked, Judgement::kExcused}) {
      cells.push_back(std::to_string(counts[one.candidate.name][judgement]));
    }
    table += line_of(cells);
  }
  return table;
}

std::string excused_table() {
  std::string table = head_of({"source", "severities", "laws", "candidates", "why"});
  for (const degenerate::WhyExcused& why : degenerate::why_excused()) {
    std::vector<std::string> laws, candidates;
    for (const std::string_view law : why.laws) laws.push_back(code(law));
    for (const std::string_view candidate : why.candidates) candidates.push_back(code(candidate));
    const auto& [source, from, to] = why.where;
    std::string severities = std::to_string(from);
    if (from != to) severities += " to " + std::to_string(to);
    table += line_of({code(source), severities, joined(laws),
                      candidates.empty() ? "any" : joined(candidates), std::string(why.reason)});
  }
  return table;
}

std::string mutant_tables(const std::vector<OfSource<FirstCaught>>& found) {
  std::string text;
  for (const bool of_cameras : {false, true}) {
    std::vector<std::string> head = {"mutant", "law"};
    std::map<std::pair<const mutants::Mutant*, const Law*>, std::vector<std::string>> cells;
    std::vector<std::pair<const mutants::Mutant*, const Law*>> order;
    for (const auto& [source, rows] : found) {
      if (of_cameras && !source->has_camera) continue;
      head.emplace_back(source->name);
      for (const FirstCaught& row : rows) {
        if (is_about_cameras(*row.law) != of_cameras) continue;
        const auto [at, is_new] = cells.try_emplace({row.mutant, row.law});
        if (is_new) order.push_back(at->first);
        at->second.push_back(cell_of(row, *source));
      }
    }
    text += std::string("### ") + (of_cameras ? "Laws of cameras" : "Laws of rays and spheres") +
            "\n\n" + head_of(head);
    for (const auto& key : order) {
      std::vector<std::string> line = {code(key.first->candidate.name), code(key.second->name)};
      line.insert(line.end(), cells[key].begin(), cells[key].end());
      text += line_of(line);
    }
    text += "\n";
  }
  return text;
}

std::string summary_table(const std::vector<OfSource<Resolution>>& found) {
  std::string table = head_of({"error", "law", "sources asked", "that notice 2^-20", "2^-46",
                               "2^-50", "finest", "coarsest"});
  for (const ErrorKind& kind : error_kinds()) {
    for (const std::string_view law : kind.laws) {
      std::vector<std::pair<int, std::string_view>> noticed;  // -1: nothing
      for (const auto& [source, rows] : found) {
        for (const Resolution& row : rows) {
          if (row.kind == &kind && row.law->name == law) {
            noticed.emplace_back(row.noticed.value_or(-1), source->name);
          }
        }
      }
      if (noticed.empty()) continue;
      const auto count = [&](double bits) {
        const double least = kind.base == 2 ? bits : bits * 0.30103;
        return std::to_string(std::count_if(noticed.begin(), noticed.end(),
                                            [&](const auto& one) { return one.first >= least; }));
      };
      const auto [coarsest, finest] =
          std::minmax_element(noticed.begin(), noticed.end(),
                              [](const auto& a, const auto& b) { return a.first < b.first; });
      const auto shown = [&](const auto& one) {
        return (one.first < 0 ? "nothing" : power(kind, one.first)) + " on " + code(one.second);
      };
      table += line_of({std::string(kind.name), code(law), std::to_string(noticed.size()),
                        count(20), count(46), count(50), shown(*finest), shown(*coarsest)});
    }
  }
  return table;
}

std::string resolution_tables(const std::vector<OfSource<Resolution>>& found) {
  std::string text;
  for (const ErrorKind& kind : error_kinds()) {
    std::vector<std::string> head = {"law"};
    std::vector<std::pair<std::string, std::vector<std::string>>> lines;
    for (const std::string_view law : kind.laws) lines.push_back({code(law), {}});
    for (const auto& [source, rows] : found) {
      const bool is_asked =
          std::any_of(rows.begin(), rows.end(), [&](const auto& row) { return row.kind == &kind; });
      if (!is_asked) continue;
      head.emplace_back(source->name);
      for (auto& [law, cells] : lines) {
        const auto row = std::find_if(rows.begin(), rows.end(), [&](const Resolution& one) {
          return one.kind == &kind && code(one.law->name) == law;
        });
        cells.push_back(row == rows.end() ? "" : cell_of(*row));
      }
    }
    text += "### " + std::string(kind.name) + ": " + std::string(kind.sentence) + "\n\n" +
            head_of(head);
    for (auto& [law, cells] : lines) {
      cells.insert(cells.begin(), law);
      text += line_of(cells);
    }
    text += "\n";
  }
  return text;
}

std::string severity_tables(const std::vector<OfSource<Resolution>>& found) {
  const std::vector<std::pair<std::string_view, std::string_view>> shown = {
      {"s", "parameter"},
      {"Q", "hit-point"},
      {"band", "class"},
      {"D", "direction"},
      {"order", "nearest-sphere"}};
  std::string text;
  for (const auto& [kind, law] : shown) {
    std::string table = head_of({"source", "severities", "k noticed at each"});
    for (const auto& [source, rows] : found) {
      if (!source->severities) continue;
      for (const Resolution& row : rows) {
        if (row.kind->name != kind || row.law->name != law) continue;
        std::vector<std::string> cells, severities;
        for (const auto& place : places_of(*source, kFewSeverities)) {
          const auto at = row.by_severity.find(*place.severity);
          cells.push_back(at == row.by_severity.end() ? kNever : std::to_string(at->second));
          severities.push_back(std::to_string(*place.severity));
        }
        table += line_of({code(source->name),
                          severities[0] + ", " + severities[1] + ", ... " + severities.back(),
                          joined(cells, " ")});
      }
    }
    text += "### " + std::string(kind) + " and `" + std::string(law) + "` by severity\n\n" + table +
            "\n";
  }
  return text;
}

std::string cell_in(const std::string& page, const std::string& heading,
                    const std::vector<std::string>& row, std::string_view column) {
  const auto cells = [](const std::string& line) {
    std::vector<std::string> result;
    std::istringstream parts(line.substr(std::min<std::size_t>(1, line.size())));
    for (std::string part; std::getline(parts, part, '|');) {
      const auto first = part.find_first_not_of(' ');
      const auto last = part.find_last_not_of(' ');
      result.push_back(first == std::string::npos ? "" : part.substr(first, last - first + 1));
    }
    return result;
  };
  std::istringstream lines(page.substr(std::min(page.find("\n### " + heading), page.size())));
  std::vector<std::string> head;
  std::string line;
  std::getline(lines, line);
  std::getline(lines, line);
  while (std::getline(lines, line) && line.rfind("#", 0) != 0) {
    if (line.rfind("|", 0) != 0) continue;
    const std::vector<std::string> these = cells(line);
    if (head.empty()) {
      head = these;
      continue;
    }
    if (these.size() != head.size() || !std::equal(row.begin(), row.end(), these.begin())) continue;
    const auto at = std::find(head.begin(), head.end(), column);
    if (at != head.end()) return these[static_cast<std::size_t>(at - head.begin())];
  }
  throw std::invalid_argument("the page has no " + heading + ", " + joined(row) + ", " +
                              std::string(column));
}

}  // namespace raycheck::caught
