#include "fast/camera_frame.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <string>

#include "properties/cases/case_source.h"
#include "properties/quantity.h"
#include "reference/account/condition.h"
#include "reference/error_measure.h"

namespace raycheck::fast {
namespace {

using scene::Camera;
using scene::UnitVector3;

const Camera kLectureCamera = {{8, 8, 100}, {8, 8, 54}, {0, 1, 0}, -30, {}, -30, 30, -20, 20, 2, 2};

TEST(CameraFrame, IsWithinItsBoundOnRandomCameras) {
  int judged = 0;
  for (const char* source : {"cameras", "plain-cameras", "far-camera", "up"}) {
    for (std::uint64_t seed = 0; seed < 1000; ++seed) {
      const auto the_case = properties::chosen_source(source).make(seed);
      const Camera& camera = *the_case.scene.camera;
      const reference::ExactCamera exact(camera, the_case.scene.conventions);
      if (reference::condition_of_frame(exact) > properties::kModerateCondition) continue;
      ++judged;
      const CameraFrame frame = camera_frame(camera);
      const reference::EnclosedFrame truth = exact.frame();
      EXPECT_LE(reference::relative_error(frame.U, truth.U), kFrameMaxUlp);
      EXPECT_LE(reference::relative_error(frame.V, truth.V), kFrameMaxUlp);
      EXPECT_LE(reference::relative_error(frame.W, truth.W), kFrameMaxUlp);
    }
  }
  EXPECT_GT(judged, 1500);
}

/// The largest of the axes' unit defects and mutual cosines, in units of u.
double defect(const CameraFrame& frame) {
  const auto cosine = [](const UnitVector3& a, const UnitVector3& b) {
    return reference::in_units_of_u(
        dot(reference::enclose_exactly(a), reference::enclose_exactly(b)));
  };
  return std::max({reference::unit_defect(frame.U), reference::unit_defect(frame.V),
                   reference::unit_defect(frame.W), cosine(frame.U, frame.V),
                   cosine(frame.V, frame.W), cosine(frame.W, frame.U)});
}

TEST(CameraFrame, IsOrthonormalHoweverNearUpIsToTheView) {
  double worst_condition = 0;
  for (const char* source : {"cameras", "plain-cameras", "far-camera", "up"}) {
    for (std::uint64_t seed = 0; seed < 1000; ++seed) {
      const auto the_case = properties::chosen_source(source).make(seed);
      const Camera& camera = *the_case.scene.camera;
      EXPECT_LE(defect(camera_frame(camera)), kFrameMaxDefectUlp) << source << " " << seed;
      worst_condition =
          std::max(worst_condition, reference::condition_of_frame(reference::ExactCamera(
                                        camera, the_case.scene.conventions)));
    }
  }
  EXPECT_GT(worst_condition, 1e14);
}

std::string refusal(const Camera& camera) {
  try {
    camera_frame(camera);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "none";
}

TEST(CameraFrame, RefusesByTheNameOfTheField) {
  Camera camera = kLectureCamera;
  camera.up = {0, 0, -3};
  EXPECT_NE(refusal(camera).find("camera.up"), std::string::npos) << refusal(camera);
  camera.up = {};
  EXPECT_NE(refusal(camera).find("camera.up"), std::string::npos) << refusal(camera);
  camera = kLectureCamera;
  camera.look_at = camera.eye;
  EXPECT_NE(refusal(camera).find("camera.look_at"), std::string::npos) << refusal(camera);
  camera = kLectureCamera;
  camera.eye.y = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(refusal(camera).find("camera.eye"), std::string::npos) << refusal(camera);
}

}  // namespace
}  // namespace raycheck::fast
