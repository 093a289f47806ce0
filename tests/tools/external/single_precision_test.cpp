// Candidates that declare single precision, in every form, through the built program.

#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/tools/external/judged.h"

namespace raycheck::tests {
namespace {

using nlohmann::json;

const std::string kGood = "source:tests/candidates/float_tracer.cpp";
const std::string kTextbook = "source:tests/candidates/float_quadratic.cpp";

TEST(SinglePrecision, passes_all_laws_where_floats_are_good_of_their_kind) {
  const Outcome outcome = run("properties --cases 300 --candidate " + kGood);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;
  EXPECT_FALSE(has(outcome.out, "0 comparisons, 300 left out"));
}

TEST(SinglePrecision, tells_a_textbook_formula_in_its_own_units) {
  const json campaign = report_of("properties --filter parameter", kTextbook, 1)["campaigns"][0];
  EXPECT_EQ(campaign["finding"], "broken");
  EXPECT_EQ(campaign["precision"], "single");
  EXPECT_EQ(campaign["quantities"][0]["unit"], "ulp of float");
  // Its class holds on what is far from the limits of floats.
  report_of("properties --filter class --source rays", kTextbook, 0);
}

TEST(SinglePrecision, is_judged_on_the_scene_rounded_to_floats_and_the_report_says_so) {
  const std::string scene = temporary_file("tenths.toml",
                                           "[[ray]]\norigin = [0, 0.1, 0]\ndirection = [1, 0, 0]\n"
                                           "[[sphere]]\ncentre = [3, 0.1, 0.3]\nradius = 0.7\n");
  // Beside a candidate in doubles each is judged on what it was asked.
  const json both = report_of("check " + scene + " --rays direct", kGood, 0)["candidates"];
  ASSERT_EQ(both.size(), 2u);
  EXPECT_EQ(both[0]["precision"], "double");
  EXPECT_EQ(both[0]["rounded_numbers"], 0);
  EXPECT_EQ(both[1]["rounded_numbers"], 4);
  EXPECT_LT(quantity_of(both[1]["quantities"], "parameter")["max"], 4);
  expect_parts(
      run("check " + scene + " --candidate " + kGood).out,
      {"4 numbers of the scene are no floats: asked and judged on the scene rounded to floats"});
}

TEST(SinglePrecision, is_not_judged_where_floats_cannot_hold_the_scene) {
  const std::string scene = temporary_file("wide.toml",
                                           "[[ray]]\norigin = [0, 0, 0]\ndirection = [1, 0, 0]\n"
                                           "[[sphere]]\ncentre = [1e60, 0, 0]\nradius = 1\n");
  const Outcome words = run("check " + scene + " --candidate " + kGood);
  EXPECT_EQ(words.exit_code, 4) << words.out << words.err;
  expect_parts(words.out, {"not judged here: rounded to floats: 1e+60 leaves their range"});
}

TEST(SinglePrecision, has_certificates_that_hold) {
  const std::string scene = temporary_file("far.toml",
                                           "[[ray]]\norigin = [0, 0, 0]\ndirection = [1, 0.1, 0]\n"
                                           "[[ray]]\norigin = [0, 1, 0]\ndirection = [1, 0, 0]\n"
                                           "[[sphere]]\ncentre = [300, 30, 0.3]\nradius = 0.7\n"
                                           "[[sphere]]\ncentre = [3, 0, 0.3]\nradius = 0.5\n");
  const std::string proofs = temporary_file("proofs", "");
  const json report = judged(scene, kTextbook, "--max-ulp 0 --top 50 --certificates " + proofs);
  EXPECT_GT(report["discrepancies"], 3);
  const Outcome verified = run_python("tools/verify_certificates.py " + proofs);
  EXPECT_EQ(verified.exit_code, 0) << verified.out;
  expect_parts(verified.out, {"confirmed"});
  EXPECT_FALSE(has(verified.out, "not certified:")) << verified.out;
}

TEST(SinglePrecision, is_declared_in_python) {
  const std::string candidate = temporary_file(
      "floats.py",
      "import struct, raycheck_candidate as rc\n"
      "def fl(x): return struct.unpack('f', struct.pack('f', x))[0]\n"
      "def intersect(ray, sphere, by):\n"
      "    (origin, d), (centre, r) = ray, sphere\n"
      "    assert all(fl(x) == x for x in (*origin, *d, *centre, r))\n"
      "    t = [c - o for c, o in zip(centre, origin)]\n"
      "    a, b = sum(x * x for x in d), sum(x * y for x, y in zip(t, d))\n"
      "    disc = b * b - a * (sum(x * x for x in t) - r * r)\n"
      "    if disc < 0: return None\n"
      "    s = [fl((b - disc ** .5) / a), fl((b + disc ** .5) / a)]\n"
      "    s = [x for x in s if x >= 0]\n"
      "    return (s[0], [fl(o + s[0] * x) for o, x in zip(origin, d)]) if s else None\n"
      "rc.run('floats', intersect=intersect, root='nearest', tangent='hit', precision='single')\n");
  const json report = report_of("properties --filter parameter --source rays --cases 40",
                                "command:python3 " + candidate, 0);
  EXPECT_EQ(report["campaigns"][0]["precision"], "single");
}

TEST(SinglePrecision, of_a_renderer_is_an_option) {
  const std::string renderer = "renderer:python3 tests/candidates/rt.py none {scene} {image}";
  const std::string probe = "scene/examples/probe.toml";
  EXPECT_EQ(judged(probe, renderer)["precision"], "double");
  const json single = judged(probe, renderer, "--precision single");
  EXPECT_EQ(single["precision"], "single");
  EXPECT_GT(single["quantities"][0]["cases"], 1000);
  const Outcome wrong = check(probe, renderer, "--precision half");
  EXPECT_EQ(wrong.exit_code, 2);
  expect_parts(wrong.err, {"--precision"});
}

TEST(SinglePrecision, that_is_none_is_refused) {
  const std::string source =
      temporary_file("bad.cpp",
                     "#include <raycheck/candidate.hpp>\nusing namespace raycheck;\n"
                     "RAYCHECK_CANDIDATE(.precision = static_cast<Precision>(7))\n");
  const Outcome bad = check("scene/examples/lecture-examples.toml", "source:" + source);
  EXPECT_EQ(bad.exit_code, 2);
  expect_parts(bad.err, {"no such precision: 7"});
}

}  // namespace
}  // namespace raycheck::tests
