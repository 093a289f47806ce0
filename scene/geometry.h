#pragma once

namespace raycheck::scene {

/// A displacement. Its doubles are taken exactly as given.
struct Vector3 {
  double x = 0;
  double y = 0;
  double z = 0;
  bool operator==(const Vector3&) const = default;
};

/// A position in world coordinates. Points have no sum.
struct Point3 {
  double x = 0;
  double y = 0;
  double z = 0;
  bool operator==(const Point3&) const = default;
};

/// A vector that should have length 1, up to rounding.
struct UnitVector3 {
  double x = 0;
  double y = 0;
  double z = 0;
  bool operator==(const UnitVector3&) const = default;
};

/// The displacement from `from` to `to`, each coordinate rounded once.
inline Vector3 operator-(const Point3& to, const Point3& from) {
  return {to.x - from.x, to.y - from.y, to.z - from.z};
}

/// The points origin + s direction, s >= 0. The direction need not be unit.
struct Ray {
  Point3 origin;
  Vector3 direction;
  bool operator==(const Ray&) const = default;
};

/// A sphere; with radius 0, a point.
struct Sphere {
  Point3 centre;
  double radius = 0;
  bool operator==(const Sphere&) const = default;
};

/// All T whose numbers each lie between the numbers of `least` and `greatest`, ends included.
/// Domain: each number of `least` is at most that of `greatest`.
template <class T>
struct Box {
  T least, greatest;
};

/// Which answers are possible on a box of rays and spheres.
struct PossibleClasses {
  bool hit = true;
  bool miss = true;
};

}  // namespace raycheck::scene
