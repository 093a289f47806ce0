#include "camera.hpp"

Camera::Camera(const V& eye, const V& look, const V& up, double d) : eye_(eye), d_(d) {
  w_ = (eye - look).normalized();
  u_ = up.cross(w_).normalized();
  v_ = w_.cross(u_);
}

void Camera::bounds(double, double right, double, double top) {
  halfWidth_ = right;
  halfHeight_ = top;
}

void Camera::resolution(int width, int height) {
  width_ = width;
  height_ = height;
}

std::pair<V, V> Camera::ray(int column, int row) const {
  double x = (2.0 * column / (width_ - 1) - 1) * halfWidth_;
  double y = (1 - 2.0 * row / (height_ - 1)) * halfHeight_;
  V toPixel = d_ * w_ + x * u_ + y * v_;
  return {eye_ + toPixel, toPixel.normalized()};
}
