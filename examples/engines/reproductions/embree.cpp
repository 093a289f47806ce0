// g++ case.cpp /usr/lib/*/libembree[34].so -o case
#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif
#include <cmath>
#include <cstdio>
int main() {
  RTCDevice device = rtcNewDevice("threads=1");
  RTCScene scene = rtcNewScene(device);
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_SPHERE_POINT);
  auto* v = (float*)rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT4,
                                            16, 1);
  v[0] = {cx}, v[1] = {cy}, v[2] = {cz}, v[3] = {r};
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(scene, geometry);
  rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
  rtcCommitScene(scene);
  RTCRayHit query = {{{ox}, {oy}, {oz}, 0, {dx}, {dy}, {dz}, 0, INFINITY, ~0u}, {}};
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
#if RTC_VERSION_MAJOR < 4
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcIntersect1(scene, &context, &query);
#else
  rtcIntersect1(scene, &query);
#endif
  query.hit.geomID == 0 ? std::printf("%.9g\n", query.ray.tfar) : std::puts("miss");
}
