#include <memory>

#include "tools/commands.h"
#include "tools/commands/list.h"
#include "tools/flags.h"
#include "tools/terminal.h"

namespace raycheck::tools {

CommandRun add_list(CLI::App& command) {
  const auto format = std::make_shared<std::string>();
  const auto bounds = std::make_shared<bool>(false);
  add_format(command, *format, names_of(kListViews));
  command.add_flag("--bounds", *bounds, "show only the bounds on errors, and how they are proved");
  return [format, bounds] {
    if (*bounds) {
      print_view(kBoundsViews, *format, bounds_report());
    } else {
      print_view(kListViews, *format, catalogue());
    }
    return kExitNothingFound;
  };
}

}  // namespace raycheck::tools
