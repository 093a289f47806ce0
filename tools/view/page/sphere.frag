flat varying vec4 vPerpendicular, vPerpendicularX, vPerpendicularY, vSpan, vTint;
flat varying vec3 vReference;
uniform vec4 rays;
uniform vec3 upward;
uniform vec2 counted;
uniform vec4 rule;
uniform float logDepthBufFC;

// The logarithm that three writes for lines, so that spheres, lines and points hide one another.
float depthOf(float w) { return log2(1.0 + w) * logDepthBufFC * 0.5; }
void main() {
  vec2 from = gl_FragCoord.xy - vReference.xy;
  vec4 here = vPerpendicular + vPerpendicularX * from.x + vPerpendicularY * from.y;
  vec3 D = vec3(rays.xy + rays.zw * gl_FragCoord.xy, 1.0);
  float length_ = length(D);
  vec3 across = here.xyz / length_;
  float h2 = dot(across, across);
  float h = sqrt(h2);
  float edge = max(fwidth(h), 1e-6);
  if (!(h2 <= 1.0)) discard;
  float d = sqrt((1.0 - h) * (1.0 + h));
  float r = vSpan.z, v = here.w / length_;
  bool isInside = vSpan.w > 0.5;
  if (!isInside && v <= 0.0) discard;
  // v - |T| of a sphere around us is no small difference, of others it is -h^2 / (|T| + v).
  float middle = isInside ? v : vSpan.y - r * h2 * (r / (vSpan.x + v));
  float base = isInside ? 0.0 : vSpan.x;
  float start = rule.x * length_;
  vec2 allowed = (rule.y > 0.5 ? counted * r : counted);
  float nearS = (middle - r * d) - (start - base), farS = (middle + r * d) - (start - base);
  bool isNear = nearS >= allowed.x && nearS <= allowed.y && rule.z < 1.5 && vReference.z < 0.5;
  bool isFar = farS >= allowed.x && farS <= allowed.y && rule.z != 1.0 && rule.w < 0.5;
  if (!isNear && !isFar) discard;
  float s = base + middle + (isNear ? -r * d : r * d);
  gl_FragDepthEXT = depthOf(s / length_);
  #ifdef FLAT
    float id = vTint.w + 1.0;
    gl_FragColor = vec4(mod(id, 256.0), mod(floor(id / 256.0), 256.0), floor(id / 65536.0), 255.0) / 255.0;
  #else
    vec3 normal = (isNear ? -d : d) * (D / length_) + cross(D / length_, across);
    vec3 facing = isNear ? normal : -normal;
    float light = 0.55 + 0.45 * max(dot(facing, normalize(vec3(-0.4, 0.6, -0.7))), 0.0);
    // Spheres differ by a pattern, too: plain, bands, or bands that are finer.
    float pattern = mod(abs(vTint.w), 3.0);
    float bands = pattern < 0.5 ? 1.0 : step(0.0, sin(dot(normal, upward) * (pattern < 1.5 ? 12.0 : 30.0)));
    float hatch = isNear ? 1.0 : step(0.35, fract((gl_FragCoord.x + gl_FragCoord.y) / 8.0));
    vec3 colour = vTint.rgb * light * (0.86 + 0.14 * bands) * (isNear ? 1.0 : 0.6 + 0.2 * hatch);
    float rim = 1.0 - smoothstep(1.5 * edge, 2.5 * edge, 1.0 - h);
    gl_FragColor = vec4(mix(colour, colour * 0.35, rim), clamp((1.0 - h) / edge, 0.0, 1.0));
  #endif
}
