#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "properties/discrepancy.h"
#include "properties/mistakes/explanation.h"
#include "properties/verdict.h"
#include "reference/visibility/visibility.h"
#include "scene/conventions.h"
#include "scene/files/scene_file.h"

namespace raycheck::tools {

/// An error in reports as text: three significant digits, "0", "inf", or "-" if there is none.
std::string error_text(std::optional<double> error);

/// An answer in reports as text, its numbers with 17 digits and as hexfloats after their symbol: "s
/// = 6 (0x1.8p+2)", "miss", "sphere 3", "no sphere".
std::string answer_text(properties::Quantity quantity, std::string_view symbol,
                        const std::vector<double>& numbers);
/// The answer in a discrepancy; "a sphere" if a picture does not show which one.
std::string got_text(const properties::Discrepancy& discrepancy);
std::string exact_text(const properties::Discrepancy& discrepancy);

/// Whether a quantity belongs to a pixel or ray, not to the whole scene.
bool has_place(properties::Quantity quantity);
/// "pixel (3, 4), sphere 0" or "ray 2".
std::string place_text(const properties::Place& place);

/// The name of a scene file in reports, with its format if it is not TOML: "rt.txt (format A)".
std::string scene_file_text(std::string_view path, std::string_view format);
/// The line "not needed here: ambient, 2 lights", or empty.
std::string not_needed_text(const std::vector<std::string>& not_needed);

/// "[0.001, inf] radii"
std::string interval_text(const scene::ValidRoots& valid);
/// "s in [0.001, inf] radii, culling back-faces"
std::string valid_roots_text(const scene::ValidRoots& valid);
/// "rows bottom-first, samples edges, ...", and which roots count unless every root >= 0 does.
std::string conventions_text(const scene::Conventions& conventions);

/// ", in single precision", to be appended; empty for doubles.
std::string_view precision_words(scene::Precision precision);

/// "4 numbers of the scene are not floats: judged on the rounded scene", or empty.
std::string rounded_numbers_text(std::size_t count);

/// A relative change in u or, if it is large, as a plain number: "16 u", "1e-06".
std::string change_text(double relative_change,
                        scene::Precision precision = scene::Precision::kDouble);
/// Why a discrepancy is not a defect, with the reason; empty if it is a defect.
std::string excuse_text(const properties::Discrepancy& discrepancy);
/// The name of an input that a witness changes, by its index in reference::InputChange: "eye.x",
/// "radius", "spheres[2].centre.y" if all spheres take part.
std::string input_name(const properties::Discrepancy& discrepancy, std::size_t input);

/// "2 defects, 1 excused"; "no discrepancy" if all counts are 0.
std::string standings_text(
    const std::function<std::uint64_t(properties::Standing standing)>& count);

/// "3 of 90 comparisons are right only within the declared tolerance_c 1e-12: ..."; `declared`: the
/// tolerances; empty without any.
std::string tolerated_text(const properties::Verdict& verdict, const std::string& declared);

/// "all 90 wrong pixels examined" or "11 of 12 wrong answers examined"; `answers` is a noun in the
/// plural.
std::string wrong_share_text(std::uint64_t explained, std::uint64_t errors,
                             std::string_view answers);
/// "rows are upside down; this explains all 90 wrong pixels examined"
std::string explained_text(std::string_view sentence, std::uint64_t explained, std::uint64_t errors,
                           std::string_view answers);

/// explained_text() of all explanations, one per line. If an explanation explains nothing, only its
/// sentence.
std::string explanations_text(const std::vector<properties::Explanation>& explanations,
                              std::string_view answers);

/// The kind or size of a discrepancy's error: "false hit", "off by 6.7e+07 ulp".
std::string wrongness_text(const properties::Discrepancy& discrepancy);
/// A discrepancy in one line: "parameter, pixel (9, 8), sphere 0: off by 6.7e+07 ulp".
std::string discrepancy_head(const properties::Discrepancy& discrepancy);
/// A discrepancy in lines: the answer, the exact answer, the error and the excuse.
std::string discrepancy_text(const properties::Discrepancy& discrepancy, bool colours);

/// The text about a broken law, from these parts: its sentence, the discrepancy, its causes (in
/// lines), how to replay it (may be empty) and the shrunk case as a scene.
std::string broken_law_text(std::string_view sentence, std::string_view discrepancy,
                            std::string_view causes, std::string_view replay,
                            std::string_view scene, bool is_shrunk = true);

/// The questions of which an answer of this kind is expected: "rays that hit".
std::string expected_text(properties::Expected expected);

/// "250 by certified doubles, 6 by exact arithmetic (6 by intervals)"
std::string decided_by_text(const reference::DecidedBy& decided_by);

/// `text`, in red if `colours`.
std::string red(std::string_view text, bool colours);

/// Lines, each prefixed with `indent`; empty lines stay empty.
std::string indented(std::string_view lines, std::string_view indent);

/// A word of a command in single quotes, whatever it contains.
std::string single_quoted(std::string_view word);
/// A word of a command, quoted only if necessary.
std::string shell_word(const std::string& word);

/// A text as a TOML basic string.
std::string toml_text(std::string_view text);

/// Texts by a key, in the order in which the keys first came.
template <class Key>
using Grouped = std::vector<std::pair<Key, std::vector<std::string>>>;
template <class Key>
void add_to(Grouped<Key>& groups, const Key& key, const std::string& text) {
  auto known = std::ranges::find_if(groups, [&](const auto& one) { return one.first == key; });
  if (known == groups.end()) known = groups.insert(known, {key, {}});
  known->second.push_back(text);
}

/// "1 sphere", "2 spheres"
std::string count_text(std::uint64_t count, std::string_view noun);

}  // namespace raycheck::tools
