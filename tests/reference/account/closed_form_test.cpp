#include "reference/account/closed_form.h"

#include <cctype>

#include "tests/reference/big_float.h"
#include "tests/reference/random_cases.h"
#include "tests/testing.h"

namespace raycheck::reference {
namespace {

using namespace scene;

/// The value of a closed form or of its text, which has sums, products and quotients of integers,
/// parentheses and square roots. Other text throws std::runtime_error.
class ClosedFormValue {
 public:
  static Big of(std::string_view text) {
    ClosedFormValue parser(text);
    const Big value = parser.sum();
    if (!parser.text_.empty()) parser.fail();
    return value;
  }

  static Big of(const ClosedForm& form) {
    Big sum = 0;
    for (const ClosedForm::Term& term : form.terms) {
      Big product = value_of(term.numerator) / value_of(term.denominator);
      for (const ClosedForm& factor : term.sums) product *= of(factor);
      for (const ClosedForm& radicand : term.radicands) product *= sqrt(of(radicand));
      sum += term.negative ? Big(-product) : product;
    }
    return sum;
  }

 private:
  /// The value of an integer, from its short product if it has one.
  static Big value_of(const ClosedForm::Natural& n) {
    return n.is_short_product() ? Big(ldexp(Big(n.odd), static_cast<int>(n.twos))) : Big(n.digits);
  }

  explicit ClosedFormValue(std::string_view text) : text_(text) {}

  [[noreturn]] void fail() const {
    throw std::runtime_error("not understood: " + std::string(text_));
  }

  bool take(std::string_view token) {
    if (text_.substr(0, token.size()) != token) return false;
    text_.remove_prefix(token.size());
    return true;
  }

  Big sum() {
    Big value = take("-") ? Big(-product()) : product();
    for (;;) {
      if (take(" + ")) {
        value += product();
      } else if (take(" - ")) {
        value -= product();
      } else {
        return value;
      }
    }
  }

  Big product() {
    Big value = factor();
    for (;;) {
      if (take("*")) {
        value *= factor();
      } else if (take("/")) {
        value /= factor();
      } else {
        return value;
      }
    }
  }

  Big factor() {
    if (take("sqrt(")) {
      const Big value = sqrt(sum());
      if (!take(")")) fail();
      return value;
    }
    if (take("(")) {
      const Big value = sum();
      if (!take(")")) fail();
      return value;
    }
    std::size_t digits = 0;
    while (digits < text_.size() && std::isdigit(static_cast<unsigned char>(text_[digits])) != 0) {
      ++digits;
    }
    if (digits == 0) fail();
    const Big value(std::string(text_.substr(0, digits)));
    text_.remove_prefix(digits);
    return value;
  }

  std::string_view text_;
};

using Texts = std::vector<std::string>;

const Sphere kLectureSphere{{5, 5, 5}, 3};

TEST(ClosedForm, TermsThatVanishAreDropped) {
  const ClosedFormRay ray(Ray{{-5, 0, 0}, {1, 0, 0}});
  const Sphere unit{{0, 0, 0}, 1};
  EXPECT_EQ(ray.parameter(unit, kSmallerHit).text(), "4");
  EXPECT_EQ(texts(ray.point(unit, kSmallerHit)), (Texts{"-1", "0", "0"}));
  EXPECT_EQ(ray.parameter({{-5, 0, 0}, 2}, kLargerHit).text(), "2");
  const ClosedFormRay inside(Ray{{0, 0.5, 0}, {1, 0, 0}});
  EXPECT_EQ(inside.parameter(unit, kLargerHit).text(), "1/2*sqrt(3)");
  EXPECT_EQ(inside.parameter(unit, kSmallerHit).text(), "-1/2*sqrt(3)");
  EXPECT_EQ(ray.parameter({{0, 1, 0}, 1}, kTangent).text(), "5");
}

TEST(ClosedForm, SquareFactorsAreTakenOut) {
  EXPECT_EQ(ClosedFormRay(Ray{{0, 0, 0}, {2, 2, 2}}).length().text(), "2*sqrt(3)");
  EXPECT_EQ(ClosedFormRay(Ray{{0, 0, 0}, {0.5, 0.25, 0}}).length().text(), "1/4*sqrt(5)");
  // 65537 is larger than the primes that are tried, but what is left of this radicand is its
  // square.
  EXPECT_EQ(ClosedFormRay(Ray{{0, 0, 0}, {65537, 65537, 0}}).length().text(), "65537*sqrt(2)");
  EXPECT_EQ(ClosedFormRay(Ray{{0, 0, 0}, {65521, 65521, 65521}}).length().text(), "65521*sqrt(3)");
}

TEST(ClosedForm, HitsThatNeedARootOutsideTheFieldKeepOneNestedRoot) {
  scene::Conventions conventions;
  conventions.origin = scene::Origin::kFocal;
  const Camera camera{{0, 0, 0}, {-1, -1, -1}, {0, 0, 1}, -1, {}, -1, 1, -1, 1, 3, 3};
  const ClosedFormRay ray(camera, conventions, {2, 1});
  const Sphere sphere{{-2, -1, -1}, 1};
  const std::string s = ray.parameter(sphere, kSmallerHit).text();
  const std::string d_sq = ray.half_chord_sq(sphere).text();
  EXPECT_TRUE(has(d_sq, "sqrt("));  // s then has a nested root
  EXPECT_EQ(s, "-sqrt(" + d_sq + ") + " + ray.axial_distance(sphere).text());
}

TEST(ClosedForm, NestedRootsKeepTheirCoefficients) {
  const ClosedForm two{{{.numerator = {"2"}}}};
  const ClosedForm three{{{.numerator = {"3"}}}};
  const ClosedForm root{{{.radicands = {two}}, {.negative = true, .numerator = {"3"}}}};
  EXPECT_EQ(root.text(), "sqrt(2) - 3");
  EXPECT_EQ((ClosedForm{{{.sums = {root}, .radicands = {three}}}}.text()), "(sqrt(2) - 3)*sqrt(3)");
  const ClosedForm product{
      {{.negative = true, .denominator = {"5"}, .radicands = {three, root}}, {}}};
  EXPECT_EQ(product.text(), "-1/5*sqrt(3)*sqrt(sqrt(2) - 3) + 1");
}

TEST(ClosedForm, FindsIntegersThatAreShortProducts) {
  const auto x_of = [](double x) { return ClosedFormRay(Ray{{x, 0, 0}, {1, 0, 0}}).origin()[0]; };
  const auto power = [](const ClosedForm::Natural& n) { return std::pair(n.odd, n.twos); };
  using Power = std::pair<unsigned, unsigned>;
  EXPECT_EQ(power(x_of(0x1p-1074).terms[0].denominator), Power(1, 1074));
  EXPECT_EQ(power(x_of(-3 * 0x1p60).terms[0].numerator), Power(3, 60));
  EXPECT_EQ(x_of(-3 * 0x1p60).text(), "-3458764513820540928");
  EXPECT_EQ(power(x_of(kLargestOdd * 0x1p32).terms[0].numerator), Power(kLargestOdd, 32));
  EXPECT_EQ(power(x_of((kLargestOdd + 2) * 0x1p32).terms[0].numerator), Power(0, 0));
  EXPECT_EQ(power(x_of(0x1p31).terms[0].numerator), Power(0, 0));
  EXPECT_EQ(power(x_of(7).terms[0].numerator), Power(0, 0));
}

TEST(ClosedForm, InvalidInputIsRefused) {
  EXPECT_THROW(ClosedFormRay(Ray{{0, 0, 0}, {0, 0, 0}}), std::invalid_argument);
  EXPECT_THROW(closed_form_frame(Camera{}), std::invalid_argument);
  const ClosedFormRay ray(Ray{{0, 0, 0}, {1, 0, 0}});
  EXPECT_THROW(ray.parameter({{0, 0, 0}, -1}, kSmallerHit), std::invalid_argument);
  const Camera camera{{0, 0, 9}, {0, 0, 0}, {0, 1, 0}, -1, {}, -1, 1, -1, 1, 3, 3};
  EXPECT_THROW(ClosedFormRay(camera, {}, {3, 0}), std::invalid_argument);
  EXPECT_THROW(ClosedFormRay(camera, {}, {0, -1}), std::invalid_argument);
}

/// Whether the values of a closed form and of its text are in an enclosure.
bool has_value(const ClosedForm& form, const Enclosure& value) {
  return contains(value, ClosedFormValue::of(form)) &&
         contains(value, ClosedFormValue::of(form.text()));
}

void expect_same(const ClosedForm3& forms, const Enclosure3& values) {
  EXPECT_TRUE(has_value(forms[0], values.x)) << forms[0].text();
  EXPECT_TRUE(has_value(forms[1], values.y)) << forms[1].text();
  EXPECT_TRUE(has_value(forms[2], values.z)) << forms[2].text();
}

/// Compares closed forms and enclosures for one ray and a sphere; returns whether it was a hit.
bool expect_same_hit(const ClosedFormRay& forms, const ExactRay& ray, const Sphere& sphere) {
  expect_same(forms.origin(), ray.origin());
  expect_same(forms.direction(), ray.direction());
  const EnclosedRay enclosed = ray.enclose(256);
  EXPECT_TRUE(has_value(forms.length(), enclosed.length()));
  EXPECT_TRUE(has_value(forms.axial_distance(sphere), enclosed.axial_distance(sphere)));
  EXPECT_TRUE(has_value(forms.half_chord_sq(sphere), enclosed.half_chord_sq(sphere)));
  const Intersection at = ray.intersect(sphere);
  if (at.hit_class == HitClass::kMiss) return false;
  const ClosedForm s = forms.parameter(sphere, at);
  EXPECT_TRUE(has_value(s, ray.parameter(sphere, at))) << s.text();
  expect_same(forms.point(sphere, at), ray.point(sphere, at));
  return true;
}

TEST(ClosedForm, OfRandomCamerasHasTheEnclosedValue) {
  Random random(1);
  int hits = 0;
  for (int k = 0; k < 300 && !HasFailure(); ++k) {
    const Camera camera = random_camera(random, Sizes::kSmallIntegers);
    const scene::Conventions conventions = random_conventions(random);
    const scene::Pixel pixel = random_pixel(random, camera);
    const Sphere sphere = random_sphere(random, Sizes::kSmallIntegers);
    SCOPED_TRACE(spelled(camera) + spelled(sphere));
    const ExactCamera exact(camera, conventions);
    const ClosedFormFrame frame = closed_form_frame(camera);
    const EnclosedFrame enclosed = exact.frame();
    expect_same(frame.U, enclosed.U);
    expect_same(frame.V, enclosed.V);
    expect_same(frame.W, enclosed.W);
    const ExactRay ray(exact, pixel);
    const ClosedFormRay forms(camera, conventions, pixel);
    expect_same(forms.pixel_point(), ray.pixel_point());
    hits += expect_same_hit(forms, ray, sphere) ? 1 : 0;
  }
  EXPECT_GE(hits, 40);
}

TEST(ClosedForm, OfRandomRaysHasTheEnclosedValue) {
  Random random(2);
  int hits = 0;
  for (int k = 0; k < 1000 && !HasFailure(); ++k) {
    const Sizes sizes = random.one_in(4) ? Sizes::kOrdinary : Sizes::kSmallIntegers;
    const Ray ray = random_ray(random, sizes);
    const Sphere sphere = random_sphere(random, sizes);
    SCOPED_TRACE(spelled(ray) + spelled(sphere));
    hits += expect_same_hit(ClosedFormRay(ray), ExactRay(ray), sphere) ? 1 : 0;
  }
  EXPECT_GE(hits, 120);
}

}  // namespace
}  // namespace raycheck::reference
