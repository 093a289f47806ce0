// The option --certificates, and the script that checks certificates without raycheck.

#include "tests/tools/report/certificates.h"

namespace raycheck::tests {
namespace {

std::string script(const std::string& path) { return "tools/verify_certificates.py " + path; }

TEST(Certificates, are_confirmed_by_a_script_that_uses_only_fractions) {
  const Outcome result = script_on(certificates_of(kFarSphere + " --intersect quadratic"));
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_TRUE(
      has(result.out, "confirmed  direct/quadratic: class, pixel (2, 0), sphere 0: false hit"));
  EXPECT_TRUE(has(result.out, "10 confirmed, 0 refuted, 0 not certified"));
  std::set<std::string> modules;
  for (const auto& line : lines_of(contents(RAYCHECK_SOURCE_DIR "/tools/verify_certificates.py"))) {
    if (line.starts_with("import ") || line.starts_with("from ")) modules.insert(line);
  }
  EXPECT_EQ(modules,
            (std::set<std::string>{"import json", "import sys", "from fractions import Fraction",
                                   "from math import isqrt"}));
}

TEST(Certificates, cover_all_discrepancies_shown_also_excused_ones) {
  std::size_t compared = 0;
  std::size_t excused = 0;
  for (const char* options : {" --all", " --all --max-ulp 0 --top 3"}) {
    std::string report;
    const auto certificates =
        certificates_of(kNearestByAnUlp + options + " --format json", &report);
    const ordered_json parsed = ordered_json::parse(report);
    std::size_t at = 0;
    for (const auto& candidate : parsed.at("candidates")) {
      for (const auto& shown : candidate.at("worst")) {
        ASSERT_LT(at, certificates.size());
        const ordered_json& one = certificates[at++];
        EXPECT_EQ(one.at("method"), candidate.at("name"));
        for (const char* key : {"law", "quantity", "unit", "pixel", "ray", "sphere", "what",
                                "wrong", "excuse", "error"}) {
          EXPECT_EQ(one.at(key), shown.at(key)) << key << one;
        }
        excused += shown.at("excuse").is_null() ? 0 : 1;
      }
    }
    EXPECT_EQ(at, certificates.size());
    compared += at;
  }
  EXPECT_GE(compared, 20u);
  EXPECT_GE(excused, 5u);
}

/// The first fenced block of a language in docs/certificates.md.
std::string documented(const std::string& language) {
  const std::string page = contents(RAYCHECK_SOURCE_DIR "/docs/certificates.md");
  const std::string fence = "```" + language + "\n";
  const std::size_t begin = page.find(fence);
  if (begin == std::string::npos) return {};
  const std::size_t first = begin + fence.size();
  return page.substr(first, page.find("```", first) - first);
}

TEST(Certificates, look_as_documented) {
  const auto certificates = certificates_of(kFalseHit + " --intersect quadratic");
  ASSERT_EQ(certificates.size(), 1u);
  EXPECT_EQ(certificates[0], ordered_json::parse(documented("json")));
}

TEST(Certificates, of_given_rays_are_confirmed_by_the_documented_lines) {
  const std::string lines = temporary_file("lines.py", documented("python"));
  const auto printed_on = [&](const std::string& scene) {
    const std::string path = temporary_file("given.jsonl", "");
    run("check " + scene + " --intersect quadratic --certificates " + path);
    const Outcome result = run_python(lines + " " + path, 0);
    return result.out;
  };
  EXPECT_EQ(printed_on(kFalseHit), "false hit True\n");
  EXPECT_EQ(printed_on(kLostDigits).rfind("30324.91", 0), 0u) << printed_on(kLostDigits);
  EXPECT_TRUE(has(printed_on(kLostDigits), " True\n"));
  EXPECT_FALSE(has(printed_on(kLostDigits), "False"));
}

TEST(Certificates, name_ties_that_brackets_cannot_prove) {
  const std::string scene =
      temporary_file("tie.toml",
                     "[camera]\neye=[0,0,0]\nlook_at=[1,1,1]\nup=[0,1,0]\nnear=-4\nleft=-3\nright="
                     "3\nbottom=0\ntop=1\nwidth=2\nheight=2\n" +
                         sphere_text("0,0,0", "5"));
  const auto certificates = certificates_of(scene + " --rays lecture --max-ulp 0 --top 100");
  const auto tie = of_quantity(certificates, "class");
  EXPECT_EQ(tie.at("certified"), false);
  EXPECT_TRUE(has(tie.at("reason").get<std::string>(), "because square roots cancel"));
  EXPECT_FALSE(tie.contains("proof"));
  const Outcome result = script_on(certificates);
  EXPECT_EQ(result.exit_code, 0) << result.out;
  EXPECT_TRUE(
      has(result.out, "not certified  lecture/cross: class, pixel (0, 0), sphere 0: missed"));
}

TEST(Certificates, are_empty_without_discrepancies) {
  const std::string path = temporary_file("none.jsonl", "an older file\n");
  EXPECT_EQ(run("check scene/examples/optical-axis.toml --certificates " + path).exit_code, 0);
  EXPECT_EQ(contents(path), "");
  EXPECT_EQ(run_python(script(path)).out, "0 confirmed, 0 refuted, 0 not certified\n");
}

TEST(VerifyCertificates, fails_with_2_on_unreadable_files) {
  EXPECT_EQ(run_python("tools/verify_certificates.py").exit_code, 2);
  EXPECT_EQ(run_python(script("nowhere.jsonl")).exit_code, 2);
}

/// Runs the script on each given file separately, and prints its exit code and standard error.
constexpr const char* kRunsScriptOnEach = R"(import contextlib, io, json, runpy, sys
for path in sys.argv[1:]:
    sys.argv = ['verify_certificates.py', path]
    said, out, code = io.StringIO(), io.TextIOWrapper(io.BytesIO()), None
    with contextlib.redirect_stderr(said), contextlib.redirect_stdout(out):
        try:
            runpy.run_path('tools/verify_certificates.py', run_name='__main__')
        except SystemExit as end:
            code = end.code
    print(json.dumps([code, said.getvalue()]))
)";

TEST(VerifyCertificates, fails_with_2_at_the_first_line_that_is_not_a_certificate) {
  const auto certificate =
      of_quantity(certificates_of(kFalseHit + " --intersect quadratic"), "class");
  std::vector<std::pair<std::string, std::string>> lines = {
      {"no certificate", "it is not JSON"},
      {"", "it is not JSON"},
      {"\xff", "it is not UTF-8"},
      {"null", "certificate is not an object"},
      {"1", "certificate is not an object"},
      {"[]", "certificate is not an object"},
      {"{}", "certificate.method is missing"},
      {std::string(100000, '['), "it is nested too deeply"},
      {"{\"ray\":" + std::string(5000, '9') + "}",
       "an integer of more than 19 digits is not a string"}};
  // Computing a power of two with such an exponent would take longer than a lifetime.
  for (const auto& [where, value] : std::vector<std::pair<std::string, std::string>>{
           {"/pixel", "true"},
           {"/wrong", "1.5"},
           {"/error", "true"},
           {"/quantity", "[]"},
           {"/quantity", "\"mood\""},
           {"/precision", "{}"},
           {"/certified", "1"},
           {"/neighbourhood", "1e400"},
           {"/got", "[[1, 0], [1, 0]]"},
           {"/got/0", "[1, 1024]"},
           {"/exact", "[[1, -1000000000]]"},
           {"/conventions/root", "null"},
           {"/inputs/spheres/0/radius", "[1, 1000000000]"},
           {"/inputs/spheres/0/radius", "[true, 1]"},
           {"/inputs/ray/origin", "[[0, 0]]"},
           {"/proof/spheres/0/discriminant", "[1, 1, -1000000000]"},
           {"/proof/spheres/0/discriminant", "[\"1e9\", 1, 0]"},
           {"/proof/spheres/0", "null"},
           {"/excuse", R"({"kind": "witness", "amount": "1e1000000000", "witness": []})"},
           {"/excuse", R"({"kind": "witness", "witness": [{"input": "r", "share": "1e9999"}]})"},
           {"/excuse", R"({"kind": "witness"})"}}) {
    ordered_json malformed = certificate;
    malformed.at(ordered_json::json_pointer(where)) = "VALUE";
    lines.emplace_back(replaced(malformed.dump(), "\"VALUE\"", value), "");
  }
  std::string paths;
  for (std::size_t k = 0; k < lines.size(); ++k) {
    paths += " " + temporary_file("no" + std::to_string(k) + ".jsonl",
                                  certificate.dump() + "\n" + lines[k].first + "\n");
  }
  const auto ended = lines_of(run_python(temporary_file("each.py", kRunsScriptOnEach) + paths).out);
  ASSERT_EQ(ended.size(), lines.size());
  std::istringstream each(paths);
  for (std::size_t k = 0; k < lines.size(); ++k) {
    const auto& [line, why] = lines[k];
    std::string path;
    each >> path;
    const ordered_json result = ordered_json::parse(ended[k]);
    const std::string shown = line.substr(0, 2000), said = result[1];
    EXPECT_EQ(result[0], 2) << shown << said;
    EXPECT_TRUE(said.starts_with("verify_certificates.py: " + path + ":2: " + why))
        << shown << said;
    EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 1) << said;
  }
}

TEST(VerifyCertificates, prints_no_control_characters) {
  auto certificate = of_quantity(certificates_of(kFalseHit + " --intersect quadratic"), "class");
  certificate["method"] = "\x1b[31mmine";
  EXPECT_EQ(script_on({certificate}).out.rfind("confirmed  \\x1b[31mmine: class", 0), 0u);
}

}  // namespace
}  // namespace raycheck::tests
