#include "tools/gates/baseline.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <stdexcept>

#include "scene/text.h"

namespace raycheck::tools {
namespace {

constexpr std::string_view kFirstLine = "# raycheck baseline 1";
constexpr std::string_view kSeparator = "; ";

/// A field as a line has it: what would end it is spelled by its bytes.
std::string escaped(std::string_view field) {
  std::string text;
  for (const char c : scene::visible_line(field)) {
    text += c == '%' || c == ';' || c == '#' ? fmt::format("%{:02X}", static_cast<unsigned char>(c))
                                             : std::string(1, c);
  }
  return text;
}

std::string unescaped(std::string_view field) {
  constexpr std::array<std::pair<std::string_view, char>, 3> kSpelled = {
      {{"%25", '%'}, {"%3B", ';'}, {"%23", '#'}}};
  std::string text;
  while (!field.empty()) {
    const auto* const found = std::find_if(kSpelled.begin(), kSpelled.end(), [&](const auto& one) {
      return field.starts_with(one.first);
    });
    if (found == kSpelled.end() && field.front() == '%') {
      throw std::invalid_argument(fmt::format("'{}' is none of %25, %3B, %23", field.substr(0, 3)));
    }
    text += found == kSpelled.end() ? field.front() : found->second;
    field.remove_prefix(found == kSpelled.end() ? 1 : found->first.size());
  }
  return text;
}

std::vector<std::string> fields_of(std::string_view line) {
  std::vector<std::string> fields;
  for (;;) {
    const std::size_t end = line.find(kSeparator);
    fields.push_back(unescaped(line.substr(0, end)));
    if (fields.back().empty()) {
      throw std::invalid_argument(fmt::format("field {} is empty", fields.size()));
    }
    if (end == std::string_view::npos) return fields;
    line.remove_prefix(end + kSeparator.size());
  }
}

std::string line_of(const Identity& one) {
  return fmt::format("{1}{0}{2}{0}{3}{0}{4}{0}{5}\n", kSeparator, escaped(one.law),
                     escaped(one.source), escaped(one.kind), escaped(one.place),
                     escaped(one.candidate));
}

void add_line(Baseline& baseline, std::string_view line) {
  if (line.starts_with("# ")) {
    const auto heading = fields_of(line.substr(2));
    if (heading.size() != 2) {
      throw std::invalid_argument("a heading is a law and a source: # LAW; SOURCE");
    }
    baseline.headings.emplace(heading[0], heading[1]);
    return;
  }
  const auto fields = fields_of(line);
  if (fields.size() != 5) {
    throw std::invalid_argument(fmt::format(
        "{} fields, but a discrepancy is LAW; SOURCE; KIND; PLACE; CANDIDATE", fields.size()));
  }
  baseline.known.insert({fields[0], fields[1], fields[2], fields[3], fields[4]});
  baseline.headings.emplace(fields[0], fields[1]);
}

}  // namespace

std::string kind_text(const properties::DefectKind& kind) {
  return fmt::format(
      "{}: {}", info(kind.quantity).name,
      kind.wrong == properties::Wrong::kNot ? "error above its bound" : name(kind.wrong));
}

Scope scope_of(const Identity& identity) {
  return {identity.law, identity.source, identity.candidate};
}

Baseline parse_baseline(std::string_view text) {
  Baseline baseline;
  for (std::size_t number = 1; !text.empty(); ++number) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (line.ends_with('\r')) line.remove_suffix(1);
    if (line.empty() || line.starts_with(kFirstLine)) continue;
    try {
      if (line.starts_with("<<<<<<<") || line.starts_with("=======") ||
          line.starts_with(">>>>>>>")) {
        throw std::invalid_argument(
            "git left a conflict here; keep either side and update the baseline");
      }
      add_line(baseline, line);
    } catch (const std::invalid_argument& error) {
      throw std::invalid_argument(fmt::format("line {}: {}", number, error.what()));
    }
  }
  return baseline;
}

std::string baseline_text(const Baseline& baseline) {
  std::string text = fmt::format("{}: discrepancies that are known, see docs/ci.md\n", kFirstLine);
  auto next = baseline.known.begin();
  for (const auto& [law, source] : baseline.headings) {
    text += fmt::format("# {}{}{}\n", escaped(law), kSeparator, escaped(source));
    for (; next != baseline.known.end() && next->law == law && next->source == source; ++next) {
      text += line_of(*next);
    }
  }
  return text;
}

Ratchet compare(const Baseline& baseline, const Findings& findings) {
  Ratchet ratchet;
  const auto& found = findings.found;
  const auto& known = baseline.known;
  std::set_intersection(found.begin(), found.end(), known.begin(), known.end(),
                        std::back_inserter(ratchet.known));
  std::set_difference(found.begin(), found.end(), known.begin(), known.end(),
                      std::back_inserter(ratchet.added));
  std::set_difference(known.begin(), known.end(), found.begin(), found.end(),
                      std::back_inserter(ratchet.mended));
  std::copy_if(known.begin(), known.end(), std::back_inserter(ratchet.unasked),
               [&](const Identity& one) {
                 return !findings.asked.contains(scope_of(one)) && !found.contains(one);
               });
  std::erase_if(ratchet.mended,
                [&](const Identity& one) { return !findings.complete.contains(scope_of(one)); });
  return ratchet;
}

Baseline updated(Baseline baseline, const Findings& findings) {
  std::erase_if(baseline.known,
                [&](const Identity& one) { return findings.asked.contains(scope_of(one)); });
  for (const Identity& one : findings.found) {
    baseline.known.insert(one);
    baseline.headings.emplace(one.law, one.source);
  }
  return baseline;
}

}  // namespace raycheck::tools
