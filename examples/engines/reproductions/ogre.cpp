// g++ case.cpp -I/usr/include/OGRE -lOgreMain -o case
#include <OgreMath.h>
#include <OgreRay.h>
#include <OgreSphere.h>
#include <cstdio>
int main() {
  Ogre::Ray ray(Ogre::Vector3({ox}, {oy}, {oz}), Ogre::Vector3({dx}, {dy}, {dz}));
  auto [hit, t] = Ogre::Math::intersects(ray, Ogre::Sphere(Ogre::Vector3({cx}, {cy}, {cz}), {r}), false);
  hit ? std::printf("%.9g\n", t) : std::puts("miss");
}
