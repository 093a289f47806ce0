#pragma once

// The arguments shared by commands that gate continuous integration. Internal to the commands.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "scene/text.h"
#include "tools/flags.h"
#include "tools/gates/gate.h"
#include "tools/report/output_file.h"
#include "tools/terminal.h"

namespace raycheck::tools {

/// The values of --format, --report, --baseline and related options.
struct GateArguments {
  std::string format;
  std::vector<std::string> reports;  ///< KIND=FILE
  std::string baseline;
  bool updates = false;
  bool strict = false;
};
/// --format and --report, of these names and those of gate_formats(), and the options of a
/// baseline.
void add_gate(CLI::App& command, GateArguments& arguments, std::vector<std::string> formats);

/// Prints a report, or its gate, in the format of this name.
template <class Report, std::size_t N>
void print_view(const View<Report> (&views)[N], std::string_view format, const Report& report,
                const Gate& gate) {
  print_view(views, format, report);
  for (const GateFormat& one : gate_formats()) {
    if (one.name != format) continue;
    one.is_executed ? print_commands(one.write(gate)) : print_report(one.write(gate));
  }
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
  void write(const View<Report> (&views)[N], const Report& report, const Gate& gate) {
    for (ReportFile& one : reports_) {
      for (const View<Report>& view : views) {
        if (view.name == one.kind) one.file->write(scene::visible(view.render(report, {})));
      }
      for (const GateFormat& format : gate_formats()) {
        if (format.name == one.kind) one.file->write(scene::visible(format.write(gate)));
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
