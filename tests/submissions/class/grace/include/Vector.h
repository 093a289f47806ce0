#ifndef VECTOR_H
#define VECTOR_H
#include <array>
#include <cmath>

class Vector {
 public:
  Vector() : v_{0, 0, 0} {}
  Vector(double x, double y, double z) : v_{x, y, z} {}
  double operator[](int k) const { return v_[k]; }
  double& operator[](int k) { return v_[k]; }
  double dot(const Vector& o) const { return v_[0] * o[0] + v_[1] * o[1] + v_[2] * o[2]; }
  Vector cross(const Vector& o) const {
    return {v_[1] * o[2] - v_[2] * o[1], v_[2] * o[0] - v_[0] * o[2], v_[0] * o[1] - v_[1] * o[0]};
  }
  Vector mult(const Vector& o) const { return {v_[0] * o[0], v_[1] * o[1], v_[2] * o[2]}; }
  double length() const { return std::sqrt(dot(*this)); }
  Vector normalized() const;

 private:
  std::array<double, 3> v_;
};

inline Vector operator+(const Vector& a, const Vector& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
inline Vector operator-(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
inline Vector operator*(double k, const Vector& a) { return {k * a[0], k * a[1], k * a[2]}; }
#endif
