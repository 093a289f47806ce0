#pragma once

#include <string>

namespace raycheck::tools {

/// What someone's program or compiler said, without the names of raycheck's private folders and
/// without what is not ASCII.
std::string plain_text(const std::string& said);

}  // namespace raycheck::tools
