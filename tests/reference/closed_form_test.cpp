#include "reference/closed_form.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "tests/reference/closed_form_value.h"
#include "tests/reference/random_cases.h"

namespace raycheck::reference {
namespace {

using scene::Camera;
using scene::Ray;
using scene::Sphere;

const Intersection kSmallerHit{HitClass::kHit, WhichRoot::kSmaller};
const Intersection kLargerHit{HitClass::kHit, WhichRoot::kLarger};
const Intersection kTangent{HitClass::kTangent, WhichRoot::kSmaller};
const Sphere kLectureSphere{{5, 5, 5}, 3};

TEST(ClosedFormValueParser, ReadsWhatIsPrintedAndNothingElse) {
  EXPECT_EQ(ClosedFormValue::of("-1/2*sqrt(9) + 28/7 - (1 - 3)*2"), Big(13) / 2);
  EXPECT_EQ(ClosedFormValue::of("sqrt(sqrt(16) + 5)"), Big(3));
  EXPECT_THROW(ClosedFormValue::of("1 + "), std::runtime_error);
  EXPECT_THROW(ClosedFormValue::of("sqrt(2"), std::runtime_error);
  EXPECT_THROW(ClosedFormValue::of("1 2"), std::runtime_error);
}

TEST(LectureClosedForm, FirstSphere) {
  const ClosedFormRay ray(Ray{{1, 1, 3}, {4, 3, 0}});
  EXPECT_EQ(ray.direction(), (ClosedForm3{"4/5", "3/5", "0"}));
  EXPECT_EQ(ray.origin(), (ClosedForm3{"1", "1", "3"}));
  EXPECT_EQ(ray.length(), "5");
  EXPECT_EQ(ray.to_centre(kLectureSphere), (ClosedForm3{"4", "4", "2"}));
  EXPECT_EQ(ray.axial_distance(kLectureSphere), "28/5");
  EXPECT_EQ(ray.half_chord_sq(kLectureSphere), "109/25");
  EXPECT_EQ(ray.parameter(kLectureSphere, kSmallerHit), "-1/25*sqrt(109) + 28/25");
  EXPECT_EQ(ray.point(kLectureSphere, kSmallerHit),
            (ClosedForm3{"-4/25*sqrt(109) + 137/25", "-3/25*sqrt(109) + 109/25", "3"}));
}

TEST(LectureClosedForm, FirstSphereByAUnitDirection) {
  // A camera whose centre ray has the unit direction (4/5, 3/5, 0) of the lecture, from (1, 1, 3).
  scene::Conventions conventions;
  conventions.origin = scene::Origin::kFocal;
  const Camera camera{{1, 1, 3}, {5, 4, 3}, {0, 0, 1}, -1, {}, -1, 1, -1, 1, 3, 3};
  const ClosedFormRay ray(camera, conventions, {1, 1});
  EXPECT_EQ(ray.direction(), (ClosedForm3{"4/5", "3/5", "0"}));
  EXPECT_EQ(ray.parameter(kLectureSphere, kSmallerHit), "-1/5*sqrt(109) + 28/5");
  EXPECT_EQ(ray.parameter(kLectureSphere, kLargerHit), "1/5*sqrt(109) + 28/5");
}

TEST(LectureClosedForm, Example1) {
  const ClosedFormRay ray(Ray{{0, 0, 0}, {1, 3, 4}});
  EXPECT_EQ(ray.direction(), (ClosedForm3{"1/26*sqrt(26)", "3/26*sqrt(26)", "2/13*sqrt(26)"}));
  EXPECT_EQ(ray.to_centre(kLectureSphere), (ClosedForm3{"5", "5", "5"}));
  EXPECT_EQ(ray.half_chord_sq(kLectureSphere), "-58/13");
}

TEST(LectureClosedForm, Example2) {
  const ClosedFormRay ray(Ray{{1, 0, 1}, {1, 2, 1}});
  EXPECT_EQ(ray.direction(), (ClosedForm3{"1/6*sqrt(6)", "1/3*sqrt(6)", "1/6*sqrt(6)"}));
  EXPECT_EQ(ray.to_centre(kLectureSphere), (ClosedForm3{"4", "5", "4"}));
  EXPECT_EQ(ray.half_chord_sq(kLectureSphere), "6");
  EXPECT_EQ(ray.axial_distance(kLectureSphere), "3*sqrt(6)");
  EXPECT_EQ(ray.parameter(kLectureSphere, kSmallerHit), "2");
  EXPECT_EQ(ray.point(kLectureSphere, kSmallerHit), (ClosedForm3{"3", "4", "3"}));
  // The same ray from a camera: s = 2 sqrt(6) is a length.
  scene::Conventions conventions;
  conventions.origin = scene::Origin::kFocal;
  const Camera camera{{1, 0, 1}, {2, 2, 2}, {0, 0, 1}, -1, {}, -1, 1, -1, 1, 3, 3};
  const ClosedFormRay unit(camera, conventions, {1, 1});
  EXPECT_EQ(unit.direction(), ray.direction());
  EXPECT_EQ(unit.parameter(kLectureSphere, kSmallerHit), "2*sqrt(6)");
}

TEST(LectureClosedForm, Cameras) {
  const Camera first{{8, 8, 100}, {8, 8, 54}, {0, 1, 0}, -30, -75, -30, 30, -20, 20, 2, 2};
  const ClosedFormFrame frame = closed_form_frame(first);
  EXPECT_EQ(frame.U, (ClosedForm3{"1", "0", "0"}));
  EXPECT_EQ(frame.V, (ClosedForm3{"0", "1", "0"}));
  EXPECT_EQ(frame.W, (ClosedForm3{"0", "0", "1"}));
  const ClosedFormRay corner(first, {}, {0, 0});
  EXPECT_EQ(corner.alpha(), "-30");
  EXPECT_EQ(corner.beta(), "-20");
  EXPECT_EQ(corner.pixel_point(), (ClosedForm3{"-22", "-12", "70"}));
  EXPECT_EQ(corner.direction(),
            (ClosedForm3{"-3/22*sqrt(22)", "-1/11*sqrt(22)", "-3/22*sqrt(22)"}));
  EXPECT_EQ(corner.length(), "10*sqrt(22)");

  const Camera optical{{8, 8, 100}, {8, 8, 54}, {0, 1, 0}, -30, -75, -20, 20, 20, -20, 3, 3};
  const ClosedFormRay other(optical, {}, {0, 0});
  EXPECT_EQ(other.pixel_point(), (ClosedForm3{"-12", "28", "70"}));
  EXPECT_EQ(other.direction(), (ClosedForm3{"-2/17*sqrt(17)", "2/17*sqrt(17)", "-3/17*sqrt(17)"}));
  EXPECT_EQ(ClosedFormRay(optical, {}, {1, 1}).direction(), (ClosedForm3{"0", "0", "-1"}));
}

TEST(ClosedForm, TermsThatVanishAreDropped) {
  const ClosedFormRay ray(Ray{{-5, 0, 0}, {1, 0, 0}});
  const Sphere unit{{0, 0, 0}, 1};
  EXPECT_EQ(ray.parameter(unit, kSmallerHit), "4");
  EXPECT_EQ(ray.point(unit, kSmallerHit), (ClosedForm3{"-1", "0", "0"}));
  EXPECT_EQ(ray.parameter({{-5, 0, 0}, 2}, kLargerHit), "2");
  const ClosedFormRay inside(Ray{{0, 0.5, 0}, {1, 0, 0}});
  EXPECT_EQ(inside.parameter(unit, kLargerHit), "1/2*sqrt(3)");
  EXPECT_EQ(inside.parameter(unit, kSmallerHit), "-1/2*sqrt(3)");
  EXPECT_EQ(ray.parameter({{0, 1, 0}, 1}, kTangent), "5");
}

TEST(ClosedForm, SquareFactorsAreTakenOut) {
  EXPECT_EQ(ClosedFormRay(Ray{{0, 0, 0}, {2, 2, 2}}).length(), "2*sqrt(3)");
  EXPECT_EQ(ClosedFormRay(Ray{{0, 0, 0}, {0.5, 0.25, 0}}).length(), "1/4*sqrt(5)");
  // 65537 is beyond the primes that are tried; what is left of this radicand is its square.
  EXPECT_EQ(ClosedFormRay(Ray{{0, 0, 0}, {65537, 65537, 0}}).length(), "65537*sqrt(2)");
  EXPECT_EQ(ClosedFormRay(Ray{{0, 0, 0}, {65521, 65521, 65521}}).length(), "65521*sqrt(3)");
}

TEST(ClosedForm, HitsOutsideTheFieldKeepOneNestedRoot) {
  scene::Conventions conventions;
  conventions.origin = scene::Origin::kFocal;
  const Camera camera{{0, 0, 0}, {-1, -1, -1}, {0, 0, 1}, -1, {}, -1, 1, -1, 1, 3, 3};
  const ClosedFormRay ray(camera, conventions, {2, 1});
  const Sphere sphere{{-2, -1, -1}, 1};
  const std::string s = ray.parameter(sphere, kSmallerHit);
  EXPECT_NE(s.find("sqrt("), std::string::npos);
  const std::string d_sq = ray.half_chord_sq(sphere);
  EXPECT_NE(d_sq.find("sqrt("), std::string::npos) << d_sq;
  EXPECT_EQ(s, "-sqrt(" + d_sq + ") + " + ray.axial_distance(sphere));
}

TEST(ClosedForm, InvalidInputIsRefused) {
  EXPECT_THROW(ClosedFormRay(Ray{{0, 0, 0}, {0, 0, 0}}), std::invalid_argument);
  EXPECT_THROW(closed_form_frame(Camera{}), std::invalid_argument);
  const ClosedFormRay ray(Ray{{0, 0, 0}, {1, 0, 0}});
  EXPECT_THROW(ray.parameter({{0, 0, 0}, -1}, kSmallerHit), std::invalid_argument);
}

TEST(ClosedForm, APixelOutsideTheImageIsRefused) {
  const Camera camera{{0, 0, 9}, {0, 0, 0}, {0, 1, 0}, -1, {}, -1, 1, -1, 1, 3, 3};
  EXPECT_THROW(ClosedFormRay(camera, {}, {3, 0}), std::invalid_argument);
  EXPECT_THROW(ClosedFormRay(camera, {}, {0, -1}), std::invalid_argument);
}

void expect_same(const ClosedForm3& texts, const Enclosure3& values) {
  EXPECT_TRUE(contains(values.x, ClosedFormValue::of(texts[0]))) << texts[0];
  EXPECT_TRUE(contains(values.y, ClosedFormValue::of(texts[1]))) << texts[1];
  EXPECT_TRUE(contains(values.z, ClosedFormValue::of(texts[2]))) << texts[2];
}

/// What the two say of one ray and a sphere; whether it was a hit.
bool expect_same_hit(const ClosedFormRay& text, const ExactRay& ray, const Sphere& sphere) {
  expect_same(text.origin(), ray.origin());
  expect_same(text.direction(), ray.direction());
  const EnclosedRay enclosed = ray.enclose(256);
  EXPECT_TRUE(contains(enclosed.length(), ClosedFormValue::of(text.length())));
  EXPECT_TRUE(
      contains(enclosed.axial_distance(sphere), ClosedFormValue::of(text.axial_distance(sphere))));
  EXPECT_TRUE(
      contains(enclosed.half_chord_sq(sphere), ClosedFormValue::of(text.half_chord_sq(sphere))));
  const Intersection at = ray.intersect(sphere);
  if (at.hit_class == HitClass::kMiss) return false;
  const std::string s = text.parameter(sphere, at);
  EXPECT_TRUE(contains(ray.parameter(sphere, at), ClosedFormValue::of(s))) << s;
  expect_same(text.point(sphere, at), ray.point(sphere, at));
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
    const ClosedFormRay text(camera, conventions, pixel);
    expect_same(text.pixel_point(), ray.pixel_point());
    hits += expect_same_hit(text, ray, sphere) ? 1 : 0;
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
