// g++ case.cpp -losgManipulator -losg -o case
#include <osg/Camera>
#include <osg/Shape>
#include <osgManipulator/Dragger>
#include <osgManipulator/Projector>
#include <cstdio>
int main() {
  osg::ref_ptr<osg::Camera> camera = new osg::Camera;
  camera->setViewMatrixAsLookAt({{ex}, {ey}, {ez}}, {{ax}, {ay}, {az}}, {{ux}, {uy}, {uz}});
  camera->setProjectionMatrixAsFrustum({left}, {right}, {bottom}, {top}, {near}, 1000 * {near});
  camera->setViewport(new osg::Viewport(0, 0, {width}, {height}));
  osgManipulator::PointerInfo pointer;
  pointer.setCamera(camera);
  pointer.setMousePosition({i} + 0.5, {j} + 0.5);
  osg::ref_ptr<osgManipulator::Projector> projector =
      new osgManipulator::SphereProjector(new osg::Sphere(osg::Vec3({cx}, {cy}, {cz}), {r}));
  osg::Vec3d p;
  projector->project(pointer, p) ? std::printf("%.17g %.17g %.17g\n", p.x(), p.y(), p.z())
                                 : std::puts("miss");
}
