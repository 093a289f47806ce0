#pragma once

// Converts the plain structs of scene/ to Eigen's vectors and back. Internal to fast/.

#include <Eigen/Dense>

namespace raycheck::fast {

template <class Triple>
Eigen::Vector3d eigen(const Triple& value) {
  return {value.x, value.y, value.z};
}

template <class Triple>
Triple plain(const Eigen::Vector3d& value) {
  return {value.x(), value.y(), value.z()};
}

}  // namespace raycheck::fast
