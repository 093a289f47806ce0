// Babylon.js (npm @babylonjs/core), sphereIntersect of the include intersectionFunctions (of its
// background and atmosphere): vec2(-b+h,-b-h), or -1 twice for a miss. No documentation; its code
// requires unit directions. The second number is the first root.
// raycheck include node_modules/@babylonjs/core/Shaders/ShadersInclude/intersectionFunctions.js
// raycheck directions unit
// raycheck returns distance
// raycheck root smaller
// raycheck tangent either
float hit_sphere(vec3 o, vec3 d, vec3 c, float r) { return sphereIntersect(o, d, c, r).y; }
