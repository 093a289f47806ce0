// Draws a mark: a disc, square, diamond, ring or cross, with a rim.
varying vec4 vTint;
varying float vDepth;
uniform float opacity;
uniform vec3 rim;
uniform float logDepthBufFC;

void main() {
  vec2 p = abs(gl_PointCoord * 2.0 - 1.0);
  float shape = vTint.w, outside = length(p) - 0.85;
  if (shape == 1.0) outside = max(p.x, p.y) - 0.75;
  if (shape == 2.0) outside = (p.x + p.y - 0.98) * 0.8;
  if (shape == 3.0) outside = abs(length(p) - 0.68) - 0.14;
  if (shape == 4.0) outside = max(min(p.x, p.y) - 0.13, max(p.x, p.y) - 0.9);
  float soft = fwidth(outside), cover = 1.0 - smoothstep(-soft, soft, outside);
  if (cover < 0.02) discard;
  float inner = shape > 2.5 ? 1.0 : 1.0 - smoothstep(-0.28 - soft, -0.28 + soft, outside);
  // As three.js computes it for lines; a mark on a surface is in front of it.
  gl_FragDepthEXT = log2(1.0 + vDepth) * logDepthBufFC * 0.5 - 2e-4;
  gl_FragColor = vec4(mix(rim, vTint.rgb, inner), cover * opacity);
}
