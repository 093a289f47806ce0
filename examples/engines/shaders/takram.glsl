// @takram/three-geospatial (npm; the atmosphere and clouds of three.js),
// raySphereFirstIntersection: the first root, or -1. No documentation; its code requires unit
// directions.
// raycheck include node_modules/@takram/three-geospatial/src/shaders/raySphereIntersection.glsl
// raycheck directions unit
// raycheck returns distance
// raycheck root smaller
// raycheck tangent either
float hit_sphere(vec3 o, vec3 d, vec3 c, float r) { return raySphereFirstIntersection(o, d, c, r); }
