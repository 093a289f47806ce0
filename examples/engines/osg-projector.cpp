// OpenSceneGraph's osgManipulator::SphereProjector::project: where the line through a pointer's
// near and far points meets the front of a sphere. The points are in doubles, here kFar directions
// apart; the sphere is in floats. Debian: libopenscenegraph-dev; -losgManipulator -losg. Source:
// osgManipulator/Projector, osg/Shape. Silent on tangents, and on spheres behind the near point,
// which count, too.

#include <osg/Shape>
#include <osgManipulator/Dragger>
#include <osgManipulator/Projector>

#define SINGLE
#include "adapter.h"

using namespace raycheck;
using osg::Vec3d;

static std::optional<Hit> intersect(const Ray& ray, const Sphere& sphere, const Conventions&) {
  const Vec3d from = to<Vec3d>(ray.origin), far = from + to<Vec3d>(ray.direction) * kFar;
  const osg::ref_ptr projector = new osgManipulator::SphereProjector(
      new osg::Sphere(to<osg::Vec3, float>(sphere.centre), static_cast<float>(sphere.radius)));
  osgManipulator::PointerInfo pointer;
  pointer.setNearFarPoints(from, far);
  Vec3d point;
  if (!projector->project(pointer, point)) return std::nullopt;
  return Hit{.point = {point.x(), point.y(), point.z()}};
}

RAYCHECK_CANDIDATE(.root = Root::nearest, .tangent = Tangent::either, .intersect = intersect,
                   .level = Level::ordinary, .smallest_length = kSmallest,
                   .largest_length = kLargest, .precision = kPrecision, .roots = Roots::declared,
                   .valid = kLine, .returns = Returns::point)
