#pragma once

#include "tests/tools/program.h"

namespace raycheck::tests {

/// If the tests run as root, --i-know is required.
inline const std::string kUnkept =
    std::string(" --sandbox none") + (geteuid() == 0 ? " --i-know" : "");

/// In this scene each of the mistakes that raycheck looks for gives a different picture.
inline const std::string kProbeScene = "scene/examples/probe.toml";

/// The JSON report of `check` for a candidate on a scene.
inline Outcome check(const std::string& scene, const std::string& candidate,
                     const std::string& more = "") {
  return run("check " + scene + " --format json " + more + " --candidate '" + candidate + "'");
}

inline json judged(const std::string& scene, const std::string& candidate,
                   const std::string& more = "") {
  const Outcome outcome = check(scene, candidate, more);
  EXPECT_TRUE(outcome.exit_code == 0 || outcome.exit_code == 1)
      << candidate << ": " << outcome.exit_code << "\n"
      << outcome.err;
  if (outcome.out.empty()) return {};
  return json::parse(outcome.out)["candidates"][0];
}

/// The report of one quantity; null if it is missing.
inline json quantity_of(const json& quantities, const std::string& name) {
  return found(quantities, "name", name);
}

/// The JSON report of a command with this exit code.
inline json report_of(const std::string& arguments, const std::string& candidate, int exit_code) {
  const Outcome outcome = run(arguments + " --format json --candidate '" + candidate + "'");
  EXPECT_EQ(outcome.exit_code, exit_code) << arguments << "\n" << outcome.out << outcome.err;
  return json::parse(outcome.out, nullptr, false);
}

/// A renderer made of these lines of Python, after imports. `words` come before its file arguments.
inline std::string python_renderer(const std::string& lines, const std::string& words = "") {
  static int count = 0;
  const std::string path =
      temporary_file("lines" + std::to_string(++count) + ".py",
                     "import ctypes, os, signal, subprocess, sys, time\n" + lines + "\n");
  return "renderer:python3 " + path + " " + words + (words.empty() ? "" : " ") + "{scene} {image}";
}

/// A tracer in Python that computes both roots correctly, by the cross product. It returns the
/// first root for which `counts` is true, in the form `returns`; `says` are its declarations.
inline std::string tracer(const std::string& name, const std::string& counts,
                          const std::string& returns, const std::string& says) {
  return "command:python3 " + temporary_file(name, R"(import math, raycheck_candidate as rc
def cross(p, q):
    return (p[1]*q[2] - p[2]*q[1], p[2]*q[0] - p[0]*q[2], p[0]*q[1] - p[1]*q[0])
def dot(p, q):
    return p[0]*q[0] + p[1]*q[1] + p[2]*q[2]
def intersect(ray, sphere, by):
    (o, d), (c, r), roots = ray, sphere, by.roots
    t = [x - y for x, y in zip(c, o)]
    a, b, m = dot(d, d), dot(t, d), cross(t, d)
    length, unit = math.sqrt(a), r if roots.unit == 'radius' else 1
    under = a * r * r - dot(m, m)
    if under < 0: return None
    q = b + math.copysign(math.sqrt(under), b)
    other = (math.sqrt(dot(t, t)) - r) * (math.sqrt(dot(t, t)) + r) / q if q else 0.0
    for s in sorted((q / a, other)):
        point = [x + s * y for x, y in zip(o, d)]
        if )" + counts + ": return " + returns + R"(
rc.run('mine', intersect=intersect, root='nearest', **{'tangent': 'either'} | dict()" +
                                                       says + "))\n");
}

/// The first lines of a candidate's source that makes one library of several candidates: of each,
/// chosen() makes a copy, in which these are its name and its declarations.
inline const std::string kChoice =
    "#include <cstring>\nchar choice[] = \"" + std::string(96, '@') + "\";\n" +
    "bool is_chosen(const char* name) { return std::strcmp(choice, name) == 0; }\n"
    "const char* contract_of() { return choice + std::strlen(choice) + 1; }\n";

inline std::string chosen(const std::string& library, const std::string& name,
                          const std::string& contract) {
  static int count = 0;
  std::string bytes = contents(library.substr(library.find(':') + 1));
  const std::string choice = name + '\0' + contract + '\0';
  const std::size_t at = bytes.find(std::string(96, '@'));
  EXPECT_NE(at, std::string::npos) << library;
  bytes.replace(at, choice.size(), choice);
  return "library:" + temporary_file(name + std::to_string(++count) + ".so", bytes);
}

/// The processes whose command line contains this text.
inline std::vector<pid_t> processes_with(const std::string& text) {
  std::vector<pid_t> found;
  for (const auto& entry : fs::directory_iterator("/proc")) {
    if (!has(contents(entry.path() / "cmdline"), text)) continue;
    found.push_back(std::atoi(entry.path().filename().c_str()));
  }
  return found;
}

/// tests/candidates/right.cpp, built once for all tests.
inline const std::string& right_library() {
  static const std::string library =
      "library:" + built_submission("right.cpp", "right", temporary_folder("library"));
  return library;
}

}  // namespace raycheck::tests
