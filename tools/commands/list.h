#pragma once

#include <string>

namespace raycheck::tools {

/// Methods, laws and sources, in the order of reports; what scenes and candidates may declare.
std::string list_text();
std::string list_json();

/// All bounds on errors: proved bounds, and bounds that methods document and laws test.
std::string bounds_text();
std::string bounds_json();

}  // namespace raycheck::tools
