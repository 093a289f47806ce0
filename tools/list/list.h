#ifndef RAYCHECK_TOOLS_LIST_LIST_H_
#define RAYCHECK_TOOLS_LIST_LIST_H_

#include <string>

namespace raycheck::tools {

/// The methods with their bounds, the laws, the sources of cases and the conventions.
std::string list_text();
std::string list_json();

}  // namespace raycheck::tools

#endif  // RAYCHECK_TOOLS_LIST_LIST_H_
