// OpenSceneGraph's LineSegmentIntersector::enter: whether a segment intersects the bounding sphere
// of a node, in floats, so that the node's contents can be picked. Debian: libopenscenegraph-dev;
// -losgUtil -losg. Source: osgUtil/LineSegmentIntersector, osg/Node. Silent on tangents. Its
// spheres are solid: a segment that lies inside is a hit, too.

#include <osg/Group>
#include <osgUtil/LineSegmentIntersector>

#define SINGLE
#include "adapter.h"

using namespace raycheck;
using osg::Vec3d;

static std::optional<Hit> intersect(const Ray& ray, const Sphere& sphere, const Conventions&) {
  const Vec3d from = to<Vec3d>(ray.origin), end = from + to<Vec3d>(ray.direction) * kEnd;
  const osg::ref_ptr<osg::Group> node = new osg::Group;
  node->setInitialBound(osg::BoundingSphere(to<Vec3d>(sphere.centre), sphere.radius));
  const osg::ref_ptr segment = new osgUtil::LineSegmentIntersector(from, end);
  if (!segment->enter(*node)) return std::nullopt;
  return Hit{};
}

RAYCHECK_CANDIDATE(.root = Root::nearest, .tangent = Tangent::either, .intersect = intersect,
                   .level = Level::ordinary, .smallest_length = 0x1p-10, .largest_length = 0x1p10,
                   .precision = kPrecision, .roots = Roots::declared, .valid = kSegment,
                   .returns = Returns::class_only)
