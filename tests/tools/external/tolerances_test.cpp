// Candidates that declare tolerances: within these either answer is right.

#include "tests/tools/external/judged.h"

namespace raycheck::tests {
namespace {

/// A tolerance, its size, a smaller one, and where code takes a line for a tangent, or an origin
/// for a point of the surface, whose root there it drops.
struct Tolerant {
  std::string name, size, smaller, touches, is_on_surface;
  std::string statement(const std::string& of) const { return "tolerance_" + name + " " + of; }
};
const std::vector<Tolerant> kTolerant = {
    {"discriminant", "1e-06", "1e-08", "std::abs(4 * under) <= 1e-06", "false"},
    {"d_sq", "1e-06", "1e-08", "std::abs(under) / a <= 1e-06", "false"},
    {"distance", "1e-07", "1e-09", "std::abs(apart - r) <= 1e-07", "false"},
    {"radii", "1e-07", "1e-09", "std::abs(apart - r) <= 1e-07 * r", "false"},
    {"c", "1e-06", "1e-08", "false", "std::abs(c) <= 1e-06"},
    {"surface", "1e-07", "1e-09", "false", "std::abs(distance - r) <= 1e-07"},
    {"s", "1e-06", "1e-08", "false", "std::min(std::abs(one), std::abs(other)) <= 1e-06"}};

/// tolerant.cpp with this tolerance. It declares `contract`.
std::string candidate(const Tolerant& tolerant, const std::string& contract) {
  static const std::string all = [] {
    std::string touches = "false", is_on_surface = "false";
    for (const Tolerant& one : kTolerant) {
      const std::string condition = " || (is_chosen(\"" + one.name + "\") && ";
      touches += condition + one.touches + ")";
      is_on_surface += condition + one.is_on_surface + ")";
    }
    return compiled(temporary_file(
        "tolerant.cpp", kChoice + "#define CONTRACT contract_of()\n#define TOUCHES " + touches +
                            "\n#define IS_ON_SURFACE " + is_on_surface +
                            "\n#include \"" RAYCHECK_SOURCE_DIR
                            "/tests/candidates/tolerant.cpp\"\n"));
  }();
  return chosen(all, tolerant.name, contract);
}

TEST(Tolerances, excuse_answers_within_them_and_are_counted) {
  for (const Tolerant& one : kTolerant) {
    const std::string contract = one.statement(one.size);
    const Outcome outcome =
        run("properties --cases 300 --level demanding --candidate " + candidate(one, contract));
    EXPECT_EQ(outcome.exit_code, 0) << one.name << outcome.out << outcome.err;
    expect_parts(outcome.out, {"are right only within the declared " + contract +
                               ": there either answer counts as right"});
  }
}

/// A grazing ray, one that starts nearly on the sphere, and three plain ones.
TEST(Tolerances, that_are_not_declared_or_too_small_are_broken) {
  std::string scene = "[[sphere]]\ncentre = [0, 0, 0]\nradius = 2\n";
  for (const char* origin : {"-5, 1.99999994, 0", "-2.00000006, 0, 0", "-5, 1, 0", "0, 0, 0"}) {
    scene += ray_text(origin, "1, 0, 0");
  }
  scene = temporary_file("tolerances.toml", scene + ray_text("-5, 3, 0", "1, 0, 0"));
  for (const Tolerant& one : kTolerant) {
    for (const auto& contract : {std::string(), one.statement(one.smaller)}) {
      EXPECT_EQ(check(scene, candidate(one, contract)).exit_code, 1) << one.name << contract;
    }
    const json report = judged(scene, candidate(one, one.statement(one.size)));
    EXPECT_EQ(report["discrepancies"], report["tolerated"]) << report.dump();
    EXPECT_EQ(report["discrepancies_by_standing"]["excused"], report["tolerated"]);
    EXPECT_GT(report["tolerated"], 0) << one.name;
  }
}

}  // namespace
}  // namespace raycheck::tests
