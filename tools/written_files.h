#pragma once

namespace CLI {
class App;
}

namespace raycheck::tools {

/// Throws std::invalid_argument where a file that an option has written is also one that another
/// argument of the command names, whatever links lead there: to be read (also as a word of a
/// candidate), or to be written.
/// Domain: a command whose arguments are parsed.
void require_written_apart(const CLI::App& command);

}  // namespace raycheck::tools
