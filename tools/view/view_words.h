#pragma once

// What pages say of commands, and of what they have no room for; in view_words_text.cpp.

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "tools/view/document.h"

namespace raycheck::tools {

/// What explains the same ray and sphere at a desk. Of a camera's pixel: in the scene called
/// `file`, as a shell takes it; `more` is added.
std::string explain_command(const ExplainReport& report, const Selection& asked,
                            const fast::PixelRayMethod& rays, const std::string& file,
                            const std::string& more);

/// " --candidate ..." for someone else's implementation, as a shell takes it.
std::string candidate_words(const std::string& candidate);

/// "; |T|^2 is 1e+16 times as large: ..." of 10^decades times; empty where few digits are lost.
std::string squares_cancel(double decades);

/// A part of a whole that a page keeps: "3 of 7 spheres".
struct Kept {
  std::uint64_t shown = 0, all = 0;
};
std::string smaller_pictures(const std::string& scene, const scene::Pixel& shown,
                             const scene::Pixel& all);
std::string fewer_pictures(const std::string& scene, const Kept& candidates);
std::string fewer_spheres(const std::string& scene, const Kept& spheres);
std::string fewer_panels(const std::string& scene, const Kept& rays);
std::string fewer_judged(const std::string& scene, const Kept& rays);
std::string fewer_laws(const Kept& laws);

/// "as direct/cross has it"
std::string picture_name(const ScenePicture& picture);

/// Behind an s that counts multiples of a ray's direction; nothing where that is a unit vector.
std::string direction_remark(const ExplainReport& report);

/// What the microscope shows: around which point, in what unit, how far away the answers to a miss
/// are, and of which methods there is nothing to draw.
std::vector<std::string> microscope_sentences(const Microscope& microscope,
                                              const ExplainReport& report, double gap);

/// Of the first of the findings, behind its place, of so many discrepancies in all.
std::string worst_of(const Kept& places);
/// How many places with discrepancies are listed, of how many discrepancies, and largest errors.
std::string findings_found(const Kept& places, std::uint64_t errors);

/// [word, what it means] of the words that pages use.
std::vector<std::array<std::string, 2>> words_of_pages();

}  // namespace raycheck::tools
