#include "fast/camera_frame.h"

#include <cmath>

#include "fast/internal/eigen.h"
#include "scene/validate.h"

namespace raycheck::fast {
namespace {

/// x y - z w within 1.5 ulp, even if it cancels (Kahan; Jeannerod, Louvet and Muller, Further
/// analysis of Kahan's algorithm for the accurate computation of 2x2 determinants, 2013).
double difference_of_products(double x, double y, double z, double w) {
  const double second = z * w;
  return std::fma(x, y, -second) - std::fma(z, w, -second);
}

/// a x b, every coordinate within 1.5 ulp. If the angle phi between up and W is small, the products
/// cancel. Products that are rounded separately are off by about u |up| in any direction, also
/// along W, so that U would lean out of the image plane by about u/sin(phi). Such axes are not
/// orthonormal. No nearby camera has them, so the condition numbers of s and Q with respect to a
/// camera's inputs do not account for this error. If every coordinate is accurate, U is
/// perpendicular to the rounded W up to a few u for every phi, and the rounded W is exact for a
/// camera whose eye is a few u away. sin(phi) then magnifies only a rotation about W, which a
/// condition number measures.
Eigen::Vector3d accurate_cross(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return {difference_of_products(a.y(), b.z(), a.z(), b.y()),
          difference_of_products(a.z(), b.x(), a.x(), b.z()),
          difference_of_products(a.x(), b.y(), a.y(), b.x())};
}

}  // namespace

CameraFrame camera_frame(const scene::Camera& camera) {
  scene::require_valid(camera);
  const Eigen::Vector3d to_eye = eigen(camera.eye - camera.look_at);
  const Eigen::Vector3d W = to_eye / to_eye.norm();
  const Eigen::Vector3d across = accurate_cross(eigen(camera.up), W);
  const Eigen::Vector3d U = across / across.norm();
  return {plain<scene::UnitVector3>(U), plain<scene::UnitVector3>(W.cross(U)),
          plain<scene::UnitVector3>(W)};
}

}  // namespace raycheck::fast
