// Only files of raycheck are replaced or removed, and nothing is written into submissions. Tests
// also the folder in which a submission's renderer runs.

#include "tests/tools/grade/grading.h"

namespace raycheck::tests {
namespace {

/// Every file below a folder; links as their targets.
std::map<std::string, std::string> files_below(const std::string& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const bool is_link = entry.is_symlink();
    files[entry.path()] = is_link                   ? fs::read_symlink(entry.path()).string()
                          : entry.is_regular_file() ? contents(entry.path())
                                                    : "folder";
  }
  return files;
}

class HostileOut : public testing::Test {
 public:
  HostileOut()
      : rubric_(grading_.short_rubric("", kPixelZeroZero)),
        mine_(grading_.submit_built("mine", "rt.cpp", "mirrored")) {
    for (const char* name : {"README.txt", "CMakeLists.txt", "scene.toml", "results.json"}) {
      grading_.write(std::string("submissions/mine/") + name, "handed in");
    }
  }

  /// Expects that the command exits with 2 and a reason, and changes no file.
  void refuses(const std::string& words, const std::string& why) {
    const auto before = files_below(grading_.path("."));
    const Outcome outcome = run(words, 2);
    expect_parts(outcome.err, {why});
    EXPECT_EQ(outcome.out, "") << words;
    EXPECT_EQ(files_below(grading_.path(".")), before) << words;
  }
  std::string grade_words(const std::string& out) const {
    return grading_.arguments(rubric_, {mine_}, out);
  }
  std::string try_words(const std::string& out) const {
    return "try '" + rubric_ + "' '" + mine_ + "' --out '" + grading_.path(out) + "'";
  }

  Grading grading_;
  std::string rubric_, mine_;
};

TEST_F(HostileOut, IsRefusedIfItIsContainsOrLiesInASubmission) {
  fs::create_directory(grading_.path("linked"));
  fs::create_directory_symlink(mine_, grading_.path("linked/mine"));
  fs::create_directory_symlink(grading_.path("submissions"), grading_.path("also"));
  grading_.write("submissions/mine/below/file", "");
  for (const auto& words : {&HostileOut::grade_words, &HostileOut::try_words}) {
    const auto out = [&](const char* folder) { return (this->*words)(folder); };
    refuses(out("submissions/mine"),
            " is " + mine_ + ", which is a submission; give another folder");
    refuses(out("submissions/mine/"), " is " + mine_ + ", which");
    refuses(out("submissions"), " holds " + mine_ + ", which is a submission");
    refuses(out("."), " holds " + mine_);
    refuses(out("also"), " holds " + mine_);
    refuses(out("submissions/mine/below"), " lies in " + mine_);
    refuses(out("submissions/mine/new/one"), " lies in " + mine_);
    refuses(out("linked"), "linked/mine is " + mine_);
  }
}

TEST_F(HostileOut, KeepsFilesThatRaycheckDidNotWrite) {
  const std::string notes = grading_.write("out/mine/notes.txt", "do not lose");
  const std::string scene = grading_.write("out/mine/other.toml", "do not lose");
  const std::string above = grading_.write("out/README.txt", "do not lose");
  for (int time = 0; time < 2; ++time) {
    run(grade_words("out"), 0);
    EXPECT_FALSE(grading_.file("mine", "pixel-0-0.toml").empty());
  }
  run(try_words("out"), 1);
  for (const std::string& file : {notes, scene, above}) EXPECT_EQ(contents(file), "do not lose");
}

TEST_F(HostileOut, IsRefusedIfAResultWouldReplaceAForeignFile) {
  for (const char* name :
       {"index.html", "grades.csv", "mine/report.html", "mine/result.json", "mine/figures.html",
        "mine/pixel-0-0.toml", "mine/pixel-0-0.txt", ".raycheck-files"}) {
    const std::string file = grading_.write(std::string("out/") + name, "someone's");
    refuses(grade_words("out"), file);
    fs::remove(file);
  }
  fs::create_symlink(mine_ + "/README.txt", grading_.path("out/mine/report.html"));
  refuses(grade_words("out"), "out/mine/report.html");
  refuses(try_words("out"), "out/mine/report.html");
}

TEST_F(HostileOut, HasItsFilesReplacedUnlessTheyWereEdited) {
  EXPECT_EQ(run(grade_words("out")).exit_code, 0);
  const std::string scene = grading_.path("out/mine/pixel-0-0.toml");
  const std::string page = grading_.path("out/mine/report.html");
  EXPECT_TRUE(fs::exists(scene));
  const std::string original = contents(page);
  grading_.write("out/mine/report.html", original + "<p>2 points more: see me</p>");
  refuses(grade_words("out"),
          page + " was not written by raycheck, or has changed since; move it away");
  grading_.write("out/mine/report.html", original);
  fs::remove_all(mine_);
  grading_.submit_built("mine", "rt.cpp", "none");
  EXPECT_EQ(run(grade_words("out")).exit_code, 0);
  EXPECT_FALSE(fs::exists(scene)) << "of an earlier grade";
  EXPECT_NE(contents(page), original);
}

TEST_F(HostileOut, IsRefusedIfItIsAnInputFile) {
  const std::string root = RAYCHECK_SOURCE_DIR;
  const std::string toml = contents(root + "/scene/examples/far-sphere.toml");
  const std::string scene = grading_.write("scene.ppm", toml);
  const std::string beside = grading_.write(
      "lecture7/orientation.toml", contents(root + "/examples/rubrics/lecture7/orientation.toml"));
  fs::create_symlink(rubric_, grading_.path("link.zip"));
  const std::string source = grading_.submit("source", "rays.py") + "/rays.py";
  const std::string known = grading_.write("known.baseline", "");
  const std::string candidate = " --candidate 'source:" + source + "'";
  const std::string of_rubric = "grade '" + rubric_ + "' --package";
  for (const auto& [words, file] : std::vector<std::pair<std::string, std::string>>{
           {of_rubric, rubric_},
           {of_rubric, grading_.path("link.zip")},
           {of_rubric, beside},
           {"image '" + scene + "' --out", scene},
           {"check '" + scene + "' --certificates", scene},
           {"check '" + scene + "' --report", "text=" + scene},
           {"check '" + scene + "' --update-baseline --baseline", scene},
           {"check '" + scene + "'" + candidate + " --certificates", source},
           {"tradeoff '" + scene + "' --view", scene},
           {"properties --cases 3" + candidate + " --view", source},
           {"properties --cases 3" + candidate + " --report", "json=" + source},
           {"stress --family distance" + candidate + " --view", source},
           {"tradeoff --cases 9" + candidate + " --view", source},
           {"worst --family distance" + candidate + " --save", source},
           {"worst --family distance" + candidate + " --view", source},
           {"view '" + scene + "' --out", scene},
           {"view --family distance" + candidate + " --out", source},
           {"check '" + scene + "' --baseline '" + known + "' --view", known}}) {
    refuses(words + " '" + file + "'", "; give another file");
  }
}

TEST_F(HostileOut, MayHaveTheNameOfAMethod) {
  const std::string words =
      "cd '" + grading_.path(".") +
      "' && exec '" RAYCHECK_BINARY
      "' worst --method cross --family distance --cases 9 --steps 3 --save cross\n";
  for (int run = 0; run < 2; ++run) {
    run_bash(words, 0);
  }
}

TEST_F(HostileOut, IsNamedOnceInTheError) {
  const std::string scene = std::string(RAYCHECK_SOURCE_DIR) + "/scene/examples/far-sphere.toml";
  const std::string one = grading_.path("x"), same = grading_.path("./x");
  const std::string twice = ": the file would be written twice";
  refuses("check " + scene + " --view " + one + " --report json=" + same, twice);
  refuses("check " + scene + " --report text=" + one + " --report json=" + same, twice);
  refuses("check " + scene + " --certificates " + one + " --view " + same, twice);
  refuses("check " + scene + " --baseline " + one + " --update-baseline --view " + same, twice);
  refuses("worst --method cross --family distance --save " + one + " --view " + one, twice);
  refuses("stress --family distance --certificates " + one + " --view " + same, twice);
}

/// A submission, and what its renderer does before it writes to a file.
struct InRunFolder {
  const char* name;  ///< A property of the folder.
  std::string before, to;
  std::map<std::string, std::string> files = {};
  std::vector<std::string> notes = {};
};

std::map<std::string, std::string> many_files() {
  std::map<std::string, std::string> files = {{"last.txt", ""}};
  for (int k = 0; k < 150; ++k) files["below/" + std::to_string(k) + ".txt"] = "few words";
  return files;
}

const InRunFolder kInRunFolder[] = {
    {"has empty folders",
     "",
     "'output/deep/image.ppm'",
     {},
     {"it writes image.ppm and ignores the given file name"}},
    {"has files",
     "assert open('config/size.txt').read() == 'large'\n"
     "assert len(open('config/table.txt').read()) == 300000\n",
     "sys.argv[2]",
     {{"config/size.txt", "large"}, {"config/table.txt", std::string(300000, '7')}}},
    {"has a limited number of files, those near the top first",
     "assert os.path.exists('last.txt')\n"
     "count = sum(len(d) + len(f) for _, d, f in os.walk('.'))\n"
     "assert count == 101, count\n",
     "sys.argv[2]", many_files()},
    {"is the same whenever it runs",
     "assert open('count.txt').read() == '0'\n"
     "assert not os.path.exists('new.txt')\n"
     "open('count.txt', 'w').write('1')\n"
     "open('new.txt', 'w')\n",
     "sys.argv[2]",
     {{"count.txt", "0"}}},
    {"lets no run change a large file of a later one",
     "assert open('table.txt').read(1) == '7'\n"
     "try: open('table.txt', 'r+').write('8')\n"
     "except OSError: pass\n"
     "else: sys.exit(3 if os.path.islink('table.txt') else 0)\n",
     "sys.argv[2]",
     {{"table.txt", std::string(300000, '7')}}},
    // Files with likely names and with the driver file's name, and folders with names that a run
    // uses.
    {"has no picture that was handed in",
     "assert not os.path.exists('out.ppm')\nassert not os.path.exists('drawn')\n",
     "'mine.ppm'",
     {{"out.ppm", "P3 1 1 255 0 0 0\n"},
      {"scene.ppm", "P3 1 1 255 0 0 0\n"},
      {"drawn", "P3 1 1 255 0 0 0\n"},
      {"image.ppm/a.txt", "P3 1 1 255 0 0 0\n"},
      {"scene.txt/b", "P3 1 1 255 0 0 0\n"},
      {"mine.ppm", "P3 1 1 255 0 0 0\n"}},
     {"it writes mine.ppm and ignores the given file name"}}};

TEST(HostileRunFolder, HasTheFilesOfTheHandInAndNoOthers) {
  const Grading grading;
  std::vector<std::string> folders;
  for (const auto& [name, before, to, files, notes] : kInRunFolder) {
    const std::string folder = std::string("submissions/") + name;
    grading.write(folder + "/rt.py", renderer_in_python(before, to));
    for (const auto& [file, text] : files) grading.write(folder + "/" + file, text);
    folders.push_back(grading.path(folder));
  }
  fs::create_directories(folders[0] + "/output/deep");
  grading.grade(grading.write("rubric.toml", full_rubric(3)), folders);
  for (const InRunFolder& one : kInRunFolder) {
    const nlohmann::json result = grading.result(one.name);
    EXPECT_EQ(result["score"], 10) << result.dump(2);
    EXPECT_EQ(result["notes"], nlohmann::json(one.notes));
  }
}

TEST(HostileRunFolder, OfAnotherHandInIsNotReusedFromTheStore) {
  const Grading grading;
  const std::string rubric = grading.write("rubric.toml", full_rubric(1));
  grading.write("mine/rt.py", renderer_in_python("assert h == 25 or os.path.isdir('output')\n"));
  grading.grade(rubric, {grading.path("mine")});
  EXPECT_EQ(grading.result("mine")["score"], 0) << "there is no folder output";
  fs::create_directories(grading.path("mine/output"));
  grading.grade(rubric, {grading.path("mine")});
  EXPECT_EQ(grading.result("mine")["score"], 10);
}

}  // namespace
}  // namespace raycheck::tests
