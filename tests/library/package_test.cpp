// Makes the Debian packages from the build, unpacks them in an empty folder, and uses them from
// there.

#include <unistd.h>

#include "tests/library/shell.h"

namespace raycheck::tests {
namespace {

namespace fs = std::filesystem;

const std::vector<std::string> kPackages = {"raycheck", "libraycheck0", "libraycheck-dev",
                                            "python3-raycheck"};

bool is_installed(const std::string& program) { return shell("command -v " + program).code == 0; }

/// The packages and the folder in which they are unpacked, made once for all tests.
class NightlyPackage : public testing::Test {
 protected:
  static fs::path folder() { return fs::path(RAYCHECK_BUILD) / "tests/packages"; }
  static fs::path prefix() { return folder() / "root/usr"; }

  static std::string as_root() { return geteuid() == 0 ? "" : "fakeroot "; }
  static bool can_be_made() {
    return is_installed("dpkg-shlibdeps") && is_installed("file") &&
           (as_root().empty() || is_installed("fakeroot"));
  }
  void SetUp() override {
    if (!can_be_made()) {
      GTEST_SKIP() << "dpkg-dev, file or, where tests are not root's, fakeroot is not installed";
    }
    // Fails here, since tests of a suite whose set-up fails are skipped.
    ASSERT_EQ(why_not_made(), "");
  }
  static std::string& why_not_made() {
    static std::string why;
    return why;
  }

  static void SetUpTestSuite() {
    if (!can_be_made()) return;
    why_not_made() = make();
  }

  /// Returns the error; empty on success.
  static std::string make() {
    fs::remove_all(folder());
    const std::string build = RAYCHECK_BUILD;
    const Ended made =
        shell("cpack --config '" + build + "/CPackConfig.cmake' -B '" +
              (folder() / "made-here").string() + "' -D CPACK_DEBIAN_COMPRESSION_TYPE=gzip");
    if (made.code != 0) return made.text;
    const fs::path admin = folder() / "root/var/lib/dpkg";
    for (const char* below : {"info", "updates", "triggers"}) fs::create_directories(admin / below);
    std::ofstream(admin / "status").flush();
    // Dependencies are not installed in this root. A file in two of the packages is an error.
    const Ended unpacked = shell(as_root() + "dpkg --root='" + (folder() / "root").string() +
                                 "' --log=/dev/null --force-not-root --unpack " + all());
    return unpacked.code == 0 ? "" : unpacked.text;
  }

  static fs::path file_of(const std::string& package) {
    for (const auto& entry : fs::directory_iterator(folder() / "made-here")) {
      const std::string name = entry.path().filename().string();
      if (name.starts_with(package + "_") && name.ends_with(".deb")) return entry;
    }
    ADD_FAILURE() << package << " was not made";
    return {};
  }
  static std::string all() {
    std::string names;
    for (const std::string& package : kPackages) names += "'" + file_of(package).string() + "' ";
    return names;
  }
  static std::string field(const std::string& package, const std::string& name) {
    return shell("dpkg-deb -f '" + file_of(package).string() + "' " + name).text;
  }
  /// The files of a package and the targets of its links, one per line.
  static std::string contents(const std::string& package) {
    return shell("dpkg-deb -c '" + file_of(package).string() + "'").text;
  }
  static std::string control(const std::string& package, const std::string& name) {
    return shell("dpkg-deb -I '" + file_of(package).string() + "' " + name).text;
  }
};

TEST_F(NightlyPackage, HasItsFiles) {
  const std::string programs = contents("raycheck"), library = contents("libraycheck0"),
                    development = contents("libraycheck-dev");
  for (const char* file :
       {"bin/raycheck\n", "libexec/raycheck/raycheck-check\n", "libexec/raycheck/raycheck-jail\n",
        "man1/raycheck-check.1.gz\n", "bash-completion/completions/raycheck\n",
        "share/raycheck/rubrics/", "share/raycheck/cluster/raycheck.sbatch\n"}) {
    EXPECT_TRUE(has(programs, file));
  }
  EXPECT_FALSE(has(programs, "libraycheck"));
  EXPECT_TRUE(has(library, "libraycheck.so.0 -> libraycheck.so.0."));
  EXPECT_FALSE(has(library, "include"));
  for (const char* file : {"libraycheck.so -> libraycheck.so.0\n", "include/raycheck/exact.h\n",
                           "include/raycheck/candidate.hpp\n", "raycheck.pc\n",
                           "raycheckConfig.cmake\n", "examples/consumer-gtest/CMakeLists.txt\n"}) {
    EXPECT_TRUE(has(development, file));
  }
  for (const std::string& package : kPackages) {
    const fs::path documents = prefix() / "share/doc" / package;
    EXPECT_TRUE(has(raycheck::contents(documents / "copyright"), "License: Expat"));
    EXPECT_TRUE(fs::exists(documents / "changelog.gz")) << package;
  }
}

TEST_F(NightlyPackage, DependsOnLinkedLibraries) {
  for (const char* library : {"libgmp10 ", "libflint", "libstdc++6 ", "libc6 "}) {
    EXPECT_TRUE(has(field("libraycheck0", "Depends"), library));
    EXPECT_TRUE(has(field("raycheck", "Depends"), library));
  }
  const std::string version = field("libraycheck0", "Version");
  const std::string same = " (= " + version.substr(0, version.find('\n')) + ")";
  EXPECT_EQ(field("libraycheck-dev", "Depends"), "libraycheck0" + same + "\n");
  EXPECT_TRUE(has(field("raycheck", "Depends"), "libraycheck-dev" + same));
  EXPECT_EQ(control("libraycheck0", "shlibs").rfind("libraycheck 0 libraycheck0 (>= ", 0), 0u)
      << control("libraycheck0", "shlibs");
  EXPECT_TRUE(has(control("libraycheck0", "triggers"), "ldconfig"));
}

TEST_F(NightlyPackage, ServesConsumers) {
  const fs::path to = folder() / "built/consumer-gtest";
  const Ended made = build_example(prefix(), "consumer-gtest", to);
  ASSERT_EQ(made.code, 0) << made.text;
  const std::string nearest =
      (to / "tracer_test").string() + " --gtest_filter=Tracer.nearest_root/*";
  const Ended good = shell(nearest);
  EXPECT_EQ(good.code, 0) << good.text;
  EXPECT_TRUE(has(good.text, "[  PASSED  ]"));
  EXPECT_EQ(shell("TRACER_MISTAKE=far_root " + nearest).code, 1);
}

/// The program uses the rubric, the headers and the adapters in the package, not the sources.
TEST_F(NightlyPackage, HasAProgramThatJudgesAndSendsAnAutograder) {
  const std::string raycheck = (prefix() / "bin/raycheck").string();
  const fs::path rubric = prefix() / "share/raycheck/rubrics/lecture7";
  const Ended judged =
      shell("cd / && " + raycheck + " check " + (rubric / "far.toml").string() +
            " --sandbox none --i-know --pixels 4 --candidate source:" + RAYCHECK_SOURCE_DIR +
            "/tests/candidates/right.cpp");
  EXPECT_EQ(judged.code, 0) << judged.text;
  const fs::path archive = folder() / "autograder.zip";
  const Ended packed =
      shell("cd / && " + raycheck + " grade lecture7.toml --package " + archive.string());
  EXPECT_EQ(packed.code, 0) << packed.text;
  const Ended listed = shell("python3 -m zipfile -l " + archive.string());
  for (const char* file : {"raycheck/include/raycheck/candidate.hpp", "raycheck/lib/libgmp.so.10",
                           "raycheck/share/raycheck/raycheck_candidate.py"}) {
    EXPECT_TRUE(has(listed.text, file));
  }
  // The bundle for graders has the package's program, which loads the libraries in the bundle.
  const std::string sent = (folder() / "sent").string();
  const Ended loaded = shell("python3 -m zipfile -e " + archive.string() + " " + sent + " && ldd " +
                             sent + "/raycheck/libexec/raycheck/raycheck-grade | grep libgmp");
  EXPECT_TRUE(has(loaded.text, sent));
}

TEST_F(NightlyPackage, PassesLintian) {
  if (!is_installed("lintian")) GTEST_SKIP() << "lintian is not installed";
  const Ended said = shell("lintian --allow-root --fail-on error,warning " + all());
  EXPECT_EQ(said.code, 0) << said.text;
  EXPECT_EQ(said.text, "");
}

}  // namespace
}  // namespace raycheck::tests
