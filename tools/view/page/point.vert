attribute vec4 tint;
attribute float size;
uniform float ratio;
varying vec4 vTint;
varying float vDepth;

void main() {
  vTint = tint;
  vDepth = position.z;
  gl_Position = vec4(position.xy, 0.0, position.z);
  gl_PointSize = size * ratio;
}
