// The figures of failing cases of functions: what a student's page shows and withholds.

#include "tests/tools/grade/grading.h"

namespace raycheck::tests {
namespace {

/// Whether the item's record has a failing case that the student's page draws.
bool has_figure(const json& item) {
  return !item["failing"].is_null() && item["pictures"] == false;
}

/// A record's hexadecimal number as "%.17g", the format of pages.
std::vector<std::string> digits_of_record(const json& hexfloats) {
  std::vector<std::string> list;
  for (const json& one : hexfloats) {
    char text[64];
    std::snprintf(text, sizeof text, "%.17g", std::strtod(one.get<std::string>().c_str(), nullptr));
    list.emplace_back(text);
  }
  return list;
}

/// A panel's entry of a step for a method; null if there is no entry.
json step_of(const json& panel, const std::string& symbol, const std::string& method) {
  for (const json& step : panel["steps"]) {
    if (step["symbol"] != symbol) continue;
    for (const json& one : step["answers"]) {
      const auto names = one["names"].get<std::vector<std::string>>();
      if (std::find(names.begin(), names.end(), method) != names.end()) return one;
    }
  }
  return nullptr;
}

/// The numbers of a text whose wrong digits are marked separately.
std::vector<std::string> numbers_of(const json& said) {
  std::vector<std::string> numbers;
  bool is_within = false;
  for (const json& part : said) {
    const bool is_number = part[0] == "number" || part[0] == "mark";
    if (is_number && !is_within) numbers.emplace_back();
    if (is_number) numbers.back() += part[1].get<std::string>();
    is_within = is_number;
  }
  return numbers;
}

/// The verdict on a method's hit, or null.
json verdict_of(const json& panel, const std::string& method) {
  for (const json& one : panel["verdicts"]) {
    if (one["name"] == method && one["said"][0][0] == "symbol") return one;
  }
  return nullptr;
}

/// The panel that a page opens for a finding.
json panel_of(const json& document, const json& finding) {
  for (const json& panel : document["scenes"][finding["scene"].get<std::size_t>()]["panels"]) {
    if (panel["pixel"] == finding["pixel"] && panel["ray"] == finding["ray"] &&
        (finding["sphere"].is_null() || panel["sphere"] == finding["sphere"])) {
      return panel;
    }
  }
  return nullptr;
}

std::size_t count_of(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos; at += part.size()) {
    ++found;
  }
  return found;
}

/// A mistake of tests/submissions/rays.cpp, and an item of the seventh lecture that fails because
/// of it.
struct FigureSubject {
  const char* mistake;
  const char* item;
  bool is_a_step = true;  ///< Whether the panel has a wrong step.
};

constexpr FigureSubject kFigureSubjects[] = {
    {"axes_dropped", "camera frame"},           {"u_and_w_flipped", "camera frame"},
    {"top_from_right", "boundary pixels"},      {"mirrored", "boundary pixels"},
    {"eye_plus_point", "ray origin"},           {"far_root", "nearest root"},
    {"no_test_for_t", "nearest root"},          {"near_root_only", "robustness"},
    {"normalize_discarded", "unit directions"}, {"first_sphere_wins", "nearest sphere", false}};

/// Expects that a graded submission's page has a figure for each failing item, with the numbers of
/// the text.
void expect_figures(const Grading& grading, const FigureSubject& subject) {
  const std::string name = subject.mistake;
  SCOPED_TRACE(name);
  const json record = grading.result(name);
  const json document = grading.figures(name);
  const std::string report = grading.file(name, "report.html");
  std::size_t shown = 0;
  bool is_found = false;
  for (const json& item : record["items"]) {
    if (!has_figure(item)) continue;
    ASSERT_LT(shown, document["findings"].size());
    const json& finding = document["findings"][shown];
    const json& answer = item["failing"]["answer"];
    const json panel = panel_of(document, finding);
    EXPECT_EQ(finding["scene"], shown);
    EXPECT_EQ(finding["candidate"], "yours");
    EXPECT_TRUE(
        finding["sentence"].get<std::string>().starts_with(item["name"].get<std::string>()));
    EXPECT_EQ(document["scenes"][shown]["toml"], item["failing"]["scene"]);
    EXPECT_FALSE(panel.is_null()) << finding;
    for (const char* key : {"got", "exact"}) {
      for (const std::string& number : digits_of_record(answer[key])) {
        expect_parts(finding["sentence"], {number});
      }
    }
    ++shown;
    expect_parts(report, {"href=\"figures.html#finding-" + std::to_string(shown) + "\""});
    if (item["name"] != subject.item) continue;
    is_found = true;
    json yours = step_of(panel, answer["symbol"], "yours");
    // If the ray misses, no step is called s.
    if (yours.is_null() && answer["symbol"] == "s") yours = verdict_of(panel, "yours");
    if (subject.is_a_step) {
      ASSERT_FALSE(yours.is_null()) << answer["symbol"];
      EXPECT_EQ(numbers_of(yours["said"]), digits_of_record(answer["got"]));
    }
  }
  EXPECT_TRUE(is_found) << subject.item << " does not fail";
  EXPECT_EQ(document["findings"].size(), shown);
  EXPECT_EQ(document["scenes"].size(), shown);
  EXPECT_EQ(count_of(report, "href=\"figures.html"), shown);
  EXPECT_EQ(count_of(grading.file("", "index.html"), "href=\"" + name + "/figures.html\""), 1u);
}

/// The function items of the seventh lecture, with fewer cases.
std::string lecture_items() {
  const auto lecture = [](const char* name, const char* law, const char* source = "course",
                          const std::string& more = "") {
    return item_of(name, "points = 5", functions(law, source, 12, more));
  };
  return lecture("camera frame", "frame") + lecture("boundary pixels", "bounds") +
         lecture("unit directions", "unit-direction") + lecture("ray origin", "direction") +
         kNearestRoot + lecture("hit point", "hit-point", "course", kGivenRays) + kNearestSphere +
         item_of("robustness", "points = 5\ntolerance = { conditioning = 16 }",
                 "[item.functions]\nlaws = [\"class\"]\nsources = [\"distance@4\", \"tangency@4\", "
                 "\"direction-length@60\", \"scale@60\"]\ncases = 80\nrays = \"given\"\n");
}

class Figures : public GradingTest {};

TEST_F(Figures, show_the_same_numbers_as_the_text_and_are_reproducible) {
  const std::string rubric = grading.short_rubric("", lecture_items());
  std::vector<std::string> all;
  for (const FigureSubject& subject : kFigureSubjects) {
    all.push_back(grading.submit_built(subject.mistake, "rays.cpp", subject.mistake));
  }
  grading.grade(rubric, all);
  std::vector<std::string> before;
  for (const FigureSubject& subject : kFigureSubjects) {
    expect_figures(grading, subject);
    for (const char* file : {"figures.html", "report.html"}) {
      before.push_back(grading.file(subject.mistake, file));
      EXPECT_FALSE(before.back().empty());
      fs::remove(grading.path(std::string("out/") + subject.mistake + "/" + file));
    }
  }
  grading.grade(rubric, all);
  std::size_t k = 0;
  for (const FigureSubject& subject : kFigureSubjects) {
    for (const char* file : {"figures.html", "report.html"}) {
      EXPECT_EQ(grading.file(subject.mistake, file), before[k++]) << subject.mistake << file;
    }
  }
}

/// Grades by a rubric of these items.
Outcome graded_by(const Grading& grading, const std::string& items,
                  const std::vector<std::string>& folders, const std::string& out = "out") {
  return grading.grade(grading.short_rubric("tolerance = { ulp = 64 }\n", items), folders, out);
}

/// The only panel of a submission with this mistake, graded by a rubric with this item.
json only_panel(const Grading& grading, const std::string& item, const std::string& mistake) {
  graded_by(grading, item, {grading.submit_built("mine", "rays.cpp", mistake)});
  const json document = grading.figures("mine");
  EXPECT_EQ(document["findings"].size(), 1u);
  return panel_of(document, document["findings"][0]);
}

TEST_F(Figures, draw_a_hit_on_the_ray_that_the_submission_computed) {
  const json panel =
      only_panel(grading, item_of("hit point", "points = 1", functions("hit-point", "course", 4)),
                 "float_directions");
  const json failing = item(grading.result("mine"), "hit point")["failing"];
  ASSERT_FALSE(failing.is_null());
  EXPECT_EQ(failing["step"], "direction");
  const json yours = step_of(panel, "Q", "yours");
  EXPECT_EQ(numbers_of(yours["said"]), digits_of_record(failing["answer"]["got"]));
  expect_parts(panel["text"],
               {"(yours: on the ray that it makes)", "goes wrong at D (of the ray that it makes)"});
}

TEST_F(Figures, apply_the_tolerance_of_the_item) {
  // Directions in floats are within this item's tolerance; only the root of hits is wrong.
  const json panel = only_panel(grading,
                                item_of("root", "points = 1\ntolerance = { ulp = 1e11 }",
                                        functions("nearest-root", "course-behind", 4)),
                                "far_root");
  for (const json& verdict : panel["verdicts"]) {
    if (verdict["name"] != "yours") continue;
    const bool is_of_hit = verdict == verdict_of(panel, "yours");
    EXPECT_EQ(verdict["wrong"], is_of_hit) << verdict;
    if (is_of_hit) {
      EXPECT_EQ(verdict["said"].back(), json::array({"symbol", "s"}));
    }
  }
  EXPECT_FALSE(verdict_of(panel, "yours").is_null());
}

/// A submission whose s is too large because of an unknown mistake, so that no item follows from
/// another.
std::string beside(const Grading& grading, const std::string& name) {
  const std::string end = "    return None if s < 0 else";
  const std::string text = replaced(contents(RAYCHECK_SOURCE_DIR "/tests/candidates/right.py"), end,
                                    "    s *= 1.0000003\n" + end);
  return grading.hand_in(name, "rays.py", text);
}

TEST_F(Figures, do_not_reveal_by_their_size_whether_a_hidden_item_fails) {
  // Neither the page nor its size nor a link reveals whether a hidden item fails.
  const std::string visible =
      item_of("open", "points = 1", functions("parameter", "course", 4, kGivenRays));
  const std::string hidden = "visibility = \"hidden\"";
  const auto graded = [&](const std::string& items, const std::string& out) {
    graded_by(grading, items, {beside(grading, "mine")}, out);
    return grading.file("mine", "figures.html", out);
  };
  const std::string failing =
      graded(visible + item_of("covert", "points = 1\n" + hidden,
                               functions("parameter", "distance@5", 4, kGivenRays)),
             "fails");
  const std::string holding = graded(visible + item_of("covert", "points = 1\n" + hidden,
                                                       functions("class", "course", 4, kGivenRays)),
                                     "holds");
  EXPECT_EQ(item(grading.result("mine", "fails"), "covert")["state"], "fails");
  EXPECT_EQ(item(grading.result("mine", "holds"), "covert")["state"], "holds");
  EXPECT_FALSE(failing.empty());
  EXPECT_EQ(failing, holding);
  EXPECT_EQ(graded(item_of("covert", "points = 1\n" + hidden,
                           functions("parameter", "distance@5", 4, kGivenRays)),
                   "alone"),
            "");
  EXPECT_FALSE(fs::exists(grading.path("out/alone/mine/figures.html")));
  EXPECT_FALSE(has(grading.file("mine", "report.html", "alone"), "figures.html"));
  EXPECT_FALSE(has(grading.file("", "index.html", "alone"), "figures.html"));
}

TEST_F(Figures, show_answers_that_are_not_finite_and_how_a_program_failed) {
  const std::string item =
      item_of("root", "points = 1", functions("parameter", "course", 4, kGivenRays));
  const std::string import = "import math, raycheck_candidate as rc\n";
  const std::vector<std::string> folders = {
      grading.hand_in("odd", "rays.py",
                      import + "rc.run('odd', intersect=lambda ray, sphere, asked: (math.nan, "
                               "(math.inf, -math.inf, 0.0)))\n"),
      grading.hand_in("dies", "rays.py",
                      import + "def intersect(ray, sphere, asked):\n"
                               "    raise ValueError('</script><b>no')\n"
                               "rc.run('dies', intersect=intersect)\n")};
  graded_by(grading, item, folders);
  const std::string page = grading.file("odd", "figures.html");
  EXPECT_FALSE(page.empty());
  graded_by(grading, item, folders);
  EXPECT_EQ(grading.file("odd", "figures.html"), page);
  const json document = grading.figures("dies");
  ASSERT_EQ(document["findings"].size(), 1u);
  expect_parts(document["findings"][0]["sentence"], {"</script><b>no"});
  EXPECT_EQ(document["findings"][0]["method"], "") << "no step has an answer of it";
  EXPECT_FALSE(has(grading.file("dies", "report.html"), "<b>no"));
}

TEST_F(Figures, escape_hostile_names) {
  const std::string name = "<b>x&\"' #?";
  graded_by(grading,
            item_of("<img src=x onerror=alert(1)> & \\\"'", "points = 1",
                    functions("nearest-root", "course-behind", 4, kGivenRays)),
            {grading.submit_built(name, "rays.cpp", "far_root"),
             grading.submit_built("plain", "rays.cpp", "far_root")});
  const std::string page = grading.file(name, "figures.html");
  const std::string plain = grading.file("plain", "figures.html");
  for (const char* tag : {"<script", "<b>", "<img src=x"}) {
    EXPECT_EQ(count_of(page, tag), count_of(plain, tag)) << tag;
  }
  EXPECT_FALSE(has(grading.file(name, "report.html"), "<img"));
  expect_parts(page, {"<title>A rubric: &lt;b&gt;x&amp;&quot;"});
  expect_parts(grading.file("", "index.html"),
               {"href=\"%3Cb%3Ex%26%22%27%20%23%3F/figures.html\""});
  const json document = grading.figures(name);
  expect_parts(document["title"], {name});
  expect_parts(document["findings"][0]["sentence"], {"<img src=x onerror=alert(1)>"});
}

TEST_F(Figures, are_only_for_functions_and_are_removed_when_the_mistake_is_corrected) {
  const std::string drawn = grading.submit_built("drawn", "rt.cpp", "mirrored");
  const std::string mine = grading.submit_built("mine", "rays.cpp", "mirrored");
  graded_by(grading, kPixelZeroZero, {drawn, mine});
  EXPECT_FALSE(item(grading.result("drawn"), "pixel (0, 0)")["failing"].is_null());
  EXPECT_EQ(grading.file("drawn", "figures.html"), "") << "renderers have pictures";
  EXPECT_FALSE(has(grading.file("drawn", "report.html"), "figures.html"));
  EXPECT_FALSE(grading.file("mine", "figures.html").empty());
  fs::remove_all(mine);
  grading.submit_built("mine", "rays.cpp", "none");
  graded_by(grading, kPixelZeroZero, {drawn, mine});
  EXPECT_FALSE(fs::exists(grading.path("out/mine/figures.html")));
  EXPECT_FALSE(has(grading.file("", "index.html"), "figures.html"));
}

}  // namespace
}  // namespace raycheck::tests
