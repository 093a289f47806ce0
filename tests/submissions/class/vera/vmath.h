#ifndef VMATH_H
#define VMATH_H
#include <math.h>

struct float3 {
  float x, y, z;
};
inline float3 make_float3(float x, float y, float z) {
  float3 f = {x, y, z};
  return f;
}
inline float3 operator+(float3 a, float3 b) { return make_float3(a.x + b.x, a.y + b.y, a.z + b.z); }
inline float3 operator-(float3 a, float3 b) { return make_float3(a.x - b.x, a.y - b.y, a.z - b.z); }
inline float3 operator*(float3 a, float3 b) { return make_float3(a.x * b.x, a.y * b.y, a.z * b.z); }
inline float3 operator*(float k, float3 b) { return make_float3(k * b.x, k * b.y, k * b.z); }
inline float dot(float3 a, float3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline float length(float3 a) { return sqrtf(dot(a, a)); }
inline float3 normalize(float3 a) { return (1.0f / length(a)) * a; }
inline float3 cross(float3 a, float3 b) {
  return make_float3(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
}
#endif
