#include "fast/camera_frame.h"

#include "fast/internal/eigen.h"
#include "scene/validate.h"

namespace raycheck::fast {

CameraFrame camera_frame(const scene::Camera& camera) {
  scene::require_valid(camera);
  const Eigen::Vector3d to_eye = eigen(camera.eye - camera.look_at);
  const Eigen::Vector3d W = to_eye / to_eye.norm();
  const Eigen::Vector3d across = eigen(camera.up).cross(W);
  const Eigen::Vector3d U = across / across.norm();
  return {plain<scene::UnitVector3>(U), plain<scene::UnitVector3>(W.cross(U)),
          plain<scene::UnitVector3>(W)};
}

}  // namespace raycheck::fast
