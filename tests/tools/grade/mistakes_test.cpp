// The classic mistakes in tests/submissions, graded by the rubric of the seventh lecture; and
// submissions in `float`, graded in double and single precision.

#include "tests/tools/grade/grading.h"

namespace raycheck::tests {
namespace {

/// The cost of a mistake.
struct Mistake {
  const char* name;
  double score;          ///< Of 100 and a bonus of 10, to two decimals.
  const char* fails;     ///< Items that fail, without those that follow.
  const char* sentence;  ///< The mistake named for the submission; or empty.
  int named;             ///< The number of items that name it.
};

const std::vector<Mistake> kOfFunctions = {
    {"width_height", 105, "boundary pixels", "width and height are exchanged", 3},
    {"top_from_right", 105, "boundary pixels", "top is taken from right", 3},
    {"top_is_minus_bottom", 105, "boundary pixels", "top is -bottom", 3},
    {"u_flipped", 95, "camera frame", "U and V have the wrong sign, as by U = W x up", 5},
    {"u_and_w_flipped", 95, "camera frame", "U and W have the wrong sign, as by W = A - E", 5},
    {"no_test_for_t", 98.08, "nearest root, robustness",
     "s >= 0 is not tested: spheres behind the origin are hit", 2},
    {"first_sphere_wins", 95, "nearest sphere", "the first sphere in the file wins", 1},
    {"normalize_discarded", 94.5, "unit directions, robustness",
     "directions are not normalised: D = P - E", 1},
    {"by_discriminant", 95, "nearest sphere", "the sphere with the largest discriminant wins", 1},
    {"eye_plus_point", 100, "ray origin",
     "E is added where it should be subtracted: D = (P + E)/|P + E|", 1},
    {"axes_dropped", 95, "camera frame", "the axes are lost: all are zero", 6},
    {"float_directions", 110, "", "", 0},
    {"near_root_only", 109.25, "robustness",
     "only the near root counts, so that spheres around the origin are not seen", 1},
    {"far_root", 84.1667, "nearest root, hit point, robustness",
     "the far root is taken for the near one", 2},
    {"upside_down", 105, "boundary pixels", "rows are upside down", 4},
    {"mirrored", 105, "boundary pixels", "columns are mirrored", 4},
    {"cancelling", 104.5, "robustness", "", 0},
    {"near_negated", 105, "width and height",
     "near has the wrong sign, the image plane is behind the eye", 2},
    {"centre_behind", 109.67, "robustness",
     "only the near root counts, so that spheres around the origin are not seen, or: v >= 0 is "
     "tested in place of s >= 0: spheres around the origin are hit behind it, or: v < 0 counts "
     "as a miss, so that spheres around the origin are not seen if their centres lie behind it",
     1},
};

const std::vector<Mistake> kOfPictures = {
    {"width_height", 105, "width and height", "width and height are exchanged", 2},
    {"top_from_right", 105, "boundary pixels", "top is taken from right", 2},
    {"top_is_minus_bottom", 105, "boundary pixels", "top is -bottom", 2},
    {"u_flipped", 103, "boundary pixels, robustness",
     "all four bounds are negated, or: U and V have the wrong sign, as by U = W x up", 4},
    {"u_and_w_flipped", 85, "camera frame, robustness",
     "U and W have the wrong sign, as by W = A - E", 11},
    {"no_test_for_t", 98, "nearest root, robustness",
     "s >= 0 is not tested: spheres behind the origin are hit, or: the smallest s wins, even if "
     "it is negative",
     4},
    {"first_sphere_wins", 95, "nearest sphere", "the first sphere in the file wins", 2},
    {"normalize_discarded", 90, "unit directions, robustness",
     "directions are not normalised: D = P - E", 11},
    {"by_discriminant", 95, "nearest sphere", "the sphere with the largest discriminant wins", 2},
    {"eye_plus_point", 100, "ray origin",
     "E is added where it should be subtracted: D = (P + E)/|P + E|", 3},
    {"float_directions", 110, "", "", 0},
    {"near_root_only", 108, "robustness",
     "only the near root counts, so that spheres around the origin are not seen", 1},
    {"centre_behind", 108, "robustness",
     "v < 0 counts as a miss, so that spheres around the origin are not seen if their centres "
     "lie behind it",
     1},
    {"far_root", 95, "nearest sphere",
     "the far root is taken for the near one, or: the sphere whose centre is nearest wins", 2},
    {"upside_down", 105, "pixel (0, 0)", "rows are upside down", 2},
    {"mirrored", 103, "pixel (0, 0), robustness", "columns are mirrored", 3},
    {"cancelling", 108, "robustness",
     "d^2 loses its digits, because it is the difference of much larger numbers; "
     "r^2 - |T x D|^2 keeps them (the wrong cases examined are at 10^8 radii or more)",
     1},
    {"left_and_right_negated", 103, "boundary pixels, robustness",
     "left and right are both negated, or: U has the wrong sign", 4},
    {"bottom_and_top_negated", 105, "boundary pixels",
     "top and bottom are both negated, or: V has the wrong sign", 3},
    {"symmetric_bounds", 105, "boundary pixels",
     "the image plane is taken to be centred: left is -right and bottom is -top", 2},
    {"bottom_first", 105, "boundary pixels",
     "left is taken from bottom, right from top, bottom from left and top from right", 2},
    {"size_exchanged", 105, "width and height", "width and height of the picture are exchanged", 2},
    {"aspect_twice", 105, "width and height",
     "the aspect ratio is corrected twice: alpha is multiplied by width/height", 2},
    {"shares_of_the_count", 95, "boundary pixels, robustness", "i/w and j/h place the pixels", 11},
    {"plane_at_1", 95, "boundary pixels, robustness",
     "the image plane is always 1 in front of the eye, as if d were the far plane", 11},
    {"from_the_eye", 98, "ray origin, robustness",
     "rays start at the eye, so that spheres before the image plane are seen", 3},
    {"epsilon", 106, "robustness",
     "hits with an s below about 0.001 (the limit may be larger) are dropped: the epsilon is too "
     "large",
     1},
    {"whole_numbers", 85, "camera frame, robustness",
     "numbers are read as integers: their fractions are dropped", 9},
    {"whole_bounds", 97, "boundary pixels, robustness",
     "the bounds are read as integers: their fractions are dropped", 3},
    {"one_radius", 25,
     "camera frame, width and height, pixel (0, 0), hit or miss, nearest root, nearest sphere, "
     "whole scenes, robustness",
     "", 0},
    {"sorted_once", 108, "whole scenes", "", 0},
    {"exits_where_all_is_behind", 98, "ray origin, robustness",
     "it fails only if everything that a ray's line meets is behind the ray's origin", 4},
    {"lines_for_columns", 105, "width and height",
     "the loops that write the picture are exchanged: it has a line for each column, with a "
     "value for each row; rays are traced beyond the image, too",
     2},
    {"lines_from_the_last", 105, "width and height",
     "the loops that write the picture are exchanged: it has a line for each column, with a "
     "value for each row; rays are traced beyond the image, too, from the last row on",
     2},
    {"loops_too_short", 105, "boundary pixels",
     "the loops over the pixels end too early: the bottom row and the last column are never drawn",
     3},
    {"whole_view", 95, "camera frame",
     "eye, look and up are read as integers: their fractions are dropped", 2},
    {"whole_d", 96, "whole scenes, robustness", "d is read as an integer: its fraction is dropped",
     2},
    {"least_size_wins", 98, "ray origin, robustness",
     "s >= 0 is not tested, and the least |s| wins, even if s is negative", 4},
    {"steps_of_larger", 105, "width and height", "it fails only if the picture is not square", 2},
    {"largest_multiple", 104, "robustness",
     "hits with an s above about 1e5 (the limit may be smaller), in multiples of P - E, are "
     "dropped: the largest s that counts is too small",
     1},
    {"largest_distance", 106, "robustness",
     "hits with an s above about 1e6 (the limit may be smaller) are dropped: the largest s that "
     "counts is too small",
     1},
};

/// Mistakes in pictures that make it harder to find the form of driver files that the program
/// reads.
const std::vector<Mistake> kOfForms = {
    {"axes_dropped", 0,
     "camera frame, boundary pixels, width and height, pixel (0, 0), unit directions, ray origin, "
     "hit or miss, nearest root, nearest sphere, whole scenes, robustness",
     "the picture has one colour, whatever the scene", 11},
    {"crossed_bounds", 95, "boundary pixels, robustness",
     "near is d itself, as in driver files from 2019 on, but the bounds are read in the order of "
     "2017 and 2018, or: W has the wrong sign",
     11},
    {"normalize_discarded_and_upside_down", 80, "unit directions, whole scenes, robustness",
     "directions are not normalised: D = P - E", 10},
};

/// Expects that a submission loses the points of its mistake, and that the mistake is named.
void expect_cost(const Grading& grading, const std::string& submission, const Mistake& mistake,
                 const Outcome& outcome) {
  SCOPED_TRACE(submission);
  const json result = grading.result(submission);
  expect_values(result, {{"refused", nullptr}, {"points", 100}});
  EXPECT_NEAR(result["score"].get<double>(), mistake.score, 0.005);
  std::string fails;
  for (const std::string& name : items_that(result, "fails"))
    fails += (fails.empty() ? "" : ", ") + name;
  EXPECT_EQ(fails, mistake.fails) << outcome.out;
  int named = 0;
  for (const json& one : result["items"]) {
    for (const json& explaining : one["mistakes"]) {
      named += explaining["sentence"] == mistake.sentence ? 1 : 0;
    }
    // The student gets a failing case, unless answers are only missing.
    const bool is_shown = !one["failing"].is_null() || !one["reason"].is_null();
    EXPECT_EQ(one["state"] != "holds", is_shown) << one.dump(2);
  }
  EXPECT_EQ(named, mistake.named) << result.dump(2);
  if (*mistake.sentence != '\0') {
    expect_parts(outcome.out, {mistake.sentence});
    expect_parts(grading.file(submission, "report.html"), {"<p><strong>"});
  }
}

/// Grades a class with one submission per mistake of the file by this rubric; returns the report.
std::string expect_costs(const Grading& grading, const std::string& rubric, const std::string& file,
                         const std::vector<Mistake>& mistakes,
                         std::vector<std::string> folders = {}) {
  for (const Mistake& one : mistakes) {
    folders.push_back(grading.submit_built(one.name, file, one.name));
  }
  const Outcome outcome = grading.grade(rubric, folders, "out", kLimitsOnly);
  for (const Mistake& one : mistakes) expect_cost(grading, one.name, one, outcome);
  return outcome.out;
}

TEST(GradedMistakes, in_functions_have_the_expected_cost_and_name_also_in_python) {
  const Grading grading;
  const std::string line = "MISTAKE = \"far_root\"";
  expect_costs(grading, grading.lecture7_with({}), "rays.cpp", kOfFunctions,
               {grading.submit("mine", "rays.py", line)});
  json in_python = grading.result("mine"), far_root = grading.result("far_root");
  EXPECT_EQ(in_python["score"], far_root["score"]);
  EXPECT_EQ(in_python["items"], far_root["items"]);
}

TEST(GradedMistakes, from_state_kept_between_questions_are_reported_as_such) {
  const Grading grading;
  const std::string right = contents(RAYCHECK_SOURCE_DIR "/tests/candidates/right.py");
  grading.hand_in(
      "keeps", "rays.py",
      replaced(replaced(right, "MISTAKE = globals", "least = [math.inf]\nMISTAKE = globals"),
               "return None if s < 0 else (s,",
               "if s < 0 or s > least[0]:\n        return None\n"
               "    least[0] = s\n    return (s,"));
  grading.grade(grading.write("state.toml",
                              kFormOfPython + item_of("class", "points = 10",
                                                      functions("class", "course", 8, kGivenRays))),
                {grading.path("submissions/keeps")});
  const json item = grading.result("keeps")["items"][0];
  EXPECT_EQ(item["state"], "fails") << item.dump(2);
  ASSERT_EQ(item["mistakes"].size(), 1u) << item.dump(2);
  expect_parts(item["mistakes"][0].dump(), {"the candidate keeps state between questions"});
  EXPECT_FALSE(item["first_wrong"].is_null());
}

TEST(LongGradedForms, are_found_whatever_the_mistake) {
  const Grading grading;
  const std::string said = expect_costs(grading, grading.lecture7_with({}), "rt.cpp", kOfForms);
  // With directions that are not normalised, the form of driver files cannot be found.
  expect_parts(said, {"directions are not normalised: D = P - E; and rows are upside down"});
  const std::string found = grading.result("crossed_bounds").dump();
  EXPECT_FALSE(has(found, "near has the wrong sign")) << found;
}

/// The mistakes of pictures are split into this many suites, which run in parallel.
constexpr std::size_t kParts = 3;
class GradedPictures : public testing::TestWithParam<std::size_t> {};

TEST_P(GradedPictures, have_the_expected_cost_and_name_their_mistakes) {
  const Grading grading;
  std::vector<Mistake> part;
  for (std::size_t k = GetParam(); k < kOfPictures.size(); k += kParts) {
    part.push_back(kOfPictures[k]);
  }
  // The form that the renderer reads.
  expect_costs(grading, grading.lecture7_with({{"preset = \"auto\"", "preset = \"B\""}}), "rt.cpp",
               part);
}
INSTANTIATE_TEST_SUITE_P(LongFirst, GradedPictures, testing::Values(0));
INSTANTIATE_TEST_SUITE_P(LongSecond, GradedPictures, testing::Values(1));
INSTANTIATE_TEST_SUITE_P(LongThird, GradedPictures, testing::Values(2));
static_assert(kParts == 3);

TEST(GradedMistakes, name_bounds_in_another_order_if_the_form_is_given) {
  const Grading grading;
  const std::string corners = item_of("boundary pixels", "points = 5",
                                      "[item.pictures]\njudge = \"mask\"\nscenes = "
                                      "[\"lecture7/corners.toml\", \"lecture7/edges.toml\"]\n");
  const Outcome outcome = grading.grade(grading.short_rubric("", corners),
                                        {grading.submit_built("one", "rt.cpp", "crossed_bounds")},
                                        "out", "--dialect 2019");
  expect_parts(outcome.out, {"right is taken from bottom and bottom from right"});
}

/// The names in a file's list MISTAKES.
std::set<std::string> mistakes_of(const std::string& file) {
  std::string text = contents(RAYCHECK_SOURCE_DIR "/tests/submissions/" + file);
  text = text.substr(text.find("#define MISTAKES") + 16);
  text = text.substr(0, text.find("enum class"));
  static const std::regex name("\\w+");
  std::set<std::string> names;
  for (std::sregex_iterator at(text.begin(), text.end(), name), end; at != end; ++at) {
    names.insert(at->str());
  }
  return names;
}

TEST(GradedMistakes, cover_every_mistake_of_the_submissions) {
  std::vector<Mistake> of_renderers = kOfPictures;
  of_renderers.insert(of_renderers.end(), kOfForms.begin(), kOfForms.end());
  for (const auto& [file, mistakes] :
       {std::pair("rays.cpp", &kOfFunctions), {"rt.cpp", &of_renderers}}) {
    std::set<std::string> graded = {"none"};
    for (const Mistake& mistake : *mistakes) graded.insert(mistake.name);
    EXPECT_EQ(mistakes_of(file), graded);
  }
}

using Names = std::vector<std::string>;

/// The items that submissions in floats fail by a changed lecture rubric: functions, functions with
/// the lecture's formula, which cancels, a renderer, and a renderer with this formula.
std::vector<Names> lost(const std::vector<std::pair<std::string, std::string>>& changes) {
  const Grading grading;
  std::vector<std::string> folders;
  for (const std::string file : {"single_rays.cpp", "single_rt.cpp"}) {
    for (const char* mistake : {"none", "cancelling"}) {
      folders.push_back(grading.submit_built(file + "-" + mistake, file, mistake));
    }
  }
  grading.grade(grading.lecture7_with(changes), folders, "out", kLimitsOnly);
  std::vector<Names> all;
  for (const std::string& folder : folders) {
    const json result = grading.result(fs::path(folder).filename());
    Names& names = all.emplace_back();
    int held = 0;
    for (const json& one : result["items"]) {
      held += one["state"] == "holds" ? 1 : 0;
      if (one["state"] != "holds" && one["state"] != "not asked") names.push_back(one["name"]);
    }
    EXPECT_GE(held, 9) << result.dump(2);
  }
  return all;
}

const Names kRobustness = {"robustness"};

TEST(Floats, lose_only_robustness_in_double_precision) {
  EXPECT_EQ(lost({}), (std::vector<Names>{kRobustness, kRobustness, {}, kRobustness}));
}

TEST(Floats, lose_only_what_cancels_in_single_precision) {
  EXPECT_EQ(
      lost({{"seconds = 60", "precision = \"single\"\nseconds = 60"}, {"ulp = 1e11", "ulp = 256"}}),
      (std::vector<Names>{{}, kRobustness, {}, kRobustness}));
}

TEST(Floats, meet_bounds_in_units_of_float) {
  const Grading grading;
  const auto score = [&](const std::string& precision) {
    const std::string rubric = grading.write(
        "bounds/" + precision + ".toml",
        "precision = \"" + precision + "\"\n" + kFormsOfBuilt +
            item_of("s", "points = 1", functions("parameter", "course", 40, kGivenRays)) +
            item_of("Q", "points = 1", functions("hit-point", "course", 40, kGivenRays)));
    grading.grade(rubric, {grading.submit_built(precision + "/in", "single_rays.cpp", "none")});
    return grading.result("in")["score"].get<double>();
  };
  EXPECT_EQ(score("double"), 0);
  EXPECT_EQ(score("single"), 2);
}

}  // namespace
}  // namespace raycheck::tests
