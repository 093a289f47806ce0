#include "properties/cases/case_source.h"
#include "properties/laws/law.h"
#include "scene/number.h"
#include "tests/tools/program.h"
#include "tools/properties/properties.h"

namespace raycheck::tests {
namespace {

TEST(PropertiesCommand, reports_a_broken_law_with_a_case_that_check_and_replay_accept) {
  const json campaign = printed_json(
      "properties --filter class --source distance --level extreme --intersect quadratic",
      1)["campaigns"][0];
  EXPECT_FALSE(campaign["holds"].get<bool>());
  const std::string path = temporary_file("shrunk.toml", campaign["scene"]);
  EXPECT_EQ(run("check " + path + " --intersect quadratic").exit_code, 1);
  const Outcome again = run("properties --replay " + campaign["replay"].get<std::string>(), 1);
  EXPECT_TRUE(has(again.out, "BROKEN"));
}

TEST(PropertiesCommand, reports_the_range_of_each_number_of_a_failure) {
  const std::string asked =
      "properties --filter class --source distance@8 --level extreme --intersect lecture";
  const json campaign = printed_json(asked, 1)["campaigns"][0];
  ASSERT_EQ(campaign["ranges"].size(), 10u);
  EXPECT_EQ(campaign["numbers_not_tried"], 0);
  const json& radius = campaign["ranges"][9];
  expect_values(radius, {{"number", "sphere 0 radius"}, {"by", "samples"}});
  EXPECT_GT(radius["samples"], 64);
  // The radius may be any number from 0 on, except radii next to 0, which are outside the domain.
  expect_values(radius, {{"least", "0x0p+0"}, {"certified/0", "0x1p-200"}});
  const double greatest = std::stod(radius["greatest"].get<std::string>());
  EXPECT_LE(std::stod(radius["certified"][1].get<std::string>()), greatest);
  // `check` finds the same defect with the greatest radius, and none with a radius twice as large.
  const std::string scene = campaign["scene"];
  const auto has_false_hit = [&](double r) {
    std::string other = scene;
    const std::size_t at = other.find("radius = ") + 9;
    other.replace(at, other.find('\n', at) - at, raycheck::scene::shortest(r));
    return has(run("check --intersect lecture " + temporary_file("radius.toml", other), 1).out,
               "false hit");
  };
  EXPECT_TRUE(has_false_hit(greatest));
  EXPECT_FALSE(has_false_hit(2 * greatest));
  const std::string text = run(asked, 1).out;
  expect_parts(text,
               {"    the case's numbers, varied one at a time:\n      ray 0 origin x: every value ",
                "sphere 0 radius: every value tried in [0, ",
                " tried; certified for all in [6.22302e-61, "});
  const json right = printed_json("properties --filter class --source rays --intersect cross");
  EXPECT_FALSE(right["campaigns"][0].contains("ranges"));
}

TEST(PropertiesCommand, report_does_not_depend_on_the_number_of_threads) {
  const std::string asked =
      "properties --level extreme --intersect quadratic --intersect cross --cases 200 --format "
      "json --threads ";
  const std::string by_one = run(asked + "1").out;
  ASSERT_TRUE(has(by_one, "broken"));
  EXPECT_EQ(run(asked + "2").out, by_one);
  EXPECT_EQ(run(asked + "7").out, by_one);
}

const std::string kBreaks =
    "properties --filter class --intersect quadratic --level extreme --cases 150 ";

TEST(PropertiesCommand, reports_where_shrinking_ended_early) {
  tools::CampaignReport campaign{};
  campaign.law = properties::find_law("class");
  campaign.candidate = "mine";
  properties::Failure failure{{}, properties::Verdict("class"), ""};
  EXPECT_FALSE(has(failure_text(campaign, failure, false), "may exist"));
  failure.tries = 7;
  expect_parts(failure_text(campaign, failure, false),
               {"# breaks the law class with mine\n", "# shrunk for 7 tries; smaller may exist\n"});
}

/// A case in the corpus is tried first and breaks the law again. Once the candidate is right on it,
/// it is reported as mended.
TEST(PropertiesCommand, keeps_a_corpus_of_broken_cases) {
  const std::string folder = temporary_folder("kept") + "/corpus";
  EXPECT_FALSE(has(run(kBreaks + "--keep-going 3 --corpus " + folder, 1).out, "corpus:"));
  std::vector<std::string> files;
  for (const auto& entry : fs::directory_iterator(folder)) {
    files.push_back(entry.path().string());
    EXPECT_EQ(run("check " + files.back() + " --intersect quadratic").exit_code, 1);
  }
  ASSERT_GT(files.size(), 1u);
  // The random cases do not break the law.
  const std::string again = "properties --filter class --source rays --cases 20 --corpus " + folder;
  const Outcome broken = run(again + " --intersect quadratic", 1);
  expect_parts(
      run(again + " --intersect quadratic --format junit", 1).out,
      {"/corpus/class-direct-quadratic-", "<failure", "breaks the law again (class: false hit)"});
  // With a baseline that contains it, the command passes.
  const std::string baseline = " --intersect quadratic --baseline " + folder + "/known.txt";
  run(again + baseline + " --update-baseline");
  EXPECT_EQ(run(again + baseline).exit_code, 0);
  std::ofstream(folder + "/known.txt").close();
  expect_parts(broken.out, {" breaks class with direct/quadratic",
                            "corpus: " + std::to_string(files.size()) + " cases, " +
                                std::to_string(files.size()) + " broken, 0 fixed"});
  EXPECT_TRUE(has(run(again + " --intersect cross", 0).out, " 0 broken, 0 fixed"));
  const std::string text =
      replaced(contents(files[0]), "found with: direct/quadratic", "found with: direct/cross");
  std::ofstream(files[0]) << text;
  const Outcome mended = run(again + " --intersect cross", 0);
  expect_parts(mended.out,
               {"no longer breaks class with direct/cross: fixed", " 0 broken, 1 fixed"});
  std::ofstream(files[0]) << replaced(text, "# law:", "# low:");
  expect_refused(again, files[0] + ": names no law");
  std::ofstream(files[0]) << "# law: direction\n# pixels: (0, 0) (3, 9)\n"
                          << contents(RAYCHECK_SOURCE_DIR "/scene/examples/optical-axis.toml");
  const std::string outside = files[0] + ": pixel (3, 9) is outside of its image of ";
  expect_refused("properties --corpus " + fs::path(files[0]).parent_path().string(), outside);
}

TEST(PropertiesCommand, finds_by_climbing_what_random_cases_miss) {
  const json report = printed_json(
      "properties --filter parameter --intersect cross --source distance --cases 60 --target rho");
  EXPECT_EQ(report["target"], "rho");
  const json& worst = report["campaigns"][0]["worst"];
  EXPECT_GT(worst["climbed"].get<double>(), worst["random"].get<double>());
  const std::string text =
      replaced(contents(RAYCHECK_SOURCE_DIR "/tests/candidates/float_quadratic.cpp"), ".precision",
               ".level = Level::demanding, .precision");
  const std::string floats =
      "properties --candidate source:" + temporary_file("demanding.cpp", text) +
      " --filter parameter --source rays --cases 40 --level extreme ";
  EXPECT_EQ(run(floats).exit_code, 0);
  EXPECT_TRUE(has(run(floats + "--target rho", 1).out, "replay: none: found by climbing"));
}

/// A candidate that keeps the nearest hit between questions.
TEST(PropertiesCommand, retries_failures_in_a_fresh_process) {
  const std::string text =
      replaced(contents(RAYCHECK_SOURCE_DIR "/tests/candidates/right.cpp"), "if (s < 0) return {};",
               "static double t_max = INFINITY;\nif (s < 0 || s > t_max) return {};\nt_max = s;");
  const Outcome kept = run(
      "properties --candidate source:" + temporary_file("remembers.cpp", text) + " --cases 60", 1);
  expect_parts(
      lines_of(kept.out).front(),
      {"a question that is asked first is answered right: the candidate keeps state between "
       "questions"});
  EXPECT_FALSE(has(kept.out, "no ray ever hits")) << kept.out;
}

/// The reported number of cases can be repeated on a machine of any speed.
TEST(PropertiesCommand, accepts_a_time_and_reports_the_number_of_cases) {
  const std::string asked = "properties --filter class --source rays --intersect cross ";
  const auto [exit_code, timed, err] = run(asked + "--for 1s");
  const std::string last = lines_of(timed).back(), says = "1s is --cases ";
  ASSERT_TRUE(last.starts_with(says)) << last;
  const std::string count = last.substr(says.size(), last.find(';') - says.size());
  EXPECT_EQ(last, says + count + "; cases of each source: " + count + " rays");
  EXPECT_EQ(timed, run(asked + "--cases " + count, exit_code).out + last + "\n");
  expect_refused(asked + "--for 5", "--for 5: give a whole number and s, m or h");
  expect_refused(asked + "--for 1s --cases 3", "--cases excludes --for");
}

TEST(PropertiesCommand, exits_with_4_when_nothing_or_too_little_was_judged) {
  for (const auto& [asked, why] :
       {std::pair("pixel-point --rays focal --cases 5", ""),
        {"class --source rays --cases 6 --intersect cross", "fewer than 10 of the rays that hit"},
        {"parameter --source scale@600 --intersect cross", "not judged here"}}) {
    const Outcome outcome = run("properties --filter " + std::string(asked), 4);
    EXPECT_TRUE(has(outcome.out, why));
  }
}

TEST(PropertiesCommand, judges_the_laws_of_several_filters_in_their_order) {
  const json report = printed_json(
      "properties --filter root --filter class --source rays --cases 20 --intersect cross");
  std::vector<std::string> laws;
  for (const json& campaign : report["campaigns"]) laws.push_back(campaign["law"]);
  EXPECT_EQ(laws, (std::vector<std::string>{"class", "nearest-root", "plan-roots"}));
  expect_refused("properties --filter class --filter glass", "--filter glass: no law's name");
}

TEST(PropertiesCommand, breaks_laws_for_excuses_when_it_is_strict) {
  const std::string asked = "properties --filter class --source tangency@16 --intersect cross";
  EXPECT_EQ(run(asked).exit_code, 0);
  EXPECT_EQ(run(asked + " --strict").exit_code, 1);
}

TEST(PropertiesCommand, judges_methods_by_their_level) {
  const std::string asked =
      "properties --filter class --cases 50 --intersect cross --intersect quadratic";
  EXPECT_TRUE(has(run(asked, 0).out, "pairs of a law and a candidate: 0 broken, 2 hold"));
  const json report = printed_json(asked);
  expect_values(report["campaigns"], {{"0/level", "demanding"}, {"1/level", "ordinary"}});
}

TEST(PropertiesCommand, reports_the_severity_up_to_which_a_broken_law_holds) {
  const std::string asked = "properties --filter class --source distance --intersect quadratic ";
  const Outcome broken = run(asked + "--level extreme", 1);
  expect_parts(broken.out, {"    broken on distance@", "    holds on distance up to @"});
}

TEST(List, names_every_method_law_and_convention) {
  expect_parts(run("list", 0).out,
               {"  reference-field  ", "error bounds may be exceeded: the last"});
  const json report = printed_json("list");
  EXPECT_EQ(report["laws"].size(), properties::laws().size());
  ASSERT_EQ(report["sources"].size(), properties::case_sources().size());
  for (const json& source : report["sources"]) {
    if (source["name"] == "cameras") {
      expect_values(source, {{"dial", nullptr}, {"level", "ordinary"}});
    }
    if (source["name"] == "distance") {
      EXPECT_EQ(source["dial"]["highest"], 15);
      EXPECT_LT(source["dial"]["highest_ordinary"], source["dial"]["highest_demanding"]);
    }
  }
}

}  // namespace
}  // namespace raycheck::tests
