varying vec4 vTint;
varying float vDepth;
uniform float opacity;
uniform vec3 rim;
uniform float logDepthBufFC;

// The logarithm that three writes for lines, so that spheres, lines and points hide one another.
float depthOf(float w) { return log2(1.0 + w) * logDepthBufFC * 0.5; }
void main() {
  vec2 p = abs(gl_PointCoord * 2.0 - 1.0);
  float shape = vTint.w, away = length(p) - 0.85;
  if (shape == 1.0) away = max(p.x, p.y) - 0.75;
  if (shape == 2.0) away = (p.x + p.y - 0.98) * 0.8;
  if (shape == 3.0) away = abs(length(p) - 0.68) - 0.14;
  if (shape == 4.0) away = max(min(p.x, p.y) - 0.13, max(p.x, p.y) - 0.9);
  float soft = fwidth(away);
  float cover = 1.0 - smoothstep(-soft, soft, away);
  if (cover < 0.02) discard;
  float inner = shape >= 3.0 ? 1.0 : 1.0 - smoothstep(-0.28 - soft, -0.28 + soft, away);
  gl_FragDepthEXT = depthOf(vDepth) - 2e-4; // a mark on a surface is before it
  gl_FragColor = vec4(mix(rim, vTint.rgb, inner), cover * opacity);
}
