// Candidates that pick: the point of a sphere seen through a pixel, in one step.

#include "tests/tools/external/judged.h"

namespace raycheck::tests {
namespace {

const std::string kScene = "scene/examples/ten-spheres.toml";

/// A candidate of tests/candidates/, with another end that begins where `end` is found.
std::string with_end(const std::string& name, const std::string& end, const std::string& other) {
  const std::string text = contents(RAYCHECK_SOURCE_DIR "/tests/candidates/" + name);
  const std::size_t at = text.find(end);
  EXPECT_NE(at, std::string::npos) << name;
  return text.substr(0, at) + other;
}

/// Picks right, and picks that never find anything, in each language.
std::string in_cpp(bool finds) {
  return "source:" +
         temporary_file(finds ? "finds.cpp" : "misses.cpp",
                        with_end("right.cpp", "RAYCHECK_CANDIDATE(",
                                 "std::optional<Hit> pick(const Camera& camera, const "
                                 "Conventions& asked, Pixel pixel, const Sphere& ball) {\n"
                                 "  if (!" +
                                     std::to_string(int{finds}) +
                                     ") return {};\n"
                                     "  return intersect(asked.origin == Origin::focal ? "
                                     "focal_ray(camera, asked, pixel) : pixel_ray(camera, "
                                     "asked, pixel), ball, asked);\n}\n"
                                     "RAYCHECK_CANDIDATE(.pick = pick)\n"));
}
std::string in_python(bool finds) {
  return "command:python3 " +
         temporary_file(
             finds ? "finds.py" : "misses.py",
             with_end("right.py", "if __name__",
                      std::string("def pick(camera, asked, pixel, sphere):\n") +
                          (finds ? "" : "    return None\n") +
                          "    make = focal_ray if asked.origin == 'focal' else pixel_ray\n"
                          "    return intersect(make(camera, asked, pixel), sphere, asked)\n"
                          "rc.run('mine', pick=pick)\n"));
}
std::string in_javascript(bool finds) {
  const std::string folder = temporary_folder(finds ? "finds" : "misses");
  fs::copy_file(RAYCHECK_SOURCE_DIR "/tools/external/adapters/raycheck_candidate.mjs",
                folder + "/raycheck_candidate.mjs");
  std::ofstream(folder + "/pick.mjs") << with_end(
      "right.mjs", "run(\"right\"",
      std::string("const pick = (camera, asked, pixel, sphere) => ") + (finds ? "" : "null && ") +
          "intersect((asked.origin === \"focal\" ? focalRay : pixelRay)(camera, asked, "
          "pixel), sphere, asked);\nrun(\"mine\", { pick });\n");
  return "command:node " + folder + "/pick.mjs";
}
std::string in_java(bool finds) {
  const std::string folder = temporary_folder(finds ? "javafinds" : "javamisses");
  const std::string source = folder + "/Picks.java";
  // The scene's camera looks along -z.
  std::ofstream(source) << R"(public class Picks extends Right {
  @Override public Hit pick(Camera camera, Conventions asked, Pixel pixel, Sphere ball) {
    Vector e = camera.eye();
    double x = camera.left() + pixel.i() * (camera.right() - camera.left()) / (camera.width() - 1);
    double y = camera.bottom() + pixel.j() * (camera.top() - camera.bottom()) / (camera.height() - 1);
    double z = camera.near(), length = Math.sqrt(x * x + y * y + z * z);
    Ray ray = new Ray(new Vector(e.x() + x, e.y() + y, e.z() + z),
        new Vector(x / length, y / length, z / length));
    return )" << (finds ? "intersect(ray, ball, asked)" : "null")
                        << R"(;
  }
  public static void main(String[] arguments) throws java.io.IOException {
    new Picks().run("mine");
  }
}
)";
  EXPECT_EQ(
      std::system(("javac -d " + folder +
                   " " RAYCHECK_SOURCE_DIR "/tools/external/adapters/RaycheckCandidate.java " +
                   RAYCHECK_SOURCE_DIR "/tests/candidates/Right.java " + source)
                      .c_str()),
      0);
  return "command:java -cp " + folder + " Picks";
}

void expect_judged(std::string (*candidate)(bool finds)) {
  const json right = judged(kScene, candidate(true));
  EXPECT_EQ(right["discrepancies"], 0) << right.dump(2);
  EXPECT_GT(quantity_of(right["quantities"], "hit point")["cases"], 100) << candidate(true);
  const json misses = judged(kScene, candidate(false));
  EXPECT_EQ(quantity_of(misses["quantities"], "class")["wrong"],
            quantity_of(right["quantities"], "hit point")["cases"]);
}

TEST(Pick, is_judged_in_every_language) {
  for (const auto candidate : {in_cpp, in_python}) expect_judged(candidate);
  if (is_installed("node")) expect_judged(in_javascript);
  if (is_installed("javac")) expect_judged(in_java);
}

TEST(Pick, is_unknown_to_libraries_of_older_headers) {
  const std::string source = temporary_file(
      "older.c",
      "#include <raycheck/candidate.h>\n#include <stdlib.h>\n"
      "static raycheck_hit pick(const raycheck_camera* a, const raycheck_conventions* b, "
      "raycheck_pixel c, const raycheck_sphere* d) {\n  (void)a, (void)b, (void)c, (void)d;\n"
      "  abort();\n}\n"
      "extern \"C\" const raycheck_candidate* raycheck_candidate_functions(void) {\n"
      "  static raycheck_candidate candidate;\n  candidate.version = 5;\n"
      "  candidate.pick = pick;\n  return &candidate;\n}\n");
  expect_parts(run("check " + kScene + " --candidate source:" + source, 2).err,
               {"it has none of the functions that raycheck judges"});
}

TEST(Pick, has_its_convention_named) {
  const std::string flipped =
      "command:python3 " +
      temporary_file(
          "flipped.py",
          with_end("right.py", "if __name__",
                   "def pick(camera, asked, pixel, sphere):\n"
                   "    hit = intersect(focal_ray(camera, asked._replace(rows='top-first'), "
                   "pixel), sphere, asked)\n"
                   "    return hit and hit[1]\n"
                   "rc.run('mine', pick=pick, returns='point', origin='focal')\n"));
  expect_parts(run("properties --cases 300 --filter class --candidate '" + flipped + "'", 1).out,
               {"right under rows = top-first, which the candidate does not declare"});
}

TEST(Pick, is_asked_only_for_cameras) {
  const Outcome outcome =
      run("check scene/examples/lecture-examples.toml --candidate '" + in_python(true) + "'");
  expect_parts(outcome.out, {"the candidate does not implement intersect()"});
}

}  // namespace
}  // namespace raycheck::tests
