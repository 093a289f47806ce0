#pragma once

#include <string>
#include <string_view>

namespace raycheck::tools {

/// Where a view is shown.
struct ViewOptions {
  bool colours = false;      ///< Of a terminal.
  std::string picture_link;  ///< Where its picture is; empty: embedded.
};

/// What in a view acts on its reader.
enum class ViewKind {
  kText,      ///< Nothing.
  kCommands,  ///< Lines that the log of GitHub's workflows obeys.
  kBytes,     ///< Binary: written to files only.
};

/// A format of a command's report: what --format calls it, and what writes it. The views of a room
/// stand in a table, the first is what --format is by default.
template <class Report>
struct View {
  std::string_view name;
  std::string (*render)(const Report& report, const ViewOptions& options);
  ViewKind kind = ViewKind::kText;
};

}  // namespace raycheck::tools
