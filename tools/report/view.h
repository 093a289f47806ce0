#pragma once

#include <string>
#include <string_view>

namespace raycheck::tools {

/// Where a view is shown.
struct ViewOptions {
  bool colours = false;  ///< For a terminal.
};

/// The active content that a text may have.
enum class ViewKind {
  kText,      ///< None.
  kCommands,  ///< Lines that GitHub's workflow log interprets.
};

/// A format of a command's report: its name for --format, and its writer. A room's views are in a
/// table; the first is the default.
template <class Report>
struct View {
  std::string_view name;
  std::string (*render)(const Report& report, const ViewOptions& options);
};

}  // namespace raycheck::tools
