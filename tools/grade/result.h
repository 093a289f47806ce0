#ifndef RAYCHECK_TOOLS_GRADE_RESULT_H_
#define RAYCHECK_TOOLS_GRADE_RESULT_H_

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace raycheck::tools {

/// The smallest case found that an item fails on, all of it in words: what students are shown.
struct FailingCase {
  std::string law;     ///< Its sentence.
  std::string origin;  ///< "scene frame.toml", "course, random case 7"
  std::string step;    ///< The first step that goes wrong: "direction"; empty: not to be told.
  std::string what;    ///< "class, pixel (3, 4), sphere 0: missed"
  std::string actual;  ///< Numbers, or "miss"; empty: none.
  std::string expected;
  std::string scene;   ///< The case as a TOML scene.
  std::string driver;  ///< As a driver file; empty where it has no camera.
};

/// What became of an item.
inline constexpr const char* kHolds = "holds";
inline constexpr const char* kFails = "fails";
inline constexpr const char* kLeftOut = "left out";      ///< A prerequisite failed.
inline constexpr const char* kNotAsked = "not asked";    ///< Not of this form of submission.
inline constexpr const char* kNotJudged = "not judged";  ///< Time was up, or it was interrupted.

struct ItemGrade {
  std::string name;
  std::string state;
  std::string reason;  ///< Why it is left out, not asked, not judged, or fails without a case.
  double points = 0;   ///< To be had; 0 where it is not asked.
  double score = 0;
  bool bonus = false;
  std::uint64_t cases = 0;  ///< Of which something was asked.
  std::uint64_t held = 0;
  std::uint64_t comparisons = 0;
  std::vector<std::string> sentences;  ///< The mistake that explains what is wrong.
  std::vector<FailingCase> failing;    ///< One, or none.
  std::string first_wrong;  ///< The first failing case before it was shrunk and its wrong answer,
                            ///< the same for submissions that go wrong alike.
};

struct SubmissionGrade {
  std::string name;
  std::string key;      ///< Of all that the grade depends on.
  std::string form;     ///< The candidate as it was run; empty where none was found.
  std::string kept_by;  ///< The layers of isolation.
  std::string refused;  ///< Why nothing could be asked: a compiler's message, a missing file.
  std::uint64_t seed = 0;
  bool finished = false;
  double points = 0;  ///< Of items that are asked, bonus aside.
  double score = 0;
  std::vector<ItemGrade> items;
};

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(FailingCase, law, origin, step, what, actual, expected, scene,
                                   driver)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(ItemGrade, name, state, reason, points, score, bonus, cases,
                                   held, comparisons, sentences, failing, first_wrong)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(SubmissionGrade, name, key, form, kept_by, refused, seed,
                                   finished, points, score, items)

}  // namespace raycheck::tools

#endif  // RAYCHECK_TOOLS_GRADE_RESULT_H_
