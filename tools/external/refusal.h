#ifndef RAYCHECK_TOOLS_EXTERNAL_REFUSAL_H_
#define RAYCHECK_TOOLS_EXTERNAL_REFUSAL_H_

#include <string>

namespace raycheck::tools {

/// Why nothing of an implementation can be judged.
struct Refusal {
  std::string why;   ///< One line.
  std::string said;  ///< What a compiler said of it, or empty.
};

}  // namespace raycheck::tools

#endif  // RAYCHECK_TOOLS_EXTERNAL_REFUSAL_H_
