#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "properties/mistakes/explanation.h"
#include "properties/verdict.h"
#include "reference/visibility/visibility.h"
#include "scene/conventions.h"
#include "scene/files/scene_file.h"

namespace raycheck::tools {

/// An error for people: three significant digits, "0", "inf", or "-" where there is none.
std::string error_text(std::optional<double> error);

/// An answer for people, its numbers as 17 digits and hexfloat behind their symbol:
/// "s = 6 (0x1.8p+2)", "miss", "sphere 3", "no sphere".
std::string answer_text(properties::Quantity quantity, std::string_view symbol,
                        const std::vector<double>& numbers);
/// What a discrepancy got; of a picture that does not tell which sphere it shows, "a sphere".
std::string got_text(const properties::Discrepancy& discrepancy);
std::string exact_text(const properties::Discrepancy& discrepancy);

/// False for what belongs to the scene as a whole.
bool has_place(properties::Quantity quantity);
/// "pixel (3, 4), sphere 0" or "ray 2".
std::string place_text(const properties::Place& place);

/// A scene file as reports name it: "rt.txt (driver file of dialect A)".
std::string scene_file_text(std::string_view path, std::optional<scene::Dialect> dialect);
/// "not needed here: ambient, 2 lights", a line, or nothing.
std::string not_needed_text(const std::vector<std::string>& not_needed);

/// "[0.001, inf] radii"
std::string interval_text(const scene::ValidRoots& valid);
/// "t in [0.001, inf] radii, culling back-faces"
std::string valid_roots_text(const scene::ValidRoots& valid);
/// "rows bottom-first, samples edges, ..."; which roots count, where that is not every one >= 0.
std::string conventions_text(const scene::Conventions& conventions);

/// Behind what is judged in floats: ", in single precision"; nothing of doubles.
std::string_view precision_words(scene::Precision precision);

/// "4 numbers of the scene are no floats: asked and judged on the scene rounded to floats", or
/// nothing.
std::string rounded_numbers_text(std::size_t count);

/// A relative change in units of u, or as it is where those would be many: "16 u", "1e-06".
std::string change_text(double relative_change,
                        scene::Precision precision = scene::Precision::kDouble);
/// Why a discrepancy is not held against the method, with what decided it; empty where it is.
std::string excuse_text(const properties::Discrepancy& discrepancy);
/// The name of an input that a witness changes, by its index in reference::InputChange: "eye.x",
/// "radius", "spheres[2].centre.y" where all spheres take part.
std::string input_name(const properties::Discrepancy& discrepancy, std::size_t input);

/// "2 defects, 1 excused", by how many there are of each; "no discrepancy" where there is none.
std::string standings_text(
    const std::function<std::uint64_t(properties::Standing standing)>& count);

/// "rows are upside down: 90 of 90 wrong pixels are right that way", a line each.
std::string explanations_text(const std::vector<properties::Explanation>& explanations,
                              std::string_view answers);

/// How a discrepancy is wrong: "false hit", "off by 6.7e+07 ulp".
std::string wrongness_text(const properties::Discrepancy& discrepancy);
/// What a discrepancy is, in a line: "parameter, pixel (9, 8), sphere 0: off by 6.7e+07 ulp".
std::string discrepancy_head(const properties::Discrepancy& discrepancy);
/// What a discrepancy is, got, should have been, by how much and with what excuse, in lines.
std::string discrepancy_text(const properties::Discrepancy& discrepancy, bool colours);

/// Why a law is broken, in lines: its sentence, what is wrong and what causes that (lines of their
/// own), how to ask again (or nothing) and the shrunk case as a scene.
std::string broken_law_text(std::string_view sentence, std::string_view discrepancy,
                            std::string_view causes, std::string_view replay,
                            std::string_view scene);

/// "250 by the filter, 6 exactly (6 by intervals)"
std::string decided_by_text(const reference::DecidedBy& decided_by);

/// `text` in red, where colours are taken.
std::string red(std::string_view text, bool colours);

/// Lines, each behind `indent`; empty ones stay empty.
std::string indented(std::string_view lines, std::string_view indent);

/// A word of a command between single quotes, whatever it has.
std::string single_quoted(std::string_view word);
/// The same, quoted only where it has to be.
std::string shell_word(const std::string& word);

/// "1 sphere", "2 spheres"
std::string count_text(std::uint64_t count, std::string_view noun);

}  // namespace raycheck::tools
