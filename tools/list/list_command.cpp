#include <memory>

#include "tools/arguments.h"
#include "tools/command_line.h"
#include "tools/commands.h"
#include "tools/list/list_views.h"

namespace raycheck::tools {

Command add_list(CLI::App& program) {
  CLI::App& command =
      *program.add_subcommand("list", "Show methods, laws, sources and conventions");
  const auto format = std::make_shared<std::string>();
  add_format(command, *format, kListViews);
  return {&command, [format] {
            print_view(kListViews, *format, catalogue());
            return kExitNothingFound;
          }};
}

}  // namespace raycheck::tools
