#include "tools/report/typeset.h"

#include "reference/exact_ray.h"
#include "tests/reference/random_cases.h"
#include "tests/tools/program.h"

namespace raycheck::tools {
namespace {

using reference::ClosedForm, reference::ClosedForm3, reference::ClosedFormRay;
using reference::HitClass, reference::Intersection, reference::Random, reference::Sizes;

const Intersection kSmallerHit{HitClass::kHit, reference::WhichRoot::kSmaller};
const scene::Sphere kLectureSphere{{5, 5, 5}, 3};

TEST(Typeset, matches_handwritten_formulas) {
  const ClosedFormRay ray(scene::Ray{{1, 1, 3}, {4, 3, 0}});
  const auto distance = ray.distance(kLectureSphere, kSmallerHit);
  EXPECT_EQ(mathml(distance),
            "<mrow><mo>&#x2212;</mo><mfrac><msqrt><mn>109</mn></msqrt><mn>5</mn></mfrac><mo>+</mo>"
            "<mfrac><mn>28</mn><mn>5</mn></mfrac></mrow>");
  EXPECT_EQ(mathml(ray.to_centre(kLectureSphere)),
            "<mrow><mo>(</mo><mn>4</mn><mo>,</mo><mn>4</mn><mo>,</mo><mn>2</mn><mo>)</mo></mrow>");
  const ClosedForm three{{{.numerator = {"3"}}}};
  const ClosedForm sum{{{.radicands = {{{{.numerator = {"2"}}}}}}, {.negative = true}}};
  const ClosedForm nested{{{.sums = {sum}, .radicands = {three}},
                           {.negative = true, .denominator = {"5"}, .radicands = {three, sum}}}};
  EXPECT_EQ(nested.text(), "(sqrt(2) - 1)*sqrt(3) - 1/5*sqrt(3)*sqrt(sqrt(2) - 1)");
  EXPECT_EQ(mathml(nested),
            "<mrow><mrow><mrow><mo>(</mo><mrow><msqrt><mn>2</mn></msqrt><mo>&#x2212;</mo><mn>1</mn>"
            "</mrow><mo>)</mo></mrow><mo>&#x2062;</mo><msqrt><mn>3</mn></msqrt></mrow>"
            "<mo>&#x2212;</mo><mfrac><mrow><msqrt><mn>3</mn></msqrt><mo>&#x2062;</mo><msqrt><mrow>"
            "<msqrt><mn>2</mn></msqrt><mo>&#x2212;</mo><mn>1</mn></mrow></msqrt></mrow><mn>5</mn>"
            "</mfrac></mrow>");
  // Powers of two are shown as powers.
  const ClosedFormRay far(scene::Ray{{0x1p-1074, -3 * 0x1p60, 0x1p31}, {1, 0, 0}});
  EXPECT_EQ(mathml(far.origin()[0]),
            "<mfrac><mn>1</mn><msup><mn>2</mn><mn>1074</mn></msup></mfrac>");
  EXPECT_EQ(mathml(far.origin()[2]), "<mn>2147483648</mn>");
  EXPECT_EQ(mathml(far.origin()[1]),
            "<mrow><mo>&#x2212;</mo><mrow><mn>3</mn><mo>&#x22c5;</mo><msup><mn>2</mn><mn>60</mn>"
            "</msup></mrow></mrow>");
}

TEST(Typeset, writes_a_single_form_without_parentheses) {
  EXPECT_EQ(mathml(std::vector<ClosedForm>(1)), "<mn>0</mn>");
}

/// The digits that suffice for closed forms of ordinary doubles, and for those of doubles of all
/// sizes, whose squares may cancel.
constexpr int kOrdinaryDigits = 600, kMostDigits = 5000;

/// A typeset form, and the doubles nearest to its value.
struct Written {
  std::string text;
  std::vector<double> values;
};

/// The values of typeset forms, by tests/tools/report/typeset_values.py.
std::vector<std::vector<double>> values_of(const std::vector<Written>& written, int digits) {
  std::string text;
  for (const Written& one : written) text += one.text + '\n';
  const tests::Outcome worked_out =
      tests::run_python("tests/tools/report/typeset_values.py " + std::to_string(digits) + " < '" +
                        tests::temporary_file("typeset", text) + "'");
  EXPECT_EQ(worked_out.exit_code, 0) << "python3 is needed: " << worked_out.err;
  std::vector<std::vector<double>> values;
  for (const std::string& line : lines_of(worked_out.out)) {
    std::istringstream words(line);
    std::vector<double>& row = values.emplace_back();
    for (std::string word; words >> word;) row.push_back(std::strtod(word.c_str(), nullptr));
  }
  return values;
}

bool has_nested_root(const ClosedForm& form) {
  return std::any_of(form.terms.begin(), form.terms.end(), [](const ClosedForm::Term& term) {
    return std::any_of(term.radicands.begin(), term.radicands.end(),
                       [](const ClosedForm& radicand) {
                         return radicand.terms.size() > 1 || !radicand.terms.front().is_rational();
                       });
  });
}

/// Typeset numbers whose correctly rounded values are known.
class Numbers {
 public:
  void add(const ClosedForm& form, double value) { written_.push_back({mathml(form), {value}}); }
  template <class Triple>
  void add(const ClosedForm3& forms, const Triple& value) {
    written_.push_back({mathml(forms), {value.x, value.y, value.z}});
  }
  /// Collects closed forms and exact values of one ray and a sphere; returns whether they meet.
  bool add(const ClosedFormRay& forms, const reference::ExactRay& ray,
           const scene::Sphere& sphere) {
    add(forms.origin(), ray.rounded_origin());
    add(forms.direction(), ray.rounded_direction());
    const Intersection at = ray.intersect(sphere);
    if (at.hit_class == HitClass::kMiss) return false;
    nested_roots_ += has_nested_root(forms.parameter(sphere, at)) ? 1 : 0;
    add(forms.parameter(sphere, at), ray.rounded_parameter(sphere, at));
    add(forms.point(sphere, at), ray.rounded_point(sphere, at));
    return true;
  }
  int nested_roots() const { return nested_roots_; }
  void expect_values(int digits = kOrdinaryDigits) const {
    const std::vector<std::vector<double>> values = values_of(written_, digits);
    ASSERT_EQ(values.size(), written_.size());
    for (std::size_t k = 0; k < values.size(); ++k) {
      EXPECT_EQ(values[k], written_[k].values) << written_[k].text;
    }
  }

 private:
  std::vector<Written> written_;
  int nested_roots_ = 0;
};

TEST(Typeset, of_random_cameras_has_the_rounded_value) {
  Random random(1);
  Numbers all;
  int hits = 0;
  for (int k = 0; k < 100; ++k) {
    const scene::Camera camera = random_camera(random, Sizes::kSmallIntegers);
    const scene::Conventions conventions = reference::random_conventions(random);
    const scene::Pixel pixel = reference::random_pixel(random, camera);
    const scene::Sphere sphere = random_sphere(random, Sizes::kSmallIntegers);
    const reference::ExactCamera exact(camera, conventions);
    const reference::ClosedFormFrame frame = reference::closed_form_frame(camera);
    all.add(frame.U, exact.rounded_frame().U);
    all.add(frame.V, exact.rounded_frame().V);
    all.add(frame.W, exact.rounded_frame().W);
    hits += all.add(ClosedFormRay(camera, conventions, pixel), {exact, pixel}, sphere) ? 1 : 0;
  }
  EXPECT_GE(hits, 12);
  EXPECT_GE(all.nested_roots(), 6);
  all.expect_values();
}

/// Checks this number of rays with numbers of these sizes.
void expect_values_of_random_rays(int count, const std::vector<Sizes>& all_sizes, int least_hits,
                                  int digits) {
  Random random(2);
  Numbers all;
  int hits = 0;
  for (int k = 0; k < count; ++k) {
    const Sizes sizes = all_sizes[static_cast<std::size_t>(k) % all_sizes.size()];
    const scene::Ray ray = random_ray(random, sizes);
    const scene::Sphere sphere = random_sphere(random, sizes);
    hits += all.add(ClosedFormRay(ray), reference::ExactRay(ray), sphere) ? 1 : 0;
  }
  EXPECT_GE(hits, least_hits);
  all.expect_values(digits);
}

TEST(Typeset, of_random_rays_has_the_rounded_value) {
  constexpr Sizes kSmall = Sizes::kSmallIntegers;
  expect_values_of_random_rays(160, {kSmall, kSmall, kSmall, Sizes::kOrdinary}, 20,
                               kOrdinaryDigits);
  expect_values_of_random_rays(20, {Sizes::kAll}, 2, kMostDigits);  // all over the doubles
}

}  // namespace
}  // namespace raycheck::tools
