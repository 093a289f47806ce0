// Renderers, right and wrong, through `check --candidate`.

#include "tests/tools/external/judged.h"

namespace raycheck::tests {
namespace {

std::string renderer(const std::string& mistake) {
  return "renderer:python3 tests/candidates/rt.py " + mistake + " {scene} {image}";
}

TEST(Renderer, with_one_colour_is_reported_as_not_judged_by_sphere) {
  const json report = judged(kProbeScene, renderer("grey"));
  EXPECT_EQ(report["discrepancies"], 0);
  expect_parts(report["left_out"].dump(),
               {"pixels whose colour is not that of a sphere are judged only as hit or miss"});
}

TEST(Renderer, is_right_on_every_scene_that_driver_files_can_express) {
  for (const char* scene : {"probe", "ten-spheres", "example-4", "sphere-around-eye",
                            "sphere-between-eye-and-plane", "far-sphere"}) {
    const json report = judged("scene/examples/" + std::string(scene) + ".toml", renderer("right"));
    EXPECT_EQ(report["discrepancies_by_standing"]["defect"], 0) << scene;
    EXPECT_EQ(report["discrepancies_by_standing"]["undecided"], 0) << scene;
    EXPECT_GT(report["quantities"][0]["cases"], 60) << scene;
    EXPECT_TRUE(report["explanations"].empty()) << scene;
  }
}

TEST(Renderer, samples_pixels_where_the_scene_says) {
  const std::string corners =
      temporary_file("corners.toml", contents(RAYCHECK_SOURCE_DIR "/" + kProbeScene) +
                                         "[conventions]\nsamples = \"corners\"\n");
  const auto causes = [](const std::string& scene, const std::string& mistake) {
    const json report = judged(scene, renderer(mistake));
    EXPECT_EQ(report["discrepancies"] == 0, report["explanations"].empty()) << report.dump(2);
    return report["explanations"].empty() ? "" : report["explanations"][0]["sentence"].dump();
  };
  EXPECT_EQ(causes(corners, "corners"), "");
  expect_parts(causes(corners, "right"), {"pixels are sampled from edge to edge"});
  expect_parts(causes(kProbeScene, "corners"), {"i/w and j/h place the pixels"});
}

/// A scene with a sphere before the eye, and one behind it.
std::string behind_scene() {
  return temporary_file("behind.toml",
                        "[camera]\neye = [0, 0, 6]\nlook_at = [0, 0, 0]\nup = [0, 1, 0]\n"
                        "near = -2\nleft = -1\nright = 1\nbottom = -1\ntop = 1\nwidth = 15\n"
                        "height = 15\n[[sphere]]\ncentre = [0, 0, -4]\nradius = 1.5\n"
                        "[[sphere]]\ncentre = [1.7, 0.2, 16]\nradius = 1.25\n");
}

TEST(Renderer, is_judged_by_what_is_declared_of_it) {
  const auto wrong = [](const std::string& scene, const std::string& mistake,
                        const std::string& declared) {
    return judged(scene, renderer(mistake), "--declare '" + declared + "'")["discrepancies"];
  };
  EXPECT_EQ(wrong(kProbeScene, "corners", "samples corners"), 0);
  EXPECT_GT(wrong(kProbeScene, "right", "samples corners"), 0);
  const std::string around = "scene/examples/sphere-around-eye.toml";
  EXPECT_EQ(wrong(around, "right", "culling none"), 0);
  EXPECT_GT(wrong(around, "right", "culling back-faces"), 0);
  EXPECT_EQ(wrong(behind_scene(), "right", "root nearest"), 0);
  EXPECT_GT(wrong(behind_scene(), "right", "t_min -inf"), 0);
  EXPECT_EQ(wrong(behind_scene(), "lines", "t_min -inf"), 0);
  for (const std::string declared : {"rows top-first", "samples corners; returns class"}) {
    const Outcome refused = run("check " + kProbeScene + " --declare '" + declared +
                                    "' --candidate '" + renderer("right") + "'",
                                2);
    expect_parts(refused.err, {"--declare '" + declared +
                               "': of a renderer, which has no "
                               "functions, only windows and conventions of pictures can be "});
  }
}

TEST(Renderer, with_dimmed_colours_still_has_its_mask_judged) {
  EXPECT_EQ(judged(kProbeScene, renderer("dim"))["discrepancies"], 0);
  EXPECT_GT(judged(kProbeScene, renderer("dim-upside-down"))["discrepancies"], 0);
}

TEST(Renderer, without_a_picture_fails_with_the_reason) {
  const auto expect_said = [](const std::string& mistake, const std::string& what) {
    const json report = judged(kProbeScene, renderer(mistake), "--timeout 1");
    EXPECT_GT(report["discrepancies"], 0);
    expect_parts(report["worst"].dump(), {what});
  };
  expect_said("transposed", "26 x 40 pixels, the scene 40 x 26: width and height are exchanged");
  expect_said("no-picture", "it exited with 0, but did not write its picture, image.ppm");
  expect_said("huge", "its picture has 8192 x 8192 pixels, the scene 40 x 26");
  expect_said("half", "its PPM has a word that is not a number, or ends too early");
  expect_said("crash", "exited with 1");
  expect_said("hang", "did not end, and used almost no CPU time for 1 s");
  expect_said("link", "its picture image.ppm is not a file");
  const Outcome none =
      run("check " + kProbeScene + " --candidate '" + renderer("no-picture") + "'", 1);
  expect_parts(none.out,
               {"0 of 1040 rays judged\n", "; no single question that fails was found\n",
                "no answer: image: it exited with 0, but did not write its picture, image.ppm",
                ": applies to functions; the law image judges a renderer's pictures\n"});
}

TEST(Renderer, whose_format_cannot_express_a_scene_is_not_judged_on_it) {
  const std::string inexpressible = python_renderer("sys.exit(77)");
  const Outcome outcome = check(kProbeScene, inexpressible);
  EXPECT_EQ(outcome.exit_code, 4) << outcome.err;
  const json report = json::parse(outcome.out)["candidates"][0];
  EXPECT_EQ(report["discrepancies"], 0);
  expect_parts(report["left_out"].dump(), {"its input format cannot express the scene"});
  const json campaign = report_of("properties --filter image --source crowds --cases 3",
                                  inexpressible, 4)["campaigns"][1];
  EXPECT_EQ(campaign["left_out"], 3);
  EXPECT_EQ(campaign["reason_left_out"], "its input format cannot express the scene");
  // A picture counts, whatever the exit code.
  const json drawn = judged(kProbeScene, python_renderer("open(sys.argv[2], 'w').write('P3 40 26 "
                                                         "255 ' + '0 ' * 3120)\nsys.exit(77)"));
  EXPECT_GT(drawn["discrepancies"], 0);
}

/// A campaign on a renderer.
Outcome tried(const std::string& built, const std::string& more) {
  return run("properties --filter image --cases 40 " + more + " --candidate 'renderer:" + built +
             " {scene} {image}'");
}

TEST(Renderer, keeps_the_law_of_images_or_is_tried_on_all_sources_and_explained) {
  const std::string folder = temporary_folder("renderers");
  const Outcome right = tried(built_submission("rt.cpp", "none", folder), "--source crowds");
  EXPECT_EQ(right.exit_code, 0) << right.out << right.err;
  const std::string built = built_submission("rt.cpp", "mirrored", folder);
  const std::string sources = "--source crowds --source course --source course-behind ";
  const json campaign = json::parse(tried(built, sources + "--format json").out)["campaigns"][1];
  EXPECT_EQ(campaign["finding"], "broken");
  ASSERT_EQ(campaign["parts"].size(), 3u);
  for (const json& part : campaign["parts"]) EXPECT_FALSE(part["replay"].is_null()) << part.dump(2);
  ASSERT_EQ(campaign["explanations"].size(), 1u) << campaign["explanations"].dump(2);
  EXPECT_GE(campaign["explanations"][0]["wrong"], 3);
  const Outcome words = tried(built, "--source course --image-change 1e-5");
  EXPECT_EQ(words.exit_code, 1);
  expect_parts(words.out, {"columns are mirrored; this explains all ",
                           "{image}' --image-change 1e-05 --replay '"});
}

/// Each of two threads takes half of 128 cases; its first run waits until both have started.
TEST(Renderer, is_started_by_each_thread_without_waiting_for_other_threads) {
  const std::string folder = temporary_folder("started");
  const std::string meets = temporary_file("meets.sh", "cd " + folder + R"(
[ -e both ] && exit 77
: > $$
for second in 1 2 3 4 5 6; do
  [ $(ls | wc -l) -gt 1 ] && : > both && exit 77
  sleep 1
done
: > alone
)");
  const Outcome outcome = run("properties --filter image --source crowds --cases 128 --threads 2" +
                              kUnkept + " --candidate 'renderer:sh " + meets + " {scene} {image}'");
  EXPECT_FALSE(fs::exists(folder + "/alone"));
  EXPECT_EQ(outcome.exit_code, 4) << outcome.out << outcome.err;
}

/// The counts of right and wrong pixels in a few pictures, too few to break a law.
json tally_of(const std::string& mistake, const std::string& more) {
  const json report = printed_json("properties --filter image --source crowds --cases 4 " + more +
                                   " --candidate '" + renderer(mistake) + "'");
  EXPECT_EQ(report["failures"], 0);
  EXPECT_GT(report["campaigns"][1]["comparisons"], 10);
  return report["campaigns"][1]["quantities"][0];
}

TEST(Renderer, is_judged_with_the_given_ray_origin) {
  EXPECT_GT(judged(kProbeScene, renderer("from-eye"))["discrepancies"], 0);
  EXPECT_EQ(judged(kProbeScene, renderer("from-eye"), "--declare 'origin focal'")["discrepancies"],
            0);
  EXPECT_GT(judged(kProbeScene, renderer("right"), "--declare 'origin focal'")["discrepancies"], 0);
  tally_of("from-eye", "--declare 'origin focal'");
}

TEST(Renderer, is_tried_in_its_dialect_and_within_its_threshold) {
  tally_of("dialect-c", "--dialect C");
  // Without the option, these would be defects, as below.
  EXPECT_GT(tally_of("threshold", "--t-threshold 0.5")["wrong_by_standing"]["excused"], 0);
}

TEST(Renderer, receives_driver_files_in_the_dialect_of_the_scene_by_default) {
  const std::string a = "scene/examples/driver-a.txt";
  EXPECT_EQ(judged(a, renderer("dialect-a"))["discrepancies"], 0);
  EXPECT_GT(judged(a, renderer("right"))["discrepancies"], 0);
  EXPECT_EQ(judged(a, renderer("right"), "--dialect B")["discrepancies"], 0);
  EXPECT_EQ(judged("scene/examples/driver-c.txt", renderer("dialect-c"))["discrepancies"], 0);
}

TEST(Renderer, is_excused_for_hits_within_its_threshold) {
  // It ignores hits with s below 0.5: those of the sphere that the image plane cuts.
  EXPECT_FALSE(judged(kProbeScene, renderer("threshold"))["discrepancies"] == 0);
  const json report = judged(kProbeScene, renderer("threshold"), "--t-threshold 0.5");
  EXPECT_EQ(report["discrepancies"], report["discrepancies_by_standing"]["excused"]);
  EXPECT_GT(report["discrepancies"], 0);
}

}  // namespace
}  // namespace raycheck::tests
