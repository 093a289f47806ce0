#pragma once

#include <string_view>

namespace raycheck::tests {

// What is fuzzed, each a function of any bytes. What reads them may refuse them by the exception
// that it documents; all else that is thrown, and what sanitizers find, is a defect.

void fuzz_toml_scene(std::string_view bytes);
void fuzz_driver_file(std::string_view bytes);
void fuzz_rubric(std::string_view bytes);
void fuzz_reply(std::string_view bytes);
void fuzz_picture(std::string_view bytes);
void fuzz_unit(std::string_view bytes);

/// Of a target, in tests/fuzz/regressions/NAME: inputs on which it failed once.
struct FuzzTarget {
  std::string_view name;
  void (*run)(std::string_view bytes);
};

inline constexpr FuzzTarget kFuzzTargets[] = {
    {"toml_scene", fuzz_toml_scene}, {"driver_file", fuzz_driver_file}, {"rubric", fuzz_rubric},
    {"reply", fuzz_reply},           {"picture", fuzz_picture},         {"unit", fuzz_unit}};

}  // namespace raycheck::tests
