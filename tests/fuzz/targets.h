#pragma once

#include <string_view>

namespace raycheck::tests {

// The targets of fuzzing. Each is a function of any bytes. A parser may refuse them by its
// documented exception; any other exception, and any finding of a sanitizer, is a defect.

void fuzz_toml_scene(std::string_view bytes);
void fuzz_driver_file(std::string_view bytes);
void fuzz_rubric(std::string_view bytes);
void fuzz_reply(std::string_view bytes);
void fuzz_picture(std::string_view bytes);
void fuzz_unit(std::string_view bytes);

/// A target. Inputs on which it once failed are in tests/fuzz/regressions/NAME.
struct FuzzTarget {
  std::string_view name;
  void (*run)(std::string_view bytes);
};

inline constexpr FuzzTarget kFuzzTargets[] = {
    {"toml_scene", fuzz_toml_scene}, {"driver_file", fuzz_driver_file}, {"rubric", fuzz_rubric},
    {"reply", fuzz_reply},           {"picture", fuzz_picture},         {"unit", fuzz_unit}};

}  // namespace raycheck::tests
