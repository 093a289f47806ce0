attribute vec4 window, perpendicular, perpendicularX, perpendicularY, span, tint;
attribute vec3 reference;
flat varying vec4 vPerpendicular, vPerpendicularX, vPerpendicularY, vSpan, vTint;
flat varying vec3 vReference;
void main() {
  vPerpendicular = perpendicular; vPerpendicularX = perpendicularX; vPerpendicularY = perpendicularY;
  vSpan = span; vTint = tint; vReference = reference;
  gl_Position = vec4(mix(window.xy, window.zw, position.xy), 0.0, 1.0);
}
