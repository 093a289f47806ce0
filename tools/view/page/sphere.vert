// A rectangle of the screen around a sphere.
attribute vec4 bounds, turned, turnedX, turnedY, span, tint;
attribute vec3 reference;
flat varying vec4 vTurned, vTurnedX, vTurnedY, vSpan, vTint;
flat varying vec3 vReference;

void main() {
  vTurned = turned;
  vTurnedX = turnedX;
  vTurnedY = turnedY;
  vSpan = span;
  vTint = tint;
  vReference = reference;
  gl_Position = vec4(mix(bounds.xy, bounds.zw, position.xy), 0.0, 1.0);
}
