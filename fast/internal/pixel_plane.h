#pragma once

// The image plane, for every pixel ray method. Internal to fast/.

#include <cstddef>
#include <cstdint>

#include "fast/batch.h"
#include "fast/camera_frame.h"
#include "fast/internal/eigen.h"
#include "scene/scene.h"
#include "scene/validate.h"

namespace raycheck::fast {

/// A camera's axes, and alpha and beta of a pixel by the lecture's formulas.
struct PixelPlane {
  PixelPlane(const scene::Camera& its_camera, const scene::Conventions& its_conventions)
      : camera(its_camera), conventions(its_conventions) {
    scene::require_valid(camera, conventions);
    const CameraFrame frame = camera_frame(camera);
    U = eigen(frame.U);
    V = eigen(frame.V);
    W = eigen(frame.W);
    E = eigen(camera.eye);
  }

  double alpha(const scene::Pixel& pixel) const {
    return coordinate(pixel.i, camera.width, camera.left, camera.right);
  }
  double beta(const scene::Pixel& pixel) const {
    const bool bottom_first = conventions.rows == scene::Rows::kBottomFirst;
    return bottom_first ? coordinate(pixel.j, camera.height, camera.bottom, camera.top)
                        : coordinate(pixel.j, camera.height, camera.top, camera.bottom);
  }

  const scene::Camera& camera;
  const scene::Conventions& conventions;
  Eigen::Vector3d U, V, W, E;

 private:
  double coordinate(std::int64_t index, std::int64_t count, double first, double last) const {
    const double position = conventions.samples == scene::Samples::kEdges
                                ? static_cast<double>(index) / static_cast<double>(count - 1)
                                : (static_cast<double>(index) + 0.5) / static_cast<double>(count);
    return first + position * (last - first);
  }
};

template <class Vector>
void store(Vectors& out, std::size_t k, const Vector& value) {
  out.set(k, scene::Vector3{value.x(), value.y(), value.z()});
}

}  // namespace raycheck::fast
