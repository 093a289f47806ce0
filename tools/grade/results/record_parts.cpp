#include "tools/grade/results/record_parts.h"

#include <stdexcept>
#include <string>

#include "scene/number.h"

namespace raycheck::tools {

std::vector<double> numbers(const Json& list) {
  std::vector<double> result;
  for (const Json& one : list) {
    const auto number = scene::parse_number(one.get<std::string>());
    if (!number) throw std::invalid_argument("no number");
    result.push_back(*number);
  }
  return result;
}

}  // namespace raycheck::tools
