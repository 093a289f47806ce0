#include "tools/commands/list.h"
#include "tools/edge.h"

namespace raycheck::tools {

CommandRun add_list(CLI::App& command) {
  const auto format = std::make_shared<std::string>();
  const auto bounds = std::make_shared<bool>(false);
  add_format(command, *format, {"text", "json"});
  command.add_flag("--bounds", *bounds, "show only the bounds on errors, and how they are proved");
  return [format, bounds] {
    if (*format == "json") {
      print_report(*bounds ? bounds_json() : list_json());
    } else {
      print_report(*bounds ? bounds_text() : list_text());
    }
    return kExitNothingFound;
  };
}

}  // namespace raycheck::tools
