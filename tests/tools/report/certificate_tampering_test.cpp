// A certificate with a changed claim, input or proof is refuted.

#include "tests/tools/report/certificates.h"

namespace raycheck::tests {
namespace {

using Pointer = ordered_json::json_pointer;

/// Adds one to the integer at a place, which may be a number or a string of digits.
void add_one(ordered_json& integer) {
  if (integer.is_number_integer()) {
    integer = integer.get<std::int64_t>() + 1;
    return;
  }
  std::string digits = integer;
  digits.back() = digits.back() == '9' ? '8' : static_cast<char>(digits.back() + 1);
  integer = digits;
}

/// A place in a certificate, and the number to put there; if there is no number, the integer there
/// grows by one.
struct Tampering {
  const char* where;
  std::string value = {};
};

void expect_refuted(const ordered_json& certificate, const std::vector<Tampering>& tamperings) {
  std::vector<ordered_json> certificates = {certificate};
  for (const Tampering& tampering : tamperings) {
    ordered_json tampered = certificate;
    ordered_json& place = tampered.at(Pointer(tampering.where));
    if (tampering.value.empty()) {
      add_one(place);
    } else {
      place = ordered_json::parse(tampering.value);
    }
    EXPECT_NE(tampered, certificate) << tampering.where;
    certificates.push_back(std::move(tampered));
  }
  const Outcome result = script_on(certificates);
  EXPECT_EQ(result.exit_code, 1) << result.err;
  const std::vector<std::string> lines = lines_of(result.out);
  ASSERT_GT(lines.size(), tamperings.size());
  EXPECT_TRUE(lines[0].starts_with("confirmed")) << lines[0] << certificate;
  for (std::size_t k = 0; k < tamperings.size(); ++k) {
    EXPECT_TRUE(lines[k + 1].starts_with("REFUTED") && !has(lines[k + 1], "malformed"))
        << tamperings[k].where << " " << tamperings[k].value << ": " << lines[k + 1];
  }
}

TEST(TamperedCertificates, of_a_class_are_refuted) {
  const auto certificate =
      of_quantity(certificates_of(kFalseHit + " --intersect quadratic"), "class");
  expect_refuted(certificate, {{"/wrong", R"("missed")"},
                               {"/got", "[]"},
                               {"/exact", "[[1, 35]]"},
                               {"/proof/spheres/0/root", R"("smaller")"},
                               {"/proof/spheres/0/discriminant/0"},
                               {"/proof/spheres/0/discriminant", "[0, 0, 0]"},
                               {"/inputs/ray/direction/0/0"},
                               {"/inputs/spheres/0/centre/2/0"},
                               {"/inputs/spheres/0/radius", "[1, 0]"},
                               {"/proof/spheres", "[]"}});
}

TEST(TamperedCertificates, of_a_parameter_are_refuted) {
  const auto certificates = certificates_of(kLostDigits + " --intersect quadratic");
  const auto parameter = of_quantity(certificates, "parameter");
  const ordered_json s = parameter.at(Pointer("/proof/spheres/0/s"));
  const std::string low = s.at(0);
  const std::string high = s.at(1);
  constexpr std::size_t kCut = 25;
  const ordered_json wide = {low.substr(0, low.size() - kCut) + std::string(kCut, '0'),
                             high.substr(0, high.size() - kCut) + std::string(kCut, '9'), s.at(2)};
  const ordered_json only_low = {low, low, s.at(2)};
  const ordered_json only_high = {high, high, s.at(2)};
  expect_refuted(parameter, {{"/proof/spheres/0/s", wide.dump()},
                             {"/proof/spheres/0/s", only_low.dump()},
                             {"/proof/spheres/0/s", only_high.dump()},
                             {"/proof/spheres/0/s/2"},
                             {"/proof/spheres/0/root", R"("larger")"},
                             {"/proof/spheres/0/c/0"},
                             {"/proof/spheres/0/b/0"},
                             {"/exact/0/0"},
                             {"/error", "480"},
                             {"/error", R"("infinity")"},
                             {"/got/0/1"},
                             {"/conventions/root", R"("smaler")"}});
  expect_refuted(of_quantity(certificates, "hit point"),
                 {{"/error", "525"}, {"/exact/1/0"}, {"/got/2/1"}, {"/inputs/ray/origin/0/0"}});
  expect_refuted(of_quantity(certificates, "sphere residual"),
                 {{"/error", "600000"}, {"/proof/norms/0/0", "\"1\""}, {"/got/0/1"}});
}

TEST(TamperedCertificates, of_the_nearest_sphere_are_refuted) {
  const auto certificate =
      of_quantity(certificates_of(kNearestByAnUlp + " --intersect quadratic"), "nearest sphere");
  expect_refuted(certificate, {{"/exact", "[[0, 0]]"},
                               {"/exact", "[]"},
                               {"/got", "[[1, 0]]"},
                               {"/wrong", R"("missed")"},
                               {"/inputs/spheres/1/radius/0"},
                               {"/proof/spheres/1/s/0", R"("99999999999999999999")"},
                               {"/proof/spheres/0/root", "null"}});
}

/// The first certificate of a quantity on a scene that has a witness.
ordered_json with_witness(const std::string& scene, const std::string& quantity) {
  for (auto& one : certificates_of(scene + " --all --top 30")) {
    const ordered_json& excuse = one.at("excuse");
    const bool has_witness = !excuse.is_null() && excuse.at("kind") == "witness";
    if (has_witness && one.at("quantity") == quantity) return one;
  }
  throw std::runtime_error("no witness of a " + quantity);
}

TEST(TamperedCertificates, of_a_witness_are_refuted) {
  const auto false_hit = with_witness("tests/regressions/tangent-one-ulp-outside.toml", "class");
  expect_refuted(false_hit, {{"/excuse/witness", "[]"},
                             {"/excuse/witness/0/share", R"("0x1.1p-49")"},
                             {"/excuse/witness/0/share", R"("-0x1.0000000000001p-49")"},
                             {"/excuse/witness/1/share", R"("-0x1p-49")"},
                             {"/excuse/witness/1/input", R"("origin.z")"},
                             {"/excuse/witness/1/input", R"("eye.y")"},
                             {"/excuse/witness/1/input", R"("spheres[0].radius")"},
                             {"/excuse/witness/3/share", R"("-0x1p-49")"},
                             {"/excuse/amount", "1e-9"},
                             {"/neighbourhood", "1e-15"},
                             {"/got", "[[5, 1]]"},
                             {"/got", R"(["nan"])"}});
  const auto missed = with_witness("tests/regressions/planet-horizon.toml", "class");
  expect_refuted(missed, {{"/excuse/witness", R"([{"input": "radius", "share": "0x1p-49"}])"},
                          {"/excuse/witness", "[]"}});
  const auto root = with_witness("tests/regressions/pixel-on-surface-loses-near-root.toml", "root");
  expect_refuted(root, {{"/excuse/witness", "[]"},
                        {"/excuse/witness/5/share", R"("-0x1p-49")"},
                        {"/excuse/witness/12/share", R"("0x1p-49")"},
                        {"/excuse/witness/0/input", R"("width")"},
                        {"/conventions/root", R"("smaller")"}});
  const auto choice = with_witness(kNearestByAnUlp, "nearest sphere");
  expect_refuted(choice, {{"/excuse/witness", "[]"},
                          {"/excuse/witness/9/share", R"("-0x1p-49")"},
                          {"/excuse/witness/9/input", R"("spheres[2].radius")"}});
}

TEST(TamperedCertificates, of_a_defect_are_not_proved) {
  auto defect = of_quantity(certificates_of(kFalseHit + " --intersect quadratic"), "class");
  EXPECT_TRUE(has(script_on({defect}).out, "; proved wrong for all inputs nearby"));
  defect["neighbourhood"] = 1e-3;
  EXPECT_TRUE(has(script_on({defect}).out, "; not proved wrong for all inputs nearby"));
}

TEST(TamperedCertificates, of_a_camera_are_refuted) {
  const auto certificates = certificates_of(kFarSphere + " --intersect quadratic --top 40");
  const auto class_error = of_quantity(certificates, "class");
  expect_refuted(class_error, {{"/wrong", R"("missed")"},
                               {"/pixel/0"},
                               {"/inputs/pixel/0"},
                               {"/inputs/camera/width"},
                               {"/inputs/camera/eye/0", "[1, -52]"},
                               {"/inputs/spheres/0/radius", "[4503599627370497, -52]"},
                               {"/conventions/samples", R"("centres")"},
                               {"/conventions/rows", R"("top-first")"},
                               {"/proof/roots/|E - A|", "[1, 1, 1]"},
                               {"/proof/roots/|P - E|/2"},
                               {"/proof/spheres/0/discriminant/2"},
                               {"/proof/spheres/0/root", R"("larger")"}});
  expect_refuted(of_quantity(certificates, "parameter"), {{"/wrong", R"("missed")"},
                                                          {"/unit", R"("u")"},
                                                          {"/proof/spheres/0/s/0", "\"0\""},
                                                          {"/proof/spheres/0/s/2"},
                                                          {"/exact/0/0"},
                                                          {"/inputs/spheres/0/centre/2/0"}});
  const auto frames = certificates_of(
      "tests/regressions/far-eye-lecture-loses-directions.toml --all --max-ulp 0 --top 30");
  expect_refuted(of_quantity(frames, "frame"), {{"/exact/1/0"},
                                                {"/what", R"("V")"},
                                                {"/inputs/camera/look_at/0/0"},
                                                {"/proof/roots/|E - A|/2"}});
  expect_refuted(of_quantity(frames, "orthonormality"),
                 {{"/error", "16"}, {"/proof/norms/0/2"}, {"/got/0/1"}});
  expect_refuted(of_quantity(frames, "direction"), {{"/error", "16"}, {"/exact/0/0"}});
  expect_refuted(of_quantity(frames, "pixel point"), {{"/error", "16"}, {"/exact/0/0"}});
}

}  // namespace
}  // namespace raycheck::tests
