#pragma once

#include <filesystem>

#include "tools/external/sandbox/launch.h"
#include "tools/grade/rubric/rubric.h"

namespace raycheck::tools {

/// Judges submissions of raycheck's own, which are right, one of each kind that the rubric's forms
/// take: where they fail, so would those of the students, through no fault of theirs. That it held
/// is noted in the folder `store`, and holds as long as what it depends on is the same; empty: it
/// is noted nowhere.
/// Errors: std::invalid_argument with what is wrong.
void test_environment(const Rubric& rubric, const Layers& layers,
                      const std::filesystem::path& store = {});

}  // namespace raycheck::tools
