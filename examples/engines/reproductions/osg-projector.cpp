// g++ case.cpp -losgManipulator -losg -o case
#include <osg/Shape>
#include <osgManipulator/Dragger>
#include <osgManipulator/Projector>
#include <cstdio>
int main() {
  osg::Vec3d from({ox}, {oy}, {oz}), p;
  osg::Vec3d to = from + osg::Vec3d({dx}, {dy}, {dz}) * 0x1p30;  // far enough not to turn the line
  osg::ref_ptr<osgManipulator::Projector> projector =
      new osgManipulator::SphereProjector(new osg::Sphere(osg::Vec3({cx}, {cy}, {cz}), {r}));
  osgManipulator::PointerInfo pointer;
  pointer.setNearFarPoints(from, to);
  projector->project(pointer, p) ? std::printf("%.17g %.17g %.17g\n", p.x(), p.y(), p.z())
                                 : std::puts("miss");
}
