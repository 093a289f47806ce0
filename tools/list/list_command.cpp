#include <memory>

#include "tools/arguments.h"
#include "tools/commands.h"
#include "tools/list/list.h"

namespace raycheck::tools {

CommandRun add_list(CLI::App& command) {
  const auto format = std::make_shared<std::string>();
  add_format(command, *format, kListViews);
  return [format] {
    print_view(kListViews, *format, catalogue());
    return kExitNothingFound;
  };
}

}  // namespace raycheck::tools
