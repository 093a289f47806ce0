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
      : camera(its_camera),
        conventions(its_conventions),
        across(scene::pixel_steps(conventions.samples, camera.width)),
        down(scene::pixel_steps(conventions.samples, camera.height)) {
    scene::require_valid(camera, conventions);
    const CameraFrame frame = camera_frame(camera);
    U = eigen(frame.U);
    V = eigen(frame.V);
    W = eigen(frame.W);
    E = eigen(camera.eye);
  }

  double alpha(const scene::Pixel& pixel) const {
    return coordinate(pixel.i, across, camera.left, camera.right);
  }
  double beta(const scene::Pixel& pixel) const {
    const bool bottom_first = conventions.rows == scene::Rows::kBottomFirst;
    return bottom_first ? coordinate(pixel.j, down, camera.bottom, camera.top)
                        : coordinate(pixel.j, down, camera.top, camera.bottom);
  }

  const scene::Camera& camera;
  const scene::Conventions& conventions;
  scene::PixelSteps across, down;
  Eigen::Vector3d U, V, W, E;

 private:
  static double coordinate(std::int64_t index, const scene::PixelSteps& along, double first,
                           double last) {
    const double position = (static_cast<double>(index) + along.offset) / along.steps;
    return first + position * (last - first);
  }
};

template <class Vector>
void store(Vectors& out, std::size_t k, const Vector& value) {
  out.set(k, scene::Vector3{value.x(), value.y(), value.z()});
}

}  // namespace raycheck::fast
