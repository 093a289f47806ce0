#pragma once

#include <string>

namespace raycheck::tools {

/// Why nothing of an implementation can be judged.
struct Refusal {
  std::string why;   ///< One line.
  std::string said;  ///< What a compiler said of it, or empty.
};

}  // namespace raycheck::tools
