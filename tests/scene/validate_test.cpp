#include "scene/validate.h"

#include "tests/testing.h"

namespace raycheck::scene {
namespace {

Camera lecture_camera() {
  return {{8, 8, 100}, {8, 8, 54}, {0, 1, 0}, -30, -75, -30, 30, -20, 20, 2, 2};
}

Scene lecture_scene() { return {lecture_camera(), {}, {{{5, 5, 5}, 3}}, {}}; }

std::string spelled(const std::vector<Defect>& found) {
  std::string text;
  for (const Defect& defect : found) {
    text += defect.field + " = " + defect.value + ": " + defect.what + "\n";
  }
  return text;
}

template <typename Input>
void expect_one(const Input& input, const std::string& field, const std::string& value) {
  const std::vector<Defect> found = defects(input);
  ASSERT_EQ(found.size(), 1u) << spelled(found);
  EXPECT_EQ(found[0].field, field);
  EXPECT_EQ(found[0].value, value);
  EXPECT_FALSE(found[0].what.empty());
  EXPECT_EQ(thrown_by([&] { require_valid(input); }) + "\n", spelled(found));
}

template <typename Input>
void expect_none(const Input& input) {
  EXPECT_EQ(spelled(defects(input)), "");
  EXPECT_NO_THROW(require_valid(input));
}

Camera changed(const std::function<void(Camera&)>& change) {
  Camera camera = lecture_camera();
  change(camera);
  return camera;
}

TEST(Validate, AcceptsOddButValidInput) {
  expect_none(changed([](Camera& c) { std::swap(c.left, c.right); }));
  expect_none(changed([](Camera& c) { std::swap(c.bottom, c.top); }));
  expect_none(changed([](Camera& c) { c.near = 30; }));
  expect_none(changed([](Camera& c) { c.far.reset(); }));
  expect_none(changed([](Camera& c) { c.width = c.height = 1; }));
  expect_none(Sphere{{0, 0, 0}, 0});
  expect_none(Sphere{{0, 0, 0}, -0.0});
  expect_none(Ray{{0, 0, 0}, {0, kSmallest, 0}});
  Scene centres = lecture_scene();
  centres.camera->width = 1;
  for (const Samples samples : {Samples::kCentres, Samples::kCorners}) {
    centres.conventions.samples = samples;
    expect_none(centres);
  }
}

// eye - look_at is not a double here: 1e300 - 2^-1074 rounds to 1e300.
TEST(Validate, JudgesACameraUnderConventionsAsInAScene) {
  EXPECT_NO_THROW(require_valid(lecture_camera(), Conventions{}));
  for (const Samples samples : {Samples::kEdges, Samples::kCentres, Samples::kCorners}) {
    for (const double near : {0.0, -30.0}) {
      Scene scene = lecture_scene();
      scene.conventions.samples = samples;
      scene.camera->near = near;
      scene.camera->width = 1;
      const std::string found = spelled(defects(scene));
      EXPECT_EQ(spelled(defects(*scene.camera, scene.conventions)), found);
      EXPECT_EQ(is_valid(*scene.camera, scene.conventions), found.empty());
    }
  }
}

TEST(Validate, DecidesParallelUpExactly) {
  const auto with = [](Point3 eye, Point3 look_at, Vector3 up) {
    return changed([&](Camera& c) {
      c.eye = eye;
      c.look_at = look_at;
      c.up = up;
    });
  };
  expect_none(with({1e300, 1e300, 0}, {kSmallest, 0, 0}, {1, 1, 0}));
  expect_one(with({1e300, 1e300, 0}, {kSmallest, kSmallest, 0}, {kSmallest, kSmallest, 0}),
             "camera.up", "[5e-324, 5e-324, 0]");
  expect_none(with({0.1, 0.3, 0}, {0, 0, 0}, {1, 3, 0}));
  expect_none(with({0.1, 0.1, 0.1}, {0, 0, 0}, {1, 1, std::nextafter(1.0, 2.0)}));
  expect_one(with({0.1, 0.1, 0.1}, {0, 0, 0}, {-7, -7, -7}), "camera.up", "[-7, -7, -7]");
  constexpr double kFar = 0x1p1000;
  expect_one(with({3 * kFar, -6 * kFar, 9 * kFar}, {kFar, -2 * kFar, 3 * kFar}, {1, -2, 3}),
             "camera.up", "[1, -2, 3]");
  expect_none(with({3 * kFar, -6 * kFar, 9 * kFar}, {kFar, -2 * kFar, 3 * kFar},
                   {1, -2, std::nextafter(3.0, 4.0)}));
  expect_none(with({kSmallest, 0, 0}, {0, 0, 0}, {0, kSmallest, 0}));
  expect_none(with({1, 0, 0}, {0, 0, 0}, {1e300, kSmallest, 0}));
  // Parallel, although the rounded differences of coordinates are not.
  constexpr double kLittle = 0x1.4p-54;
  expect_one(with({1, 3, 5}, {kLittle, 3 * kLittle, 5 * kLittle}, {1, 3, 5}), "camera.up",
             "[1, 3, 5]");
  const std::vector<Vector3> axes = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (const Vector3& a : axes) {
    for (const Vector3& b : axes) {
      if (a != b) expect_none(with({a.x + b.x, a.y + b.y, a.z + b.z}, {0, 0, 0}, a));
    }
  }
}

TEST(Validate, NamesDegenerateFields) {
  using Change = void (*)(Camera&);
  for (const auto& [change, field, value] :
       std::vector<std::tuple<Change, const char*, const char*>>{
           {[](Camera& c) { c.look_at = c.eye; }, "camera.look_at", "[8, 8, 100]"},
           {[](Camera& c) { c.eye = c.look_at = Point3(), c.look_at.x = -0.0; }, "camera.look_at",
            "[-0, 0, 0]"},
           {[](Camera& c) { c.up.y = 0, c.up.z = -0.0; }, "camera.up", "[0, 0, -0]"},
           {[](Camera& c) { c.up.y = 0, c.up.z = -3; }, "camera.up", "[0, 0, -3]"},
           {[](Camera& c) { c.near = -0.0; }, "camera.near", "-0"},
           {[](Camera& c) { c.left = c.right = 0.1; }, "camera.right", "0.1"},
           {[](Camera& c) { c.bottom = c.top = 7; }, "camera.top", "7"},
           {[](Camera& c) { c.width = 0; }, "camera.width", "0"},
           {[](Camera& c) { c.height = -5; }, "camera.height", "-5"}}) {
    expect_one(changed(change), field, value);
  }
  // Samples from edge to edge need two pixels.
  Scene scene = lecture_scene();
  scene.camera->width = 1;
  expect_one(scene, "camera.width", "1");
}

TEST(Validate, RefusesEveryNonFiniteNumber) {
  using Number = double* (*)(Scene&);
  const std::pair<const char*, Number> numbers[] = {
      {"camera.eye", [](Scene& s) { return &s.camera->eye.x; }},
      {"camera.look_at", [](Scene& s) { return &s.camera->look_at.y; }},
      {"camera.up", [](Scene& s) { return &s.camera->up.z; }},
      {"camera.near", [](Scene& s) { return &s.camera->near; }},
      {"camera.far", [](Scene& s) { return &*s.camera->far; }},
      {"camera.left", [](Scene& s) { return &s.camera->left; }},
      {"camera.right", [](Scene& s) { return &s.camera->right; }},
      {"camera.bottom", [](Scene& s) { return &s.camera->bottom; }},
      {"camera.top", [](Scene& s) { return &s.camera->top; }},
      {"sphere[0].centre", [](Scene& s) { return &s.spheres[0].centre.z; }},
      {"sphere[0].radius", [](Scene& s) { return &s.spheres[0].radius; }}};
  for (const auto& [field, number] : numbers) {
    for (const double value : {kInfinity, -kInfinity, std::nan("")}) {
      Scene scene = lecture_scene();
      *number(scene) = value;
      EXPECT_EQ(spelled(defects(scene)).find(field), 0u) << field;
      EXPECT_TRUE(spelled(defects(scene)).ends_with(": is not finite\n")) << field;
      EXPECT_EQ(defects(scene).size(), 1u) << field;
    }
  }
  expect_one(Ray{{0, kInfinity, 0}, {1, 0, 0}}, "ray.origin", "[0, inf, 0]");
  expect_one(Ray{{0, 0, 0}, {1, std::nan(""), 0}}, "ray.direction", "[1, nan, 0]");
}

}  // namespace
}  // namespace raycheck::scene
