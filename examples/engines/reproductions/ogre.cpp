// g++ case.cpp -I/usr/include/OGRE -o case
#include <OgreMath.h>
#include <OgreRay.h>
#include <OgreSphere.h>
#include <cstdio>
int main() {
  Ogre::Ray ray(Ogre::Vector3({ox}, {oy}, {oz}), Ogre::Vector3({dx}, {dy}, {dz}));
  Ogre::Sphere sphere(Ogre::Vector3({cx}, {cy}, {cz}), {r});
  auto [hit, t] = Ogre::Math::intersects(ray, sphere, false);
  hit ? std::printf("%.9g\n", t) : std::puts("miss");
}
