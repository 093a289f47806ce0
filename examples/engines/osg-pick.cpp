// OpenSceneGraph's osgManipulator::PointerInfo: the near and far points of a position in the window
// of a camera, then osgManipulator::SphereProjector::project (osg-projector.cpp). Matrices are in
// doubles; the sphere is in floats. Debian: libopenscenegraph-dev; -losgManipulator -losg. Source:
// osgManipulator/Dragger, osgManipulator/Projector. Silent on errors, on tangents, and on spheres
// behind the near point, which count, too.

#include <osg/Camera>
#include <osg/Shape>
#include <osgManipulator/Dragger>
#include <osgManipulator/Projector>

#define SINGLE
#include "adapter.h"

using namespace raycheck;
using osg::Vec3d;

static std::optional<Hit> pick(const Camera& camera, const Conventions&, Pixel pixel,
                               const Sphere& sphere) {
  const osg::ref_ptr<osg::Camera> own = new osg::Camera;
  const double near = -camera.near_plane, width = static_cast<double>(camera.width),
               height = static_cast<double>(camera.height);
  own->setViewMatrixAsLookAt(to<Vec3d>(camera.eye), to<Vec3d>(camera.look_at),
                             to<Vec3d>(camera.up));
  own->setProjectionMatrixAsFrustum(camera.left, camera.right, camera.bottom, camera.top, near,
                                    1000 * near);
  own->setViewport(new osg::Viewport(0, 0, width, height));
  osgManipulator::PointerInfo pointer;
  pointer.setCamera(own);
  pointer.setMousePosition(static_cast<float>(pixel.i) + 0.5F, static_cast<float>(pixel.j) + 0.5F);
  Vec3d point;
  const osg::ref_ptr projector = new osgManipulator::SphereProjector(
      new osg::Sphere(to<osg::Vec3, float>(sphere.centre), static_cast<float>(sphere.radius)));
  if (!projector->project(pointer, point)) return std::nullopt;
  return Hit{.point = {point.x(), point.y(), point.z()}};
}

RAYCHECK_CANDIDATE(.rows = Rows::bottom_first, .samples = Samples::centres, .origin = Origin::pixel,
                   .root = Root::nearest, .tangent = Tangent::either, .pick = pick,
                   .level = Level::ordinary, .smallest_length = kSmallest,
                   .largest_length = kLargest, .precision = kPrecision, .roots = Roots::declared,
                   .valid = kLine, .returns = Returns::point, .contract = "windows symmetric")
