// Where the ray of a pixel, along D = (x, y, 1) in view, meets a sphere at T with radius r. Lengths are in
// units of the viewer's nearest depth.
flat varying vec4 vTurned;                // D x T / r and D . T at a pixel near the centre,
flat varying vec4 vTurnedX, vTurnedY;     // and what they grow by from pixel to pixel
flat varying vec4 vSpan;                  // |T| in two floats, r, 1 if it is around the viewer
flat varying vec4 vTint;                  // colour, index
flat varying vec3 vReference;             // that pixel, 1 if the near half is left out
uniform vec4 rays;                        // D of the screen's corner, and what it grows by
uniform vec3 upward;
uniform vec2 counted;                     // between which s a root counts,
uniform vec4 rule;                        // from depth x, in radii if y, smaller z, larger w
uniform float logDepthBufFC;

void main() {
  vec2 away = gl_FragCoord.xy - vReference.xy;
  vec4 here = vTurned + vTurnedX * away.x + vTurnedY * away.y;
  vec3 D = vec3(rays.xy + rays.zw * gl_FragCoord.xy, 1.0);
  float stretch = length(D);
  D /= stretch;
  vec3 across = here.xyz / stretch;
  float h = length(across), edge = max(fwidth(h), 1e-6);
  float r = vSpan.z, v = here.w / stretch;
  bool isAround = vSpan.w > 0.5;
  if (!(h <= 1.0) || (!isAround && v <= 0.0)) discard;

  // Beside |T|, v - |T| = -h^2 / (|T| + v) would be lost: s counts from the greater float of |T|.
  float base = isAround ? 0.0 : vSpan.x;
  float middle = isAround ? v : vSpan.y - r * h * h * (r / (vSpan.x + v));
  float d = r * sqrt((1.0 - h) * (1.0 + h));
  vec2 s = vec2(middle - d, middle + d);
  vec2 since = s + (base - rule.x * stretch);
  vec2 between = rule.y > 0.5 ? counted * r : counted;
  bool isNear = since.x >= between.x && since.x <= between.y && rule.z > 0.5 && vReference.z < 0.5;
  bool isFar = since.y >= between.x && since.y <= between.y && rule.w > 0.5;
  if (!isNear && !isFar) discard;
  // As three.js computes it for lines.
  gl_FragDepthEXT = log2(1.0 + (base + (isNear ? s.x : s.y)) / stretch) * logDepthBufFC * 0.5;

#ifdef IDENTIFY
  float number = vTint.w + 1.0;
  gl_FragColor = vec4(mod(number, 256.0), mod(floor(number / 256.0), 256.0), floor(number / 65536.0), 255.0) / 255.0;
#else
  vec3 normal = cross(D, across) + D * ((isNear ? -d : d) / r);
  float light = 0.55 + 0.45 * max(dot(isNear ? normal : -normal, normalize(vec3(-0.4, 0.6, -0.7))), 0.0);
  // Neighbours in the list also differ in pattern; the inside is hatched.
  float kind = mod(vTint.w, 3.0);
  float band = kind < 0.5 ? 0.0 : step(0.0, sin(dot(normal, upward) * (kind < 1.5 ? 12.0 : 30.0)));
  float hatch = isNear ? 0.0 : 0.3 + 0.08 * step(0.5, fract((gl_FragCoord.x + gl_FragCoord.y) / 12.0));
  vec3 colour = vTint.rgb * light * (1.0 - 0.14 * band) * (1.0 - hatch);
  float rim = 1.0 - smoothstep(1.5 * edge, 2.5 * edge, 1.0 - h);
  gl_FragColor = vec4(mix(colour, colour * 0.35, rim), clamp((1.0 - h) / edge, 0.0, 1.0));
#endif
}
