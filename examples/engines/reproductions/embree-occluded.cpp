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
  RTCRay query = {{ox}, {oy}, {oz}, 0, {dx}, {dy}, {dz}, 0, INFINITY, ~0u};
#if RTC_VERSION_MAJOR < 4
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcOccluded1(scene, &context, &query);
#else
  rtcOccluded1(scene, &query);
#endif
  std::puts(query.tfar == -INFINITY ? "hit" : "miss");
}
