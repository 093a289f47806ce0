#include <fmt/core.h>

#include "tests/tools/external/judged.h"

namespace raycheck::tests {
namespace {

json document_of(const std::string& arguments) { return printed_json("view " + arguments, 0); }

json panel_of(const json& scene, int i, int j) {
  return found(scene["panels"], "pixel", json{i, j});
}

/// The figure of a camera of 3 x 3 pixels that looks along -z, and of these spheres; all lengths
/// times `scale`.
json figure_of(double scale, const std::string& spheres) {
  const std::string file = temporary_file("scaled.toml", camera_text(3, 3, scale, scale) + spheres);
  return document_of(file + " --method cross")["scenes"][0]["figure"];
}

/// The panel of a ray and a sphere.
json panel_of_given(const std::string& origin, const std::string& direction,
                    const std::string& centre, const std::string& radius) {
  const std::string file =
      temporary_file("view.toml", ray_text(origin, direction) + sphere_text(centre, radius));
  return document_of(file)["scenes"][0]["panels"][0];
}

void expect_has_the_very_text_of_explain(const json& scene) {
  for (const auto& [i, j] : {std::pair(1, 1), std::pair(3, 3), std::pair(5, 5)}) {
    const json panel = panel_of(scene, i, j);
    const std::string command = panel["command"];
    const std::string word = "raycheck ";
    ASSERT_EQ(command.rfind(word, 0), 0u);
    const Outcome explained = run(command.substr(word.size()));
    EXPECT_EQ(panel["text"], explained.out) << command;
  }
}

TEST(View, draws_relative_to_the_eye_whatever_the_size_of_the_world) {
  for (const double scale : {0x1p-1000, 0x1p+531}) {
    const std::string sphere =
        sphere_text(fmt::format("{}, 0, {}", scale, -3 * scale), fmt::format("{}", scale));
    const json figure = figure_of(scale, sphere);
    EXPECT_EQ(figure["scale_exponent"], -std::ilogb(scale));
    expect_values(figure, {{"spheres/centre/0", json{1.0, 0.0, -3.0}},
                           {"spheres/radius/0", 1.0},
                           {"camera/near", -1.0}});
  }
}

TEST(View, subtracts_the_eye_exactly_and_names_roots) {
  const json far = panel_of_given("4503599627370496.5, 0, 0", "1, 0, 0", "4503599627370498.5, 0, 0",
                                  "1")["drawing"];
  EXPECT_EQ(far["names"]["near root"], "near root, s = 1, the answer");
  EXPECT_EQ(far["names"]["far root"], "far root, s = 3");
  EXPECT_EQ(far["places"]["answer"], far["places"]["near root"]);
  const json panel = panel_of_given("0, 0, 0", "2, 0, 0", "-6, 0, 0", "2");
  const json& behind = panel["drawing"];
  EXPECT_EQ(behind["names"]["near root"], "near root, s = -4, does not count");
  EXPECT_EQ(behind["names"]["far root"], "far root, s = -2, does not count");
  EXPECT_FALSE(behind["places"].contains("answer"));
  EXPECT_EQ(behind["places"]["behind"], behind["places"]["near root"]);
  EXPECT_FALSE(panel["microscope"]["hit"].get<bool>());
  // There is one root, at (1, 0, 0) from the ray's origin, in a figure whose lengths are the
  // scene's.
  const json touches = panel_of_given("0, 1, 0", "1, 0, 0", "1, 0, 0", "1")["drawing"];
  expect_values(touches, {{"names", json{{"double root", "double root, s = 1, the answer"}}},
                          {"places/double root", json{1, 0, 0}},
                          {"across", json{0, -1, 0}}});
}

/// The camera is at the origin, with near = -1; the lines between these places are the frustum.
TEST(View, the_frustum_has_its_corners_and_its_names) {
  const std::string sphere = sphere_text("0, 0, -3", "1");
  const json document =
      document_of(temporary_file("frustum.toml", camera_text(3, 3) + sphere) + " --method cross");
  const json& figure = document["scenes"][0]["figure"];
  expect_values(figure["places"], {{"E", json{0, 0, 0}},
                                   {"A", json{0, 0, -1}},
                                   {"near 0", json{-1, -1, -1}},
                                   {"near 2", json{1, 1, -1}},
                                   {"plane 2", json{1.5, 1.5, -1}}});
  EXPECT_EQ(figure["places"]["pixel (0, 0)"], figure["places"]["near 0"]);
  EXPECT_FALSE(figure["places"].contains("far 0"));
  expect_values(figure, {{"reach", 4}, {"notes", json::array()}});
  std::string names;
  for (const json& name : document["parts"]["names"])
    names += name["text"].get<std::string>() + ";";
  for (const char* part : {"eye E", "focal point", "W (view-plane normal);", "U;", "V;",
                           "near clipping plane;", "far clipping plane;", "view plane;",
                           "bounded image plane;", "look-at point A;", "up vector;"}) {
    EXPECT_TRUE(has(names, part));
  }
}

/// Three samples across from -1 to 1: at edges a cell has the size 1, of centres and corners 2/3.
TEST(View, the_picture_has_a_whole_cell_around_every_sample) {
  const auto camera_of = [](const std::string& conventions) -> json {
    return figure_of(1, conventions)["camera"];
  };
  const json edges = camera_of("");
  expect_values(edges, {{"window", json{-1.5, 1.5, -1.5, 1.5}},
                        {"first", json{-1, -1, -1}},
                        {"column", json{1, 0, 0}},
                        {"row", json{0, 1, 0}}});
  const json centres =
      camera_of("[conventions]\nsamples = \"centres\"\nrows = \"top-first\"\nt_max = 5\n");
  EXPECT_EQ(centres["window"], (json{-1, 1, -1, 1}));
  EXPECT_NEAR(centres["first"][0].get<double>(), -2.0 / 3, 1e-15);
  EXPECT_NEAR(centres["first"][1].get<double>(), 2.0 / 3, 1e-15);
  EXPECT_NEAR(centres["column"][0].get<double>(), 2.0 / 3, 1e-15);
  EXPECT_NEAR(centres["row"][1].get<double>(), -2.0 / 3, 1e-15);
  EXPECT_EQ(centres["counts"]["to"], 5);
  const json corners = camera_of("[conventions]\nsamples = \"corners\"\nrows = \"top-first\"\n");
  EXPECT_NEAR(corners["first"][0].get<double>(), -1, 1e-15);
  EXPECT_NEAR(corners["first"][1].get<double>(), 1, 1e-15);
  EXPECT_NEAR(corners["row"][1].get<double>(), -2.0 / 3, 1e-15);
  const double window[] = {-4.0 / 3, 2.0 / 3, -2.0 / 3, 4.0 / 3};
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_NEAR(corners["window"][k].get<double>(), window[k], 1e-15);
  }
}

TEST(View, reports_what_cannot_be_drawn_to_scale) {
  const std::string spheres = sphere_text("0, 0, -3", "1") + sphere_text("0, 0, -1e8", "1") +
                              sphere_text("0, 0, 0", "1.5") + sphere_text("0, 0, -2", "1e-300");
  const json figure = figure_of(1, spheres);
  EXPECT_EQ(figure["apart"], (json{1, 2}));
  std::string notes;
  for (const json& note : figure["notes"]) notes += note.get<std::string>() + "\n";
  EXPECT_EQ(notes,
            "Sphere 1 reaches too far for a view of the whole; look around the sphere.\n"
            "Sphere 2 surrounds the eye; from outside only the far half is drawn.\n"
            "Sphere 3 is too small, so far from the origin, to be drawn.\n");
  EXPECT_FALSE(figure["out_of_scale"].get<bool>());
}

json step_of(const json& panel, const std::string& symbol) {
  return found(panel["steps"], "symbol", symbol);
}

void expect_the_microscope_s_grid_is_of_doubles(const json& scene) {
  const json grid = panel_of(scene, 3, 3)["microscope"]["grid"];
  ASSERT_EQ(grid.size(), 17u);
  for (std::size_t k = 1; k < grid.size(); ++k) {
    EXPECT_NEAR(number(grid[k]) - number(grid[k - 1]), 1, 1e-4);
  }
  EXPECT_LE(std::abs(number(grid[8])), 0.5);
}

/// A sphere of some ulp of s: the window holds all of it.
TEST(View, the_microscope_s_curve_is_the_circle) {
  const json microscope = panel_of_given("0, 0, 0", "1, 0, 0", "1, 2.220446049250313e-16, 0",
                                         "5.551115123125783e-16")["microscope"];
  const json& zoom = microscope["zooms"].back();
  // s = 1 - 1.5 ulp(1) or so lies below 1, where an ulp is 2^-53: r = 5 of them, centre 2 beside.
  const double r = 5, y = 2, x = std::sqrt(r * r - y * y);
  ASSERT_GE(zoom["curve"].size(), 20u);
  for (const json& point : zoom["curve"]) {
    EXPECT_NEAR(std::hypot(number(point[0]) - x, number(point[1]) - y), r, 1e-4) << point;
  }
}

void expect_which_digits_are_right(const json& scene) {
  const json answers = step_of(panel_of(scene, 3, 3), "s")["answers"];
  ASSERT_EQ(answers.size(), 1u);
  // 99999999 for 99999998.0167...: eight digits, of which the last is wrong.
  EXPECT_EQ(answers[0]["said"], json::parse(R"([["number", "9999999"], ["mark", "9"]])"));
}

/// Methods that agree in value, error and standing are listed together; every method is listed.
void expect_methods_that_agree_share_an_answer(const json& scene) {
  std::size_t shared = 0, names = 0;
  for (const json& panel : scene["panels"]) {
    for (const json& step : panel["steps"]) {
      std::set<std::string> contents;
      for (json answer : step["answers"]) {
        names += answer["names"].size();
        if (answer["names"].size() > 1) ++shared;
        answer.erase("names");
        EXPECT_TRUE(contents.insert(answer.dump()).second) << answer;
      }
    }
  }
  EXPECT_GT(shared, 300u);
  EXPECT_GT(names, 2000u);
}

void expect_panels_show_the_methods_that_were_asked_for(const json& all, const json& some) {
  const auto names_in = [](const json& panel) {
    std::set<std::string> names;
    for (const json& verdict : panel["verdicts"]) names.insert(verdict["name"]);
    for (const json& step : panel["steps"]) {
      for (const json& answer : step["answers"]) {
        for (const json& one : answer["names"]) names.insert(one);
      }
    }
    for (const json& mark : panel["microscope"]["marks"]) names.insert(mark["name"]);
    return names;
  };
  EXPECT_EQ(names_in(panel_of(some, 3, 3)), (std::set<std::string>{"direct", "quadratic"}));
  EXPECT_GT(names_in(panel_of(all, 3, 3)).size(), 13u);
}

void expect_how_many_discrepancies_there_are(const json& document, const json& checked) {
  const std::uint64_t total = checked["candidates"][0]["discrepancies"];
  const std::string worst = document["worst"];
  EXPECT_TRUE(has(worst, fmt::format("the worst of {} discrepancies here; {} places", total,
                                     document["findings"].size())));
}

TEST(View, explains_s_if_a_direction_is_not_a_unit_vector) {
  const auto said = [](const std::string& direction) {
    const json panel = panel_of_given("-5, 0, 0", direction, "0, 0, 0", "1");
    return panel["exact"]["said"].dump() + panel["microscope"]["sentences"][0].dump();
  };
  EXPECT_FALSE(has(said("1, 0, 0"), "direction"));
  EXPECT_TRUE(has(said("0.5, 0, 0"), "8 times the ray's direction, which is 0.5 long"));
}

void expect_the_microscope_of_a_miss_says_why_it_is_wide(const json& scene) {
  const json microscope = panel_of(scene, 1, 1)["microscope"];
  double nearest = HUGE_VAL;
  for (const json& mark : microscope["marks"]) {
    nearest = std::min(nearest, std::max(std::abs(number(mark["x"])), std::abs(number(mark["y"]))));
  }
  ASSERT_LT(nearest, HUGE_VAL);
  const std::string sentence = microscope["sentences"][1];
  EXPECT_TRUE(has(sentence, fmt::format("claims is {:.3g} ulp away", nearest)));
}

std::uint64_t pixels_of(const json& picture, const std::string& text) {
  std::uint64_t pixels = 0;
  for (const json& entry : picture["legend"]) {
    if (entry["text"].get<std::string>().find(text) == 0) pixels += entry["pixels"].get<int>();
  }
  return pixels;
}

void expect_pictures_count_what_they_show(const json& scene, const json& checked) {
  const json& pictures = scene["pictures"];
  ASSERT_EQ(pictures.size(), 3u);
  std::uint64_t pixels = 0;
  for (const json& entry : pictures[0]["legend"]) pixels += entry["pixels"].get<std::uint64_t>();
  EXPECT_EQ(pixels, 36u);
  const json classes = quantity_of(checked["candidates"][0]["quantities"], "class");
  EXPECT_GT(classes["wrong"], 4);
  EXPECT_EQ(pixels_of(pictures[2], "wrong"), classes["wrong"]);
}

TEST(View, of_a_far_sphere_distinguishes_all_methods) {
  const std::string far = resized_example("far-sphere.toml", 6);
  const json scene = document_of(far)["scenes"][0];
  EXPECT_TRUE(scene["figure"]["out_of_scale"].get<bool>());
  expect_has_the_very_text_of_explain(scene);
  expect_the_microscope_s_grid_is_of_doubles(scene);
  expect_methods_that_agree_share_an_answer(scene);
  expect_the_microscope_of_a_miss_says_why_it_is_wide(scene);
  const json quadratic = document_of(far + " --method quadratic --pixel 2,5");
  const json checked = printed_json("check " + far + " --intersect quadratic");
  const json& alone = quadratic["scenes"][0];
  EXPECT_EQ(alone["start"]["pixel"], (json{2, 5}));
  expect_panels_show_the_methods_that_were_asked_for(scene, alone);
  expect_which_digits_are_right(alone);
  expect_how_many_discrepancies_there_are(quadratic, checked);
  expect_pictures_count_what_they_show(alone, checked);
}

std::string renderer(const std::string& mistake) {
  return " --candidate 'renderer:python3 tests/candidates/rt.py " + mistake + " {scene} {image}'";
}

/// Of more pixels than one chunk of a picture has.
TEST(View, has_a_renderers_picture_and_its_wrong_pixels) {
  constexpr int kSide = 16;
  constexpr std::uint64_t kPixels = kSide * kSide;
  const std::string ten = resized_example("ten-spheres.toml", kSide);
  const json right = document_of(ten + renderer("none"))["scenes"][0]["pictures"];
  ASSERT_EQ(right.size(), 3u);
  EXPECT_EQ(right[1]["legend"], right[0]["legend"]);
  EXPECT_EQ(right[1]["png"], right[0]["png"]);
  EXPECT_EQ(pixels_of(right[2], "correct"), kPixels);
  EXPECT_EQ(pixels_of(right[2], "wrong"), 0u);

  const json mirrored = document_of(ten + renderer("mirrored"));
  const json& pictures = mirrored["scenes"][0]["pictures"];
  EXPECT_EQ(pictures[1]["legend"], pictures[0]["legend"]);  // as many pixels, elsewhere
  EXPECT_NE(pictures[1]["png"], pictures[0]["png"]);
  const json report = printed_json("check " + ten + renderer("mirrored"));
  EXPECT_GT(pixels_of(pictures[2], "wrong hit class or sphere: defect"), 0u);
  EXPECT_EQ(pixels_of(pictures[2], "wrong hit class or sphere: defect"),
            report["candidates"][0]["discrepancies_by_standing"]["defect"].get<std::uint64_t>())
      << report["candidates"][0].dump(1).substr(0, 2000);
  // Its panels show raycheck's methods: pictures are not explained.
  EXPECT_FALSE(has(mirrored["scenes"][0]["panels"][0]["command"].get<std::string>(), "candidate"));

  const json grey = document_of(ten + renderer("grey"))["scenes"][0]["pictures"];
  EXPECT_EQ(pixels_of(grey[1], "an unknown sphere"), kPixels - pixels_of(right[0], "no sphere"));
  const json crash = document_of(ten + renderer("crash"));
  ASSERT_EQ(crash["findings"].size(), 1u);
  EXPECT_TRUE(has(crash["findings"][0]["sentence"].get<std::string>(), "image: it exited with 1"))
      << crash["findings"];
  const json& none = crash["scenes"][0]["pictures"];
  EXPECT_EQ(pixels_of(none[1], "no answer"), kPixels);
  EXPECT_EQ(pixels_of(none[2], "wrong hit class or sphere: defect"), kPixels);
}

TEST(View, explains_each_of_several_candidates_separately) {
  const json document = document_of(
      "scene/examples/optical-axis.toml --candidate 'command:python3 tests/candidates/right.py' "
      "--candidate 'command:python3 tests/candidates/meets.py none'");
  ASSERT_EQ(document["scenes"].size(), 2u);
  for (const json& scene : document["scenes"]) {
    const json& panel = scene["panels"][0];
    const std::string command = panel["command"];
    const Outcome explained = run(command.substr(command.find(' ') + 1));
    EXPECT_EQ(explained.out, panel["text"].get<std::string>()) << command;
  }
}

TEST(View, a_page_is_one_self_contained_file_of_bounded_size) {
  const std::string name = "<img src=x onerror=alert(1)>.toml";
  const std::string scene =
      temporary_file(name, contents(RAYCHECK_SOURCE_DIR "/scene/examples/ten-spheres.toml"));
  const std::string page = temporary_file("page.html", "");
  const Outcome result = run("view '" + scene + "' --out " + page, 0);
  const std::string text = contents(page);
  EXPECT_LE(text.size(), 1'500'000u);
  EXPECT_TRUE(text.find("default-src 'none'; script-src 'sha256-") != std::string::npos);
  EXPECT_TRUE(text.find("&lt;img src=x onerror=alert(1)&gt;.toml") != std::string::npos);
  for (const char* part : {"src=\"", "{document}", "<img src=x"}) {
    EXPECT_EQ(text.find(part), std::string::npos) << part;
  }
}

TEST(View, a_family_has_a_scene_for_each_severity) {
  const json document = document_of("--family distance --method quadratic,cross --cases 10");
  const json& facet = document["chart"]["facets"][0];
  EXPECT_EQ(facet["severities"].size(), 16u);
  EXPECT_EQ(document["dial"]["scenes"].size(), 16u);
  EXPECT_EQ(document["scenes"].size(), 16u);
  ASSERT_EQ(facet["series"].size(), 2u);
  // It opens at the first error of the first method.
  ASSERT_FALSE(document["findings"].empty());
  EXPECT_GT(document["findings"][0]["scene"], 0);
  EXPECT_EQ(document["findings"][0]["method"], "quadratic");
  EXPECT_EQ(facet["series"][0]["points"].back()["standing"], "defect");
  EXPECT_EQ(facet["series"][1]["points"].back()["standing"], "excused");
}

}  // namespace
}  // namespace raycheck::tests
