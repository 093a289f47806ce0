#pragma once

// The arguments shared by commands that gate continuous integration. Internal to the commands.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "scene/text.h"
#include "tools/arguments.h"
#include "tools/gates/baseline.h"
#include "tools/report/output_file.h"

namespace raycheck::tools {

/// The values of --report, --baseline and related options.
struct GateArguments {
  std::vector<std::string> reports;  ///< KIND=FILE
  std::string baseline;
  bool updates = false;
  bool strict = false;
};
/// `kinds`: the values of --report.
void add_gate(CLI::App& command, GateArguments& arguments, const std::vector<std::string>& kinds);
template <class Report, std::size_t N>
void add_gate(CLI::App& command, GateArguments& arguments, const View<Report> (&views)[N]) {
  std::vector<std::string> kinds;
  for (const View<Report>& view : views) kinds.emplace_back(view.name);
  add_gate(command, arguments, kinds);
}

/// The files of a gate: opened before the work, so that hours are not lost, and written after it.
class GateFiles {
 public:
  /// Errors: std::invalid_argument naming the option, the file and what is wrong with it.
  explicit GateFiles(const GateArguments& arguments);

  /// The findings compared with the baseline, which is updated if requested; empty without a
  /// baseline.
  std::optional<Ratchet> ratchet(const Findings& findings, bool was_interrupted);

  template <class Report, std::size_t N>
  void write(const View<Report> (&views)[N], const Report& report) {
    for (ReportFile& one : reports_) {
      for (const View<Report>& view : views) {
        if (view.name != one.kind) continue;
        one.file->write(scene::visible(view.render(report, {})));
      }
    }
  }

 private:
  struct ReportFile {
    std::string kind;
    std::unique_ptr<OutputFile> file;
  };

  std::vector<ReportFile> reports_;
  std::string baseline_path_;
  Baseline baseline_;
  bool is_strict_ = false;
  std::optional<OutputFile> new_baseline_;
};

}  // namespace raycheck::tools
