#include "tools/gates/baseline.h"

#include <fmt/core.h>

#include <charconv>
#include <cstddef>
#include <filesystem>
#include <iterator>
#include <stdexcept>
#include <system_error>

#include "scene/text.h"

namespace raycheck::tools {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kFirstLine = "# raycheck baseline 2";
/// The first line of older files, which name candidates as the user typed them.
constexpr std::string_view kEarlier = "# raycheck baseline 1";
constexpr std::string_view kSeparator = "; ";

/// A field of a line. Characters that would end it, or are invisible, are written as escaped bytes.
std::string percent_encoded(std::string_view field) {
  constexpr std::string_view kSpelled = "%;#";
  constexpr std::size_t kMostBytes = 4;  // of a character
  const auto is_plain = [&](std::size_t bytes) {
    const std::string_view character = field.substr(0, bytes);
    return scene::visible_line(character) == character && kSpelled.find(character) == kSpelled.npos;
  };
  std::string text;
  while (!field.empty()) {
    const bool is_ascii = static_cast<unsigned char>(field.front()) < 0x80;
    const std::size_t most = is_ascii ? 1 : kMostBytes;
    std::size_t bytes = 1;
    while (bytes <= most && !is_plain(bytes)) ++bytes;
    if (bytes > most) {
      bytes = 1;
      text += fmt::format("%{:02X}", static_cast<unsigned char>(field.front()));
    } else {
      text += field.substr(0, bytes);
    }
    field.remove_prefix(bytes);
  }
  return text;
}

std::string percent_decoded(std::string_view field) {
  std::string text;
  while (!field.empty()) {
    unsigned int byte = static_cast<unsigned char>(field.front());
    const std::string_view digits = field.substr(1, 2);
    const bool is_spelled = field.front() == '%';
    if (is_spelled) {
      const auto read = std::from_chars(digits.data(), digits.data() + digits.size(), byte, 16);
      if (digits.size() < 2 || read.ptr != digits.data() + 2) {
        throw std::invalid_argument(fmt::format("'{}': expected % and two hexadecimal digits",
                                                scene::visible_line(field.substr(0, 3))));
      }
    }
    text += static_cast<char>(byte);
    field.remove_prefix(is_spelled ? 3 : 1);
  }
  return text;
}

std::vector<std::string> fields_of(std::string_view line) {
  std::vector<std::string> fields;
  for (;;) {
    const std::size_t end = line.find(kSeparator);
    fields.push_back(percent_decoded(line.substr(0, end)));
    if (fields.back().empty()) {
      throw std::invalid_argument(fmt::format("field {} is empty", fields.size()));
    }
    if (end == std::string_view::npos) return fields;
    line.remove_prefix(end + kSeparator.size());
  }
}

std::string line_of(const Identity& one) {
  return fmt::format("{1}{0}{2}{0}{3}{0}{4}{0}{5}\n", kSeparator, percent_encoded(one.law),
                     percent_encoded(one.source), percent_encoded(one.kind),
                     percent_encoded(one.place), percent_encoded(one.candidate));
}

void add_line(Baseline& baseline, std::string_view line) {
  if (line.starts_with("# ")) {
    const auto heading = fields_of(line.substr(2));
    if (heading.size() != 2) {
      throw std::invalid_argument("it is not a heading of the form '# LAW; SOURCE'");
    }
    baseline.headings.emplace(heading[0], heading[1]);
    return;
  }
  const auto fields = fields_of(line);
  if (fields.size() != 5) {
    throw std::invalid_argument("it is not of the form 'LAW; SOURCE; KIND; PLACE; CANDIDATE'");
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

std::string undecided_text(const properties::DefectKind& kind) {
  return kind_text(kind) + std::string(kUndecided);
}

std::string lasting_path(const std::string& path) {
  std::error_code ignored;
  const fs::path here = fs::current_path(ignored), typed = path;
  const fs::path within = (here / typed).lexically_normal().lexically_proximate(here);
  const bool is_elsewhere = *within.begin() == "..";
  return typed.is_absolute() && is_elsewhere ? typed.lexically_normal() : within;
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
            "a merge conflict of git; keep either side and update the baseline");
      }
      if (line.starts_with(kEarlier)) {
        throw std::invalid_argument(
            "the file has an older format, which names candidates as they were typed; remove it, "
            "then update the baseline, which creates it again");
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
    text += fmt::format("# {}{}{}\n", percent_encoded(law), kSeparator, percent_encoded(source));
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
  std::ranges::set_intersection(found, known, std::back_inserter(ratchet.known));
  std::ranges::set_difference(found, known, std::back_inserter(ratchet.added));
  std::ranges::set_difference(known, found, std::back_inserter(ratchet.mended));
  std::ranges::copy_if(known, std::back_inserter(ratchet.unasked), [&](const Identity& one) {
    return !findings.asked.contains(scope_of(one)) && !found.contains(one);
  });
  std::erase_if(ratchet.mended,
                [&](const Identity& one) { return !findings.complete.contains(scope_of(one)); });
  ratchet.is_conclusive =
      !findings.is_cut && std::ranges::none_of(ratchet.added, &Identity::is_undecided);
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
