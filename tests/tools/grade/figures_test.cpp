// The figures of failing cases of functions: what a student's page of them has, and what is not in
// it.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <regex>
#include <string>
#include <vector>

#include "tests/tools/grade/grading.h"

namespace raycheck::tests {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// Whether the item's record has a case that its student is shown in a figure.
bool has_figure(const json& item) {
  return !item["failing"].is_null() && item["pictures"] == false;
}

/// "%.17g", as pages have numbers, of a record's hexadecimal ones.
std::vector<std::string> digits_of_record(const json& hexfloats) {
  std::vector<std::string> list;
  for (const json& one : hexfloats) {
    char text[64];
    std::snprintf(text, sizeof text, "%.17g", std::strtod(one.get<std::string>().c_str(), nullptr));
    list.emplace_back(text);
  }
  return list;
}

/// What a panel has of a step for a method; null where it has none.
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

/// The numbers of what is said, whose wrong digits are apart.
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

/// The verdict on a method's hit; null where it has none.
json verdict_of(const json& panel, const std::string& method) {
  for (const json& one : panel["verdicts"]) {
    if (one["name"] == method && one["said"][0][0] == "symbol") return one;
  }
  return nullptr;
}

/// The panel that a page opens at a finding.
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

/// A mistake of tests/submissions/rays.cpp, and an item of the seventh lecture that fails by it.
struct FigureSubject {
  const char* mistake;
  const char* item;
  bool is_a_step = true;  ///< What is wrong is a step of the panel.
};

constexpr FigureSubject kFigureSubjects[] = {
    {"axes_dropped", "camera frame"},           {"u_and_w_flipped", "camera frame"},
    {"top_from_right", "boundary pixels"},      {"mirrored", "boundary pixels"},
    {"eye_plus_point", "ray origin"},           {"far_root", "nearest root"},
    {"no_test_for_t", "nearest root"},          {"near_root_only", "robustness"},
    {"normalize_discarded", "unit directions"}, {"first_sphere_wins", "nearest sphere", false}};

/// A graded submission's page has a figure of each of its failing items, with the numbers of the
/// text.
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
        EXPECT_TRUE(contains(finding["sentence"], number)) << key << " " << number << finding;
      }
    }
    ++shown;
    EXPECT_TRUE(contains(report, "href=\"figures.html#finding-" + std::to_string(shown) + "\""));
    if (item["name"] != subject.item) continue;
    is_found = true;
    json yours = step_of(panel, answer["symbol"], "yours");
    // Where the ray misses, no step is called s.
    if (yours.is_null() && answer["symbol"] == "s") yours = verdict_of(panel, "yours");
    if (subject.is_a_step) {
      ASSERT_FALSE(yours.is_null()) << answer["symbol"];
      EXPECT_EQ(numbers_of(yours["said"]), digits_of_record(answer["got"]));
    }
    const std::string part = report.substr(report.find(">" + std::string(subject.item) + "<"));
    EXPECT_TRUE(contains(part.substr(0, part.find("#finding-")), "<figure class=\"drawing\">"));
  }
  EXPECT_TRUE(is_found) << subject.item << " does not fail";
  EXPECT_EQ(document["findings"].size(), shown);
  EXPECT_EQ(document["scenes"].size(), shown);
  EXPECT_EQ(count_of(report, "href=\"figures.html"), shown);
  EXPECT_EQ(count_of(grading.file("", "index.html"), "href=\"" + name + "/figures.html\""), 1u);
}

TEST(Figures, have_the_numbers_of_their_items_text_and_are_made_again_from_the_record) {
  const Grading grading;
  const std::string rubric = grading.lecture7_with({});
  std::vector<std::string> all;
  for (const FigureSubject& subject : kFigureSubjects) {
    all.push_back(grading.submit_built(subject.mistake, "rays.cpp", subject.mistake));
  }
  EXPECT_EQ(grading.grade(rubric, all).exit_code, 0);
  std::vector<std::string> before;
  for (const FigureSubject& subject : kFigureSubjects) {
    expect_figures(grading, subject);
    for (const char* file : {"figures.html", "report.html"}) {
      before.push_back(grading.file(subject.mistake, file));
      EXPECT_FALSE(before.back().empty());
      fs::remove(grading.path(std::string("out/") + subject.mistake + "/" + file));
    }
  }
  // Without the store of answers nothing could be known of them but by running them.
  fs::remove_all(grading.path("out/.raycheck"));
  const Outcome again = grading.grade(rubric, all);
  EXPECT_TRUE(contains(again.out, "10 submissions graded, 10 of them by an earlier run"))
      << again.out;
  std::size_t k = 0;
  for (const FigureSubject& subject : kFigureSubjects) {
    for (const char* file : {"figures.html", "report.html"}) {
      EXPECT_EQ(grading.file(subject.mistake, file), before[k++]) << subject.mistake << file;
    }
  }
}

/// A rubric of one law for each item, of rays.py.
std::string rubric_toml(const std::string& items) {
  return "title = \"A rubric\"\n[conventions]\nsamples = \"edges\"\norigin = \"pixel\"\n"
         "[tolerance]\nulp = 64\n"
         "[[form]]\nhas = \"rays.py\"\ncandidate = \"command:python3 {file}\"\n" +
         items;
}

std::string item_toml(const std::string& name, const std::string& keys, const std::string& law,
                      const std::string& source, const std::string& more = "") {
  return "[[item]]\nname = \"" + name + "\"\npoints = 1\n" + keys +
         "\n[item.functions]\nlaws = [\"" + law + "\"]\nsources = [\"" + source +
         "\"]\ncases = 4\n" + more;
}

constexpr const char* kGivenRays = "rays = \"given\"\n";

TEST(Figures, follow_a_hit_along_the_ray_that_the_submission_made_itself) {
  const Grading grading;
  const std::string rubric =
      grading.write("rubric.toml", rubric_toml(item_toml("hit point", "", "hit-point", "course")));
  const std::string folder =
      grading.submit("mine", "rays.py", mistake_line("rays.py", "float_directions"));
  EXPECT_EQ(grading.grade(rubric, {folder}).exit_code, 0);
  const json failing = item(grading.result("mine"), "hit point")["failing"];
  ASSERT_FALSE(failing.is_null());
  EXPECT_EQ(failing["step"], "direction");
  const json document = grading.figures("mine");
  ASSERT_EQ(document["findings"].size(), 1u);
  const json panel = panel_of(document, document["findings"][0]);
  const json yours = step_of(panel, "Q", "yours");
  EXPECT_EQ(numbers_of(yours["said"]), digits_of_record(failing["answer"]["got"]));
  EXPECT_TRUE(contains(panel["text"], "(yours: for the ray that it makes itself)"));
  EXPECT_TRUE(contains(panel["text"], "goes wrong at D (its own ray)")) << panel["text"];
  EXPECT_TRUE(
      contains(grading.file("mine", "report.html"), "aria-label=\"Magnified around the exact hit"));
}

TEST(Figures, hold_a_submission_to_what_its_item_tolerates) {
  // Directions in floats are right to this item, and its hits go wrong at their root alone.
  const Grading grading;
  const std::string rubric =
      grading.write("rubric.toml", rubric_toml(item_toml("root", "tolerance = { ulp = 1e11 }",
                                                         "nearest-root", "course-behind")));
  const std::string line = mistake_line("rays.py", "far_root");
  EXPECT_EQ(grading.grade(rubric, {grading.submit("mine", "rays.py", line)}).exit_code, 0);
  const json document = grading.figures("mine");
  ASSERT_EQ(document["findings"].size(), 1u);
  const json panel = panel_of(document, document["findings"][0]);
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

/// A submission whose s is too large, by a mistake that nobody has a name for: no item follows from
/// another.
std::string beside(const Grading& grading, const std::string& name) {
  grading.write("submissions/" + name + "/rays.py", R"py(import math, raycheck_candidate as rc
def intersect(ray, sphere, asked):
    (o, d), (c, r) = ray, sphere
    t = [a - b for a, b in zip(c, o)]
    dd, v = sum(x * x for x in d), sum(x * y for x, y in zip(t, d))
    m = [t[1] * d[2] - t[2] * d[1], t[2] * d[0] - t[0] * d[2], t[0] * d[1] - t[1] * d[0]]
    rest = dd * r * r - sum(x * x for x in m)
    if rest < 0 or v + math.sqrt(rest) < 0:
        return None
    s = (v - math.sqrt(rest) if v >= math.sqrt(rest) else v + math.sqrt(rest)) / dd * 1.0000003
    return s, tuple(a + s * b for a, b in zip(o, d))
rc.run("beside", intersect=intersect)
)py");
  return grading.path("submissions/" + name);
}

/// The numbers of a scene that no other has.
std::vector<std::string> long_numbers(const std::string& toml) {
  static const std::regex number(R"([0-9]*\.?[0-9]+(e[-+]?[0-9]+)?)");
  std::vector<std::string> found;
  for (std::sregex_iterator at(toml.begin(), toml.end(), number), end; at != end; ++at) {
    if (at->str().size() >= 8) found.push_back(at->str());
  }
  return found;
}

TEST(Figures, have_nothing_of_items_that_are_hidden_or_thinned) {
  const Grading grading;
  std::string items = item_toml("open", "", "parameter", "distance@5", kGivenRays);
  const std::vector<std::pair<std::string, std::string>> others = {
      {"covert", "visibility = \"hidden\""},
      {"covert thin", "visibility = \"hidden\"\ndetail = \"actual-only\""},
      {"late", "visibility = \"after_due_date\""},
      {"later", "visibility = \"after_published\""},
      {"thin", "detail = \"actual-only\""},
      {"thinner", "detail = \"nothing\""}};
  for (const auto& [name, keys] : others) {
    items += item_toml(name, keys, "parameter", "distance@5", kGivenRays);
  }
  const std::string folder = beside(grading, "mine");
  for (const char* format : {"gradescope", "prairielearn"}) {
    const std::string out = std::string("out-") + format;
    EXPECT_EQ(grading
                  .grade(grading.write("rubric.toml", rubric_toml(items)), {folder}, out,
                         std::string("--format ") + format)
                  .exit_code,
              0);
    const json record = grading.result("mine", out);
    const json document = grading.figures("mine", out);
    ASSERT_EQ(document["findings"].size(), 1u);
    ASSERT_EQ(document["scenes"].size(), 1u);
    EXPECT_TRUE(contains(document["findings"][0]["sentence"], "open: "));
    const std::string text = document.dump();
    const std::string report = grading.file("mine", "report.html", out);
    EXPECT_EQ(count_of(report, "figures.html"), 1u);
    EXPECT_EQ(count_of(report, "class=\"drawing\""), 1u);
    EXPECT_FALSE(contains(grading.file("mine", "results.json", out), "figures.html"));
    const std::vector<std::string> open = long_numbers(item(record, "open")["failing"]["scene"]);
    EXPECT_FALSE(open.empty());
    for (const std::string& number : open) EXPECT_TRUE(contains(text, number)) << number;
    for (const auto& [name, keys] : others) {
      EXPECT_FALSE(contains(text, name + ":")) << name;
      EXPECT_FALSE(contains(text, name + ".toml")) << name;
      const json failing = item(record, name)["failing"];
      ASSERT_FALSE(failing.is_null()) << name << " is to fail";
      EXPECT_FALSE(failing["answers"].is_null()) << "instructors have them";
      std::size_t told = 0;
      for (const std::string& number : long_numbers(failing["scene"])) {
        told += std::find(open.begin(), open.end(), number) == open.end() ? 1 : 0;
        if (std::find(open.begin(), open.end(), number) != open.end()) continue;
        EXPECT_FALSE(contains(text, number)) << number << " of " << name;
      }
      EXPECT_GT(told, 0u) << name << " has numbers of its own";
    }
  }
}

TEST(Figures, are_as_large_whatever_fails_that_is_hidden) {
  // Neither the page, its size, nor a link tells whether a hidden item fails.
  const Grading grading;
  const std::string visible = item_toml("open", "", "parameter", "course", kGivenRays);
  const std::string hidden = "visibility = \"hidden\"";
  const auto graded = [&](const std::string& items, const std::string& out) {
    const std::string folder = beside(grading, "mine");
    EXPECT_EQ(
        grading.grade(grading.write("rubric.toml", rubric_toml(items)), {folder}, out).exit_code,
        0);
    return grading.file("mine", "figures.html", out);
  };
  const std::string failing =
      graded(visible + item_toml("covert", hidden, "parameter", "distance@5", kGivenRays), "fails");
  const std::string holding =
      graded(visible + item_toml("covert", hidden, "class", "course", kGivenRays), "holds");
  EXPECT_EQ(item(grading.result("mine", "fails"), "covert")["state"], "fails");
  EXPECT_EQ(item(grading.result("mine", "holds"), "covert")["state"], "holds");
  EXPECT_FALSE(failing.empty());
  EXPECT_EQ(failing, holding);
  EXPECT_EQ(graded(item_toml("covert", hidden, "parameter", "distance@5", kGivenRays), "alone"),
            "");
  EXPECT_FALSE(fs::exists(grading.path("out/alone/mine/figures.html")));
  EXPECT_FALSE(contains(grading.file("mine", "report.html", "alone"), "figures.html"));
  EXPECT_FALSE(contains(grading.file("", "index.html", "alone"), "figures.html"));
}

TEST(Figures, of_answers_that_are_no_numbers_are_kept_too) {
  const Grading grading;
  const std::string rubric = grading.write(
      "rubric.toml", rubric_toml(item_toml("root", "", "parameter", "course", kGivenRays)));
  const std::string wrong =
      "import math, raycheck_candidate as rc\n"
      "rc.run('odd', intersect=lambda ray, sphere, asked: (math.nan, (math.inf, -math.inf, "
      "0.0)))\n";
  grading.write("submissions/odd/rays.py", wrong);
  const std::string folder = grading.path("submissions/odd");
  EXPECT_EQ(grading.grade(rubric, {folder}).exit_code, 0);
  const std::string page = grading.file("odd", "figures.html");
  EXPECT_FALSE(page.empty());
  EXPECT_TRUE(contains(grading.grade(rubric, {folder}).out, "1 of them by an earlier run"));
  EXPECT_EQ(grading.file("odd", "figures.html"), page);
}

TEST(Figures, of_a_program_that_fails_say_how) {
  const Grading grading;
  const std::string rubric = grading.write(
      "rubric.toml", rubric_toml(item_toml("root", "", "parameter", "course", kGivenRays)));
  grading.write("submissions/dies/rays.py",
                "import raycheck_candidate as rc\n"
                "def intersect(ray, sphere, asked):\n"
                "    raise ValueError('</script><b>no')\n"
                "rc.run('dies', intersect=intersect)\n");
  EXPECT_EQ(grading.grade(rubric, {grading.path("submissions/dies")}).exit_code, 0);
  const json document = grading.figures("dies");
  ASSERT_EQ(document["findings"].size(), 1u);
  EXPECT_TRUE(contains(document["findings"][0]["sentence"], "</script><b>no"));
  EXPECT_EQ(document["findings"][0]["method"], "") << "no step has an answer of it";
  EXPECT_FALSE(contains(grading.file("dies", "report.html"), "<b>no"));
}

TEST(Figures, have_hostile_names_as_text) {
  const Grading grading;
  const std::string rubric = grading.write(
      "rubric.toml", rubric_toml(item_toml("<img src=x onerror=alert(1)> & \\\"'", "",
                                           "nearest-root", "course-behind", kGivenRays)));
  const std::string line = mistake_line("rays.py", "far_root");
  const std::string name = "<b>x&\"' #?";
  EXPECT_EQ(grading
                .grade(rubric, {grading.submit(name, "rays.py", line),
                                grading.submit("plain", "rays.py", line)})
                .exit_code,
            0);
  const std::string page = grading.file(name, "figures.html");
  const std::string plain = grading.file("plain", "figures.html");
  EXPECT_EQ(count_of(page, "<script"), count_of(plain, "<script"));
  EXPECT_EQ(count_of(page, "<b>"), count_of(plain, "<b>"));
  EXPECT_FALSE(contains(page, "<img src=x"));
  EXPECT_TRUE(contains(page, "<title>A rubric: &lt;b&gt;x&amp;&quot;&#39; #?</title>") ||
              contains(page, "<title>A rubric: &lt;b&gt;x&amp;&quot;' #?</title>"));
  EXPECT_FALSE(contains(grading.file(name, "report.html"), "<img"));
  EXPECT_TRUE(
      contains(grading.file("", "index.html"), "href=\"%3Cb%3Ex%26%22%27%20%23%3F/figures.html\""));
  const json document = grading.figures(name);
  EXPECT_TRUE(contains(document["title"], name));
  EXPECT_TRUE(contains(document["findings"][0]["sentence"], "<img src=x onerror=alert(1)>"));
}

TEST(Figures, are_of_functions_alone_and_go_when_what_was_wrong_is_mended) {
  const Grading grading;
  const std::string rubric = grading.lecture7_with({});
  const std::string drawn = grading.submit_built("drawn", "rt.cpp", "mirrored");
  const std::string mine = grading.submit_built("mine", "rays.cpp", "far_root");
  EXPECT_EQ(grading.grade(rubric, {drawn, mine}).exit_code, 0);
  EXPECT_FALSE(item(grading.result("drawn"), "pixel (0, 0)")["failing"].is_null());
  EXPECT_EQ(grading.file("drawn", "figures.html"), "") << "renderers have pictures";
  EXPECT_FALSE(contains(grading.file("drawn", "report.html"), "figures.html"));
  EXPECT_FALSE(grading.file("mine", "figures.html").empty());
  fs::remove_all(mine);
  grading.submit_built("mine", "rays.cpp", "none");
  EXPECT_EQ(grading.grade(rubric, {drawn, mine}).exit_code, 0);
  EXPECT_FALSE(fs::exists(grading.path("out/mine/figures.html")));
  EXPECT_FALSE(contains(grading.file("", "index.html"), "figures.html"));
}

}  // namespace
}  // namespace raycheck::tests
