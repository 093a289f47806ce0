#pragma once

#include <string>
#include <vector>

#include "tools/rubric/rubric.h"

namespace raycheck::tools {

std::string rubrics_text(const std::vector<ShippedRubric>& rubrics);
std::string copied_text(const CopiedRubric& copied);

}  // namespace raycheck::tools
