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

/// An error for people: three significant digits, "0", "inf", or "-" if there is none.
std::string error_text(std::optional<double> error);

/// An answer for people, its numbers as 17 digits and hexfloat after their symbol: "s = 6
/// (0x1.8p+2)", "miss", "sphere 3", "no sphere".
std::string answer_text(properties::Quantity quantity, std::string_view symbol,
                        const std::vector<double>& numbers);
/// The answer in a discrepancy; "a sphere" if a picture does not show which one.
std::string got_text(const properties::Discrepancy& discrepancy);
std::string exact_text(const properties::Discrepancy& discrepancy);

/// False for quantities of the scene as a whole.
bool has_place(properties::Quantity quantity);
/// "pixel (3, 4), sphere 0" or "ray 2".
std::string place_text(const properties::Place& place);

/// A scene file as reports name it: "rt.txt (driver file of dialect A)".
std::string scene_file_text(std::string_view path, std::optional<scene::Dialect> dialect);
/// "not needed here: ambient, 2 lights", as a line, or empty.
std::string not_needed_text(const std::vector<std::string>& not_needed);

/// "[0.001, inf] radii"
std::string interval_text(const scene::ValidRoots& valid);
/// "t in [0.001, inf] radii, culling back-faces"
std::string valid_roots_text(const scene::ValidRoots& valid);
/// "rows bottom-first, samples edges, ..."; and which roots count, unless it is every one >= 0.
std::string conventions_text(const scene::Conventions& conventions);

/// Appended for judgement in floats: ", in single precision"; empty for doubles.
std::string_view precision_words(scene::Precision precision);

/// "4 numbers of the scene are not floats: judged on the rounded scene", or empty.
std::string rounded_numbers_text(std::size_t count);

/// A relative change in units of u, or as a plain number if large: "16 u", "1e-06".
std::string change_text(double relative_change,
                        scene::Precision precision = scene::Precision::kDouble);
/// Why a discrepancy is not held against the method, with the reason; empty if it is.
std::string excuse_text(const properties::Discrepancy& discrepancy);
/// The name of an input that a witness changes, by its index in reference::InputChange: "eye.x",
/// "radius", "spheres[2].centre.y" if all spheres take part.
std::string input_name(const properties::Discrepancy& discrepancy, std::size_t input);

/// "2 defects, 1 excused", by their counts; "no discrepancy" if there are none.
std::string standings_text(
    const std::function<std::uint64_t(properties::Standing standing)>& count);

/// "rows are upside down: explains 90 of 90 wrong pixels", without "explains" if the sentence is
/// not about a formula.
std::string explained_text(std::string_view sentence, std::uint64_t explained, std::uint64_t errors,
                           std::string_view answers);

/// The same of all, one per line; only the sentence if it explains nothing.
std::string explanations_text(const std::vector<properties::Explanation>& explanations,
                              std::string_view answers);

/// How a discrepancy is wrong: "false hit", "off by 6.7e+07 ulp".
std::string wrongness_text(const properties::Discrepancy& discrepancy);
/// A discrepancy in a line: "parameter, pixel (9, 8), sphere 0: off by 6.7e+07 ulp".
std::string discrepancy_head(const properties::Discrepancy& discrepancy);
/// A discrepancy in lines: the answer, the exact one, the error and the excuse.
std::string discrepancy_text(const properties::Discrepancy& discrepancy, bool colours);

/// How a law is broken, in lines: its sentence, the discrepancy and its causes (separate lines),
/// how to replay it (or empty) and the shrunk case as a scene.
std::string broken_law_text(std::string_view sentence, std::string_view discrepancy,
                            std::string_view causes, std::string_view replay,
                            std::string_view scene);

/// "250 by certified doubles, 6 by exact arithmetic (6 by intervals)"
std::string decided_by_text(const reference::DecidedBy& decided_by);

/// `text` in red, if colours are supported.
std::string red(std::string_view text, bool colours);

/// Lines, each prefixed with `indent`; empty ones stay empty.
std::string indented(std::string_view lines, std::string_view indent);

/// A word of a command in single quotes, whatever it contains.
std::string single_quoted(std::string_view word);
/// The same, quoted only if necessary.
std::string shell_word(const std::string& word);

/// "1 sphere", "2 spheres"
std::string count_text(std::uint64_t count, std::string_view noun);

}  // namespace raycheck::tools
