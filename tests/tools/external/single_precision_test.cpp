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

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(SinglePrecision, passes_all_laws_where_floats_are_good_of_their_kind) {
  const Outcome outcome = run("properties --cases 300 --candidate " + kGood);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;
  EXPECT_FALSE(contains(outcome.out, "0 comparisons, 300 left out"));
}

TEST(SinglePrecision, tells_a_textbook_formula_in_its_own_units) {
  const Outcome outcome = run("properties --filter parameter --candidate " + kTextbook);
  EXPECT_EQ(outcome.exit_code, 1) << outcome.out << outcome.err;
  EXPECT_TRUE(contains(outcome.out, "ulp of float")) << outcome.out;
  const json report =
      json::parse(run("properties --filter parameter --format json --candidate " + kTextbook).out);
  const json& campaign = report["campaigns"][0];
  EXPECT_EQ(campaign["finding"], "broken");
  EXPECT_EQ(campaign["precision"], "single");
  EXPECT_EQ(campaign["quantities"][0]["unit"], "ulp of float");
  // Both hold on what is far from the limits of floats.
  EXPECT_EQ(run("properties --filter class --source rays --candidate " + kTextbook).exit_code, 0);
}

TEST(SinglePrecision, is_judged_on_the_scene_rounded_to_floats_and_the_report_says_so) {
  const std::string scene = temporary_file("tenths.toml",
                                           "[[ray]]\norigin = [0, 0.1, 0]\ndirection = [1, 0, 0]\n"
                                           "[[sphere]]\ncentre = [3, 0.1, 0.3]\nradius = 0.7\n");
  const json report = judged(scene, kGood);
  EXPECT_EQ(report["precision"], "single");
  EXPECT_EQ(report["rounded_numbers"], 4);
  EXPECT_EQ(report["discrepancies"], 0) << report.dump(2);
  for (const json& quantity : report["quantities"]) {
    if (quantity["name"] != "parameter") continue;
    EXPECT_EQ(quantity["unit"], "ulp of float");
    EXPECT_LT(quantity["max"].get<double>(), 4);
  }
  const Outcome words = run("check " + scene + " --candidate " + kGood);
  EXPECT_TRUE(contains(words.out, "judged in single precision: u = 2^-24")) << words.out;
  EXPECT_TRUE(contains(words.out,
                       "4 numbers of the scene are no floats: asked and judged on the "
                       "scene rounded to floats"))
      << words.out;
  // Beside a candidate in doubles each is judged on what it was asked.
  const json both =
      json::parse(run("check " + scene + " --rays direct --format json --candidate " + kGood).out);
  ASSERT_EQ(both["candidates"].size(), 2u);
  EXPECT_EQ(both["candidates"][0]["precision"], "double");
  EXPECT_EQ(both["candidates"][0]["rounded_numbers"], 0);
  EXPECT_EQ(both["discrepancies"], 0);
  std::filesystem::remove(scene);
}

TEST(SinglePrecision, is_not_judged_where_floats_cannot_hold_the_scene) {
  const std::string scene = temporary_file("wide.toml",
                                           "[[ray]]\norigin = [0, 0, 0]\ndirection = [1, 0, 0]\n"
                                           "[[sphere]]\ncentre = [1e60, 0, 0]\nradius = 1\n");
  const Outcome words = run("check " + scene + " --candidate " + kGood);
  EXPECT_EQ(words.exit_code, 4) << words.out << words.err;
  EXPECT_TRUE(contains(words.out, "not judged here: rounded to floats: 1e+60 leaves their range"))
      << words.out;
  const json report =
      json::parse(run("check " + scene + " --format json --candidate " + kGood).out);
  EXPECT_TRUE(contains(report["candidates"][0]["not_asked"], "1e+60"));
  std::filesystem::remove(scene);
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
  EXPECT_TRUE(contains(verified.out, "confirmed")) << verified.out;
  EXPECT_FALSE(contains(verified.out, "not certified:")) << verified.out;
  std::filesystem::remove(proofs);
  std::filesystem::remove(scene);
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
  const std::string command = "--candidate 'command:python3 " + candidate + "'";
  const Outcome outcome = run("properties --filter parameter --source rays --cases 40 " + command);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;
  const json report =
      json::parse(run("check scene/examples/lecture-examples.toml --format json " + command).out);
  EXPECT_EQ(report["candidates"][0]["precision"], "single");
  std::filesystem::remove(candidate);
}

TEST(SinglePrecision, of_a_renderer_is_an_option) {
  const std::string renderer =
      " --candidate 'renderer:python3 tests/candidates/rt.py none {scene} {image}'";
  const auto report = [&](const std::string& more) {
    return json::parse(run("check scene/examples/probe.toml --format json " + more + renderer).out);
  };
  EXPECT_EQ(report("")["candidates"][0]["precision"], "double");
  const json single = report("--precision single");
  EXPECT_EQ(single["candidates"][0]["precision"], "single");
  EXPECT_GT(single["candidates"][0]["quantities"][0]["cases"], 1000);
  const Outcome wrong = run("check scene/examples/probe.toml --precision half" + renderer);
  EXPECT_EQ(wrong.exit_code, 2);
  EXPECT_TRUE(contains(wrong.err, "--precision")) << wrong.err;
}

TEST(SinglePrecision, of_a_submission_is_what_the_rubric_says) {
  const std::string header = "#include <raycheck/candidate.hpp>\n";
  const Outcome bad = run("check scene/examples/lecture-examples.toml --candidate source:" +
                          temporary_file("bad.cpp", header + "using namespace raycheck;\n"
                                                             "RAYCHECK_CANDIDATE(.precision = "
                                                             "static_cast<Precision>(7))\n"));
  EXPECT_EQ(bad.exit_code, 2);
  EXPECT_TRUE(contains(bad.err, "no such precision: 7")) << bad.err;
}

}  // namespace
}  // namespace raycheck::tests
