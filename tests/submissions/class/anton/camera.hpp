#pragma once
#include <Eigen/Core>
#include <Eigen/Geometry>
#include <utility>

using V = Eigen::Vector3d;

class Camera {
 public:
  Camera() = default;
  Camera(const V& eye, const V& look, const V& up, double d);
  void bounds(double left, double right, double bottom, double top);
  void resolution(int width, int height);
  // start and direction of the ray of a pixel; row 0 is the top one
  std::pair<V, V> ray(int column, int row) const;
  int width() const { return width_; }
  int height() const { return height_; }

 private:
  V eye_, u_, v_, w_;
  double d_ = 0, halfWidth_ = 1, halfHeight_ = 1;
  int width_ = 0, height_ = 0;
};
