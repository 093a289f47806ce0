// node case.mjs, beside node_modules with proj4; the unit sphere, seen by a camera that looks at its centre
import proj4 from "proj4";
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const degrees = 180 / Math.PI, eye = [{ex}, {ey}, {ez}], h = Math.hypot(...eye) - 1;
const lat = Math.atan2(eye[2], Math.hypot(eye[0], eye[1])), lon = Math.atan2(eye[1], eye[0]);
const east = [-Math.sin(lon), Math.cos(lon), 0];
const north = [-Math.sin(lat) * Math.cos(lon), -Math.sin(lat) * Math.sin(lon), Math.cos(lat)];
const azimuth = Math.atan2(dot([{ux}, {uy}, {uz}], east), dot([{ux}, {uy}, {uz}], north));
const globe = `+proj=tpers +R=1 +tilt=0 +azi=${azimuth * degrees} +h=${h} +lat_0=${lat * degrees} +lon_0=${lon * degrees}`;
const place = [((2 * {i} + 1) / {width} - 1) * {right}, ((2 * {j} + 1) / {height} - 1) * {top}].map((one) => (one / {near}) * h);
const [lambda, phi] = proj4(globe, "+proj=longlat +R=1").forward(place).map((one) => one / degrees);
console.log(Math.cos(phi) * Math.cos(lambda), Math.cos(phi) * Math.sin(lambda), Math.sin(phi));
