#include <fmt/format.h>

#include <filesystem>
#include <stdexcept>
#include <utility>

#include "scene/files/file_text.h"
#include "tools/edge.h"

namespace raycheck::tools {
namespace {

/// A baseline has one line per known discrepancy.
constexpr std::uintmax_t kMostBaselineBytes = std::uintmax_t{64} << 20;

/// --report takes KIND=FILE.
CLI::Validator report_of(const std::vector<std::string>& kinds) {
  return CLI::Validator(
      [kinds](const std::string& text) -> std::string {
        const std::size_t equals = text.find('=');
        const std::string kind = text.substr(0, equals);
        if (equals == std::string::npos || equals + 1 == text.size() ||
            std::ranges::find(kinds, kind) == kinds.end()) {
          return fmt::format("'{}' is not KIND=FILE with KIND in {}", text, fmt::join(kinds, ", "));
        }
        return "";
      },
      "KIND=FILE");
}

}  // namespace

void add_gate(CLI::App& command, GateArguments& arguments, std::vector<std::string> formats) {
  for (const GateFormat& one : gate_formats()) formats.emplace_back(one.name);
  add_format(command, arguments.format, formats);
  command
      .add_option("--report", arguments.reports,
                  fmt::format("also write this report: KIND is one of {}; may be repeated",
                              fmt::join(formats, ", ")))
      ->check(report_of(formats));
  CLI::Option* const baseline =
      command
          .add_option("--baseline", arguments.baseline,
                      "a file of known discrepancies, one per line: only new ones fail")
          ->type_name("FILE");
  command
      .add_flag("--update-baseline", arguments.updates,
                "write the baseline, so that everything found counts as known")
      ->needs(baseline);
  command
      .add_flag("--strict-baseline", arguments.strict,
                "also fail if a discrepancy of the baseline no longer occurs")
      ->needs(baseline);
}

GateFiles::GateFiles(const GateArguments& arguments)
    : baseline_path_(arguments.baseline), is_strict_(arguments.strict) {
  if (!arguments.baseline.empty()) {
    const bool is_there = std::filesystem::exists(arguments.baseline);
    if (!is_there && !arguments.updates) {
      throw std::invalid_argument(
          fmt::format("--baseline {}: there is no such file; --update-baseline creates it",
                      arguments.baseline));
    }
    if (is_there) {
      try {
        baseline_ = parse_baseline(scene::file_text(arguments.baseline, kMostBaselineBytes));
      } catch (const std::invalid_argument& error) {
        throw std::invalid_argument(
            fmt::format("--baseline {}: {}", arguments.baseline, error.what()));
      }
    }
    if (arguments.updates) new_baseline_.emplace("--baseline", arguments.baseline);
  }
  for (const std::string& one : arguments.reports) {
    const std::size_t equals = one.find('=');
    const std::string path = one.substr(equals + 1);
    reports_.push_back({one.substr(0, equals), std::make_unique<OutputFile>("--report", path)});
  }
}

std::optional<Ratchet> GateFiles::ratchet(const Findings& findings, bool was_interrupted) {
  if (baseline_path_.empty()) return std::nullopt;
  if (new_baseline_ && !was_interrupted) {
    baseline_ = updated(std::move(baseline_), findings);
    new_baseline_->write(baseline_text(baseline_));
  }
  Ratchet ratchet = compare(baseline_, findings);
  ratchet.file = baseline_path_;
  ratchet.strict = is_strict_;
  return ratchet;
}

}  // namespace raycheck::tools
