// g++ case.cpp -losgUtil -losg -o case
#include <osg/Group>
#include <osgUtil/LineSegmentIntersector>
#include <cstdio>
int main() {
  osg::Vec3d from({ox}, {oy}, {oz}), to = from + osg::Vec3d({dx}, {dy}, {dz}) * 1024;
  osg::ref_ptr<osg::Group> node = new osg::Group;
  node->setInitialBound(osg::BoundingSphere(osg::Vec3d({cx}, {cy}, {cz}), {r}));
  osg::ref_ptr<osgUtil::LineSegmentIntersector> segment =
      new osgUtil::LineSegmentIntersector(from, to);
  std::puts(segment->enter(*node) ? "hit" : "miss");
}
