// Campaigns in shards: in whatever way the units are distributed, `merge` gives the report of one
// run.

#include <fmt/format.h>

#include "properties/quantile_sketch.h"
#include "properties/search/campaign.h"
#include "tests/tools/program.h"
#include "tools/edge.h"
#include "tools/implementations/built_in.h"
#include "tools/shards/run_units.h"
#include "tools/shards/units.h"

namespace raycheck::tests {
namespace {

/// The path of a folder that does not exist yet and is removed with the test.
std::string fresh_folder(const std::string& name) {
  static const std::string all = temporary_folder("shards");
  return all + "/" + name;
}

std::vector<fs::path> units_in(const std::string& folder) {
  std::vector<fs::path> units;
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(folder, none)) {
    if (entry.path().extension() == ".unit") units.push_back(entry.path());
  }
  std::sort(units.begin(), units.end());
  return units;
}

struct Sharded {
  std::string name, asked;
  int exit_code = 0;
};
void PrintTo(const Sharded& one, std::ostream* out) { *out << one.name; }

const std::vector<Sharded> kSharded = {
    {"properties",
     "properties --level extreme --intersect quadratic --intersect cross --filter r --cases 60 "
     "--keep-going 3 --target rho",
     1},
    {"properties_someone_elses",
     "properties --candidate FLOATS --filter class --cases 150 --level extreme", 1},
    {"stress", "stress --family distance,far-camera --cases 80 --severity 2..4", 1},
    {"worst", "worst --method cross --family distance --cases 40 --steps 40 --searches 9", 0},
    {"check", "check FAR --intersect lecture --pixels 9000", 1}};

class ShardsOf : public testing::TestWithParam<Sharded> {
 protected:
  /// The command line, with FAR replaced by a scene of several units, and FLOATS by a library.
  static std::string asked() {
    const std::string line = GetParam().asked;
    if (has(line, "FAR")) return replaced(line, "FAR", resized_example("far-sphere.toml", 160));
    if (!has(line, "FLOATS")) return line;
    return replaced(line, "FLOATS", compiled("tests/candidates/float_quadratic.cpp"));
  }
  /// The report of one run without shards.
  static const std::string& whole() {
    static std::map<std::string, std::string> known;
    std::string& its = known[GetParam().name];
    if (its.empty()) its = run(asked() + " --format json", GetParam().exit_code).out;
    return its;
  }
};

/// There may be any number of workers, in any order, and some units twice.
TEST_P(ShardsOf, merge_to_the_report_of_one_run) {
  const auto& [name, line, exit_code] = GetParam();
  const std::string twice = fresh_folder(name + "_twice");
  run(asked() + " --shard 1/2 --out " + twice, 0);
  // The progress of units is the same for all commands.
  const std::vector<int> workers =
      name == "properties" ? std::vector<int>{1, 2, 7, 23} : std::vector<int>{3};
  for (const int of : workers) {
    const std::string folder = fresh_folder(fmt::format("{}_{}", name, of));
    for (int k = of; k >= 1; --k) {
      const Outcome shard = run(fmt::format("{} --shard {}/{} --out {}", asked(), k, of, folder));
      ASSERT_EQ(shard.exit_code, of == 1 ? exit_code : 0) << shard.err;
      EXPECT_EQ(lines_of(shard.err).front(),
                fmt::format("raycheck: shard {0} of {1} (--shard {0}/{1})", k, of));
    }
    EXPECT_EQ(
        run(fmt::format("merge --run-candidates {} {} --format json", folder, twice), exit_code)
            .out,
        whole())
        << of;
    EXPECT_EQ(run("merge --run-candidates --format json " + folder, exit_code).out, whole()) << of;
  }
}

/// A shard that is killed repeatedly resumes with the missing units.
TEST_P(ShardsOf, Hostile_that_are_killed_lose_and_repeat_no_unit) {
  const auto& [name, line, exit_code] = GetParam();
  const std::string folder = fresh_folder(name + "_killed");
  std::mt19937 random(7);
  std::size_t all = units_in(fresh_folder("none")).size();
  for (int kills = 0; kills < 5; ++kills) {
    const std::size_t until = units_in(folder).size() + random() % 3;
    const pid_t child = start_shell(fmt::format("exec {} {} --threads 1 --out {} >/dev/null 2>&1",
                                                RAYCHECK_BINARY, asked(), folder));
    int status = 0;
    bool is_over = false;
    EXPECT_TRUE(eventually([&] {
      is_over = waitpid(child, &status, WNOHANG) == child;
      return is_over || units_in(folder).size() > until;
    }));
    if (is_over) break;
    kill(child, SIGKILL);
    waitpid(child, &status, 0);
    all = units_in(folder).size();
  }
  EXPECT_GT(all, 0u);
  run(asked() + " --out " + folder, exit_code);
  EXPECT_EQ(run("merge --run-candidates --format json " + folder, exit_code).out, whole());
}

INSTANTIATE_TEST_SUITE_P(Commands, ShardsOf, testing::ValuesIn(kSharded),
                         [](const auto& its) { return its.param.name; });

const std::string kAsked =
    "properties --filter class --source rays --source distance --intersect cross --cases 90";

/// Each test has a copy of the folder of two shards.
class Merge : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    for (const int k : {1, 2})
      run(fmt::format("{} --shard {}/2 --out {}", kAsked, k, fresh_folder("merged")), 0);
  }
  void SetUp() override {
    fs::copy(fresh_folder("merged"), folder, fs::copy_options::recursive);
    ASSERT_GT(units_in(folder).size(), 4u);
  }
  std::string folder = fresh_folder(std::string("merge_") +
                                    testing::UnitTest::GetInstance()->current_test_info()->name());
};

TEST_F(Merge, names_a_missing_unit_and_the_command_that_computes_it) {
  const std::size_t all = units_in(folder).size();
  fs::remove(units_in(folder)[3]);
  fs::remove(units_in(folder)[3]);
  expect_refused(
      "merge " + folder,
      fmt::format("{}: unit 4 of {} is missing, and 1 more; to add the missing units, run "
                  "raycheck {} with this folder as --out",
                  folder, all,
                  "properties --filter class --cases 90 --intersect cross --source rays "
                  "--source distance"));
  run(kAsked + " --out " + folder, 0);
  EXPECT_EQ(run("merge " + folder, 0).out, run(kAsked, 0).out);
}

TEST_F(Merge, names_a_truncated_or_changed_unit) {
  const fs::path unit = units_in(folder)[2];
  const std::string whole = contents(unit);
  std::string tampered = whole;
  tampered[whole.size() / 2] ^= 1;
  // Such a file is not read.
  fs::resize_file(unit, std::uintmax_t{20} << 30);
  expect_refused("merge " + folder,
                 unit.string() + ": is larger than 256 MiB, the limit for a unit");
  std::string longer = whole;
  longer.insert(longer.find('\n'), "0");  // the stated size
  for (const std::string& bytes :
       {whole.substr(0, whole.size() / 2), std::string(), tampered, longer}) {
    std::ofstream(unit, std::ios::binary) << bytes;
    expect_refused("merge " + folder, unit.string() + ": is truncated or was changed");
    // A shard computes such a unit again.
    run(kAsked + " --shard 1/1 --out " + folder, 0);
    EXPECT_EQ(contents(unit), whole);
  }
}

TEST_F(Merge, does_not_overwrite_its_input) {
  const std::string file = folder + "/campaign.json", whole = contents(file);
  for (const std::string& written :
       {"--report json=" + file, "--view " + file, "--report junit=" + folder + "/new.xml",
        "--report json=" + folder + "//./campaign.json"}) {
    expect_refused("merge " + folder + " " + written, "the folder of a campaign's units");
  }
  expect_refused("merge " + folder + "/ --report json=" + file, "the folder of a campaign's units");
  EXPECT_EQ(contents(file), whole);
  run("merge " + folder, 0);
}

TEST_F(Merge, names_files_of_another_campaign) {
  const std::string other = fresh_folder("another");
  run(kAsked + " --seed 2 --out " + other, 0);
  expect_refused("merge " + folder + " " + other,
                 other +
                     ": holds units of raycheck properties --filter class --cases 90 --seed 2 "
                     "--intersect cross");
  expect_refused(kAsked + " --seed 3 --out " + folder, folder + ": holds units of");
  fs::copy_file(units_in(other)[0], fs::path(folder) / units_in(other)[0].filename());
  expect_refused("merge " + folder,
                 units_in(other)[0].filename().string() + ": does not belong to the campaign");
  // The file has the name of a unit of this campaign.
  fs::remove(fs::path(folder) / units_in(other)[0].filename());
  fs::copy_file(units_in(other)[0], units_in(folder)[0], fs::copy_options::overwrite_existing);
  expect_refused("merge " + folder, "is truncated or was changed");
  expect_refused("merge " + fresh_folder("nowhere"), "there is no such folder");
  expect_refused("merge tests",
                 "tests: is not a folder that a campaign wrote: campaign.json is missing");
  // A folder named like an option.
  expect_refused("merge format", "raycheck: format: there is no such folder");
}

TEST_F(Merge, identifies_candidates_by_content) {
  const std::string text = contents(RAYCHECK_SOURCE_DIR "/tests/candidates/float_quadratic.cpp");
  const std::string source = temporary_file("judged.cpp", text);
  const std::string asked =
      "properties --filter class --source rays --cases 60 --candidate source:";
  const std::string its = fresh_folder("judged");
  run(asked + source + " --shard 1/1 --out " + its, 0);
  std::ofstream(source, std::ios::app) << "// another\n";
  expect_refused("merge --run-candidates " + its, "holds units of another version of " + source);
  // A header in the folder counts, too.
  const std::string sources = fresh_folder("sources"), units = fresh_folder("of_sources");
  fs::create_directories(sources + "/deeper");
  std::ofstream(sources + "/deeper/mine.h") << "// mine\n";
  // It may be included in any way, because the compiler lists the files that it read.
  std::ofstream(sources + "/mine.cpp") << "#define MINE \"deeper/mine.h\"\n"
                                       << text << "%:/**/include MINE\n";
  for (const std::string& named : {sources, sources + "/mine.cpp"}) {
    fs::remove_all(units);
    const std::string line = asked + named + " --shard 1/1 --out " + units;
    for (int times = 0; times < 2; ++times) run(line, 0);
    std::ofstream(sources + "/deeper/mine.h", std::ios::app) << "// more\n";
    expect_refused(line, "deeper/mine.h");
  }
}

/// Arguments added to a folder by someone else are not executed.
TEST_F(Merge, refuses_options_that_shards_never_write) {
  const std::string file = folder + "/campaign.json", victim = temporary_file("victim", "mine");
  const nlohmann::json whole = nlohmann::json::parse(contents(file));
  const auto forge = [&](const std::string& command, const std::vector<std::string>& arguments,
                         bool has_digest = true) {
    nlohmann::json campaign = whole;
    campaign["command"] = command;
    for (const std::string& one : arguments) campaign["arguments"].push_back(one);
    // The digest matches the change.
    const tools::CampaignIdentity forged = {command, campaign["arguments"], campaign["version"],
                                            campaign["files"]};
    if (has_digest) campaign["digest"] = forged.digest();
    std::ofstream(file) << campaign.dump();
  };
  forge("properties", {"--view=victim.html"}, false);
  expect_refused("merge " + folder, file + ": is truncated or was changed");
  for (const std::vector<std::string>& added :
       std::vector<std::vector<std::string>>{{"--view", victim},
                                             {"--view=" + victim},
                                             {"--package", victim},
                                             {"--help"},
                                             {"-h"},
                                             {"--out", victim},
                                             {"--save", victim},
                                             {"--filter=" + victim},
                                             {"--filter"}}) {
    forge(added[0] == "--package" ? "grade" : "properties", added);
    expect_refused("merge " + folder, "its campaign has " + added[0] +
                                          ", which raycheck never writes: the folder was changed");
  }
  // The value of an option is not read as an option.
  forge("properties", {"--level", "--view=" + victim});
  expect_refused("merge " + folder, "--level");
  EXPECT_EQ(contents(victim), "mine");
}

/// Only the folder names the candidate.
TEST(Shards, with_candidates_are_merged_only_if_running_them_is_allowed) {
  const std::string folder = fresh_folder("runs"), ran = fresh_folder("ran");
  const std::string candidate =
      "command:python3 " +
      temporary_file("leaves_a_trace.py",
                     "open('" + ran + "', 'w')\n" +
                         contents(RAYCHECK_SOURCE_DIR "/tests/candidates/right.py"));
  const std::string asked =
      "properties --filter class --source rays --cases 20 --candidate '" + candidate + "'";
  const Outcome whole = run(asked + " --sandbox none --i-know", 0);
  expect_parts(run(asked + " --sandbox none --i-know --shard 1/2 --out " + folder, 0).err,
               {"once all are done: raycheck merge " + folder + " --run-candidates"});
  run(asked + " --sandbox none --i-know --shard 2/2 --out " + folder, 0);
  fs::remove(ran);
  const std::string warning =
      folder + ": its campaign runs candidates: raycheck properties --filter class --cases 20";
  const Outcome refused = run("merge --sandbox none --i-know " + folder, 2);
  expect_parts(refused.err,
               {warning, "'" + candidate + "'", "add --run-candidates if you trust them"});
  EXPECT_FALSE(fs::exists(ran));
  const Outcome merged = run("merge --run-candidates --sandbox none --i-know " + folder, 0);
  EXPECT_EQ(lines_of(merged.err).front().find("raycheck: " + warning), 0u) << merged.err;
  EXPECT_EQ(merged.out, whole.out);
  EXPECT_TRUE(fs::exists(ran));
}

/// The candidate hangs on some cases. This depends neither on earlier questions nor on the number
/// of threads.
TEST(Shards, with_time_outs_merge_to_the_report_of_one_run) {
  const std::string asked =
      "properties --candidate 'command:python3 tests/candidates/sometimes_hangs.py' "
      "--timeout 0.5 --filter class --source rays --source distance --cases 100 --format json";
  const std::string whole = run(asked + " --threads 1", 1).out;
  EXPECT_EQ(run(asked + " --threads 3", 1).out, whole);
  const std::string folder = fresh_folder("hangs");
  for (const int k : {3, 1, 2}) run(fmt::format("{} --shard {}/3 --out {}", asked, k, folder), 0);
  EXPECT_EQ(run("merge --run-candidates --format json " + folder, 1).out, whole);
}

/// Each request without a reply takes the whole time limit, so only a few are made, although there
/// are many laws and sources.
TEST(Shards, drop_a_candidate_that_never_replies) {
  const std::string starts = fresh_folder("starts");
  const std::string hangs = temporary_file(
      "hangs.py", "import raycheck_candidate as rc\nopen('" + starts +
                      "', 'a').write('x')\ndef intersect(*asked):\n    while True: pass\n"
                      "rc.run('hangs', intersect=intersect)\n");
  const std::string asked = "properties --candidate 'command:python3 " + hangs +
                            "' --sandbox none --i-know --timeout 0.3 --threads ";
  const std::string by_one = run(asked + "1", 1).out;
  EXPECT_TRUE(has(by_one, "gives no answers: intersect: "));
  EXPECT_LE(contents(starts).size(), 12u);  // a process for each
  EXPECT_EQ(run(asked + "2", 1).out, by_one);
}

TEST(Shards, are_set_by_schedulers) {
  struct Scheduler {
    std::vector<std::pair<const char*, std::string>> variables;
    std::string shard, message;
  };
  const std::vector<Scheduler> all = {
      {{{"SLURM_ARRAY_TASK_ID", "5"},
        {"SLURM_ARRAY_TASK_COUNT", "3"},
        {"SLURM_ARRAY_TASK_MIN", "4"}},
       "",
       "shard 2 of 3 (SLURM_ARRAY_TASK_ID=5)"},
      {{{"SLURM_ARRAY_TASK_ID", "7"},
        {"SLURM_ARRAY_TASK_COUNT", "4"},
        {"SLURM_ARRAY_TASK_MIN", "1"},
        {"SLURM_ARRAY_TASK_STEP", "3"}},
       "",
       "shard 3 of 4 (SLURM_ARRAY_TASK_ID=7)"},
      {{{"JOB_COMPLETION_INDEX", "0"}}, "--shard auto/4", "shard 1 of 4 (JOB_COMPLETION_INDEX=0)"},
      {{{"TEST_SHARD_INDEX", "2"}, {"TEST_TOTAL_SHARDS", "3"}},
       "",
       "shard 3 of 3 (TEST_SHARD_INDEX=2)"},
      {{{"CI_NODE_INDEX", "1"}, {"CI_NODE_TOTAL", "2"}}, "", "shard 1 of 2 (CI_NODE_INDEX=1)"},
      {{{"CI_NODE_INDEX", "1"}, {"CI_NODE_TOTAL", "2"}},
       "--shard 2/5",
       "shard 2 of 5 (--shard 2/5)"}};
  for (const Scheduler& scheduler : all) {
    std::vector<std::unique_ptr<Variable>> set;
    for (const auto& [name, value] : scheduler.variables)
      set.push_back(std::make_unique<Variable>(name, value));
    const Outcome outcome =
        run(fmt::format("{} {} --out {}", kAsked, scheduler.shard, fresh_folder("schedulers")), 0);
    EXPECT_EQ(lines_of(outcome.err).front(), "raycheck: " + scheduler.message);
    EXPECT_EQ(outcome.out, "");
  }
  expect_parts(
      run(kAsked + " --format json --shard 1/2 --out " + fresh_folder("schedulers"), 0).err,
      {"--format has no effect here: give it to raycheck merge"});
  // Without --out the variables are ignored.
  const Variable index("CI_NODE_INDEX", "1"), count("CI_NODE_TOTAL", "2");
  EXPECT_TRUE(has(run(kAsked, 0).out, "laws: 0 broken, 1 holds"));
}

TEST(Shards, refuse_invalid_numbers) {
  const std::string out = " --out " + fresh_folder("refused");
  expect_refused(kAsked + " --shard 0/3" + out, "there is no shard 0 of 3");
  expect_refused(kAsked + " --shard 4/3" + out, "there is no shard 4 of 3");
  expect_refused(kAsked + " --shard 2" + out, "--shard 2: give K/N");
  expect_refused(kAsked + " --shard two/3" + out, "'two' is not a whole number");
  expect_refused(kAsked + " --shard auto/3" + out, "auto needs a scheduler");
  expect_refused(kAsked + " --shard 1/3", "--shard requires --out");
  {
    const Variable index("JOB_COMPLETION_INDEX", "0");
    expect_refused(kAsked + out,
                   "JOB_COMPLETION_INDEX=0: the number of shards is unknown; give --shard auto/N");
  }
  {
    const Variable index("SLURM_ARRAY_TASK_ID", "9223372036854775807"),
        step("SLURM_ARRAY_TASK_STEP", "2");
    const Variable count("SLURM_ARRAY_TASK_COUNT", "2");
    expect_refused(kAsked + out,
                   "SLURM_ARRAY_TASK_ID: '9223372036854775807' is not a whole number");
    const Variable between("SLURM_ARRAY_TASK_ID", "3"), first("SLURM_ARRAY_TASK_MIN", "0");
    expect_refused(kAsked + out,
                   "SLURM_ARRAY_TASK_ID=3: is not 0 plus a multiple of SLURM_ARRAY_TASK_STEP=2");
  }
  const Variable index("CI_NODE_INDEX", "0"), count("CI_NODE_TOTAL", "2");
  expect_refused(kAsked + out, "CI_NODE_INDEX=0: there is no shard 0 of 2");
}

const tools::CampaignIdentity kCampaign = {"properties", {"--cases", "2"}, "1", {}};

TEST(Units, are_each_done_by_one_shard) {
  std::vector<int> done(100);
  for (std::int64_t k = 1; k <= 7; ++k) {
    tools::Units shard(kCampaign, fresh_folder("one"), {k, 7, {}});
    for (const std::int64_t unit : shard.open(100)) ++done[static_cast<std::size_t>(unit)];
  }
  EXPECT_EQ(done, std::vector<int>(100, 1));
}

TEST(Units, remove_temporary_files_of_killed_workers) {
  const std::string folder = fresh_folder("left");
  tools::Units(kCampaign, folder, {}).open(1);
  for (const char* name :
       {"000000-0123.unit.7.0badcafe.part", "000000-0123.unit.8.0badcafe.part", "mine.part"}) {
    std::ofstream(folder + "/" + name) << "some";
    const bool is_new = std::string(name).find(".8.") != std::string::npos;
    if (!is_new)
      fs::last_write_time(folder + "/" + name,
                          fs::file_time_type::clock::now() - std::chrono::hours(2));
  }
  tools::Units(kCampaign, folder, {}).open(1);
  std::vector<std::string> left = names_in(folder);
  std::sort(left.begin(), left.end());
  EXPECT_EQ(left, (std::vector<std::string>{"000000-0123.unit.8.0badcafe.part", "campaign.json",
                                            "mine.part"}));
}

TEST(Units, that_contradict_each_other_are_named) {
  const std::string a = fresh_folder("a"), b = fresh_folder("b");
  for (const auto& [folder, result] : {std::pair(a, "one"), {b, "another"}}) {
    tools::Units units(kCampaign, folder, {});
    units.open(1);
    units.write(0, result);
  }
  tools::Units both(kCampaign, std::vector<fs::path>{a, b});
  both.open(1);
  expect_parts(thrown_by([&] { both.read(0); }), {"contradict each other", a, b});
}

/// A shard with an option that is in neither table would fail.
TEST(Units, depend_on_listed_options_only) {
  std::set<std::string> known = {"--help",   "--out",     "--shard", "--replay",
                                 "--target", "--package", "--probe", "--for"};
  known.insert(std::begin(tools::kReportOptions), std::end(tools::kReportOptions));
  known.insert(std::begin(tools::kUnitOptions), std::end(tools::kUnitOptions));
  const std::regex option("\\n +(?:-[a-z],)?(--[a-z-]+)");
  for (const char* command : {"properties", "stress", "worst", "check", "grade"}) {
    const std::string help = run(std::string(command) + " --help", 0).out;
    std::size_t count = 0;
    for (std::sregex_iterator at(help.begin(), help.end(), option), end; at != end; ++at, ++count) {
      EXPECT_TRUE(known.contains((*at)[1])) << command << " " << (*at)[1];
    }
    EXPECT_GT(count, 10u) << command;
  }
}

TEST(Units, keep_every_bit_of_a_sketch) {
  properties::QuantileSketch sketch;
  const double kTiny = std::numeric_limits<double>::denorm_min();
  for (const double x :
       {0.0, kTiny, 3 * kTiny, 0x1.23456789p-1030, 0.1, 0.1, 1e300,
        std::numeric_limits<double>::max(), std::numeric_limits<double>::infinity()}) {
    sketch.add(x);
  }
  for (int k = 0; k < 3000; ++k) sketch.add(k * 0.37);
  const auto again = tools::from_bytes<properties::QuantileSketch>(tools::to_bytes(sketch));
  EXPECT_TRUE(again == sketch);
  EXPECT_EQ(again.quantile(0.999), sketch.quantile(0.999));
}

/// Results with every kind of part, and with arbitrary changed bytes, are at worst refused.
TEST(Units, refuse_bytes_that_are_not_a_result) {
  using Result = std::vector<properties::CampaignPart>;
  properties::CampaignOptions some;
  some.cases = 20;
  some.level = properties::Level::kExtreme;
  const properties::Candidate lecture = tools::candidate_of(tools::find_pair("lecture"));
  const Result made = properties::run_campaign(*properties::find_law("class"), lecture, some).parts;
  const std::string whole = tools::to_bytes(made);
  EXPECT_EQ(tools::to_bytes(tools::from_bytes<Result>(whole)), whole);
  const auto is_refused = [](const std::string& bytes) {
    return thrown_by([&] { tools::from_bytes<Result>(bytes); }) != "no error";
  };
  EXPECT_TRUE(is_refused(whole + '\0'));
  for (std::size_t size = 0; size < whole.size(); size += 1 + size / 50) {
    EXPECT_TRUE(is_refused(whole.substr(0, size))) << size;
  }
  const properties::DefectKind of_none[] = {
      {static_cast<properties::Quantity>(properties::kQuantityCount), {}},
      {{}, static_cast<properties::Wrong>(-1)}};
  for (const properties::DefectKind& kind : of_none) {
    EXPECT_THROW(tools::from_bytes<properties::DefectKind>(tools::to_bytes(kind)),
                 std::invalid_argument);
  }
  // The length exceeds any memory.
  EXPECT_TRUE(is_refused(std::string(8, '\xff') + whole.substr(8)));
  std::mt19937_64 random(1);
  std::size_t refused = 0;
  for (int k = 0; k < 20000; ++k) {
    std::string other = whole;
    other[random() % other.size()] = static_cast<char>(random());
    refused += is_refused(other) ? 1 : 0;
  }
  EXPECT_GT(refused, 100u);
}

}  // namespace
}  // namespace raycheck::tests
