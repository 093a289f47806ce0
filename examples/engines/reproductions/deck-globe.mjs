// node case.mjs, in a folder beside node_modules with @deck.gl/core; the unit sphere, seen by a camera that looks at its centre
import "../node_modules/@deck.gl/core/dist.min.js";
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const degrees = 180 / Math.PI, eye = [{ex}, {ey}, {ez}], distance = Math.hypot(...eye);
const lat = Math.atan2(eye[2], Math.hypot(eye[0], eye[1])), lng = Math.atan2(eye[0], -eye[1]);
const east = [Math.cos(lng), Math.sin(lng), 0];
const north = [-Math.sin(lat) * Math.sin(lng), Math.sin(lat) * Math.cos(lng), Math.cos(lat)];
const bearing = Math.atan2(dot([{ux}, {uy}, {uz}], east), dot([{ux}, {uy}, {uz}], north)) * degrees;
const altitude = {near} / (2 * {top}), scale = (altitude * {height}) / (256 * (distance - 1));
const zoom = Math.log2(scale * Math.PI * Math.cos(Math.min(Math.abs(lat) * degrees, 85.051129) / degrees));
const view = new deck._GlobeView({ nearZMultiplier: altitude / 2 }).makeViewport({ width: {width}, height: {height},
  viewState: { longitude: lng * degrees, latitude: lat * degrees, zoom, bearing, altitude } });
const [longitude, latitude] = view.unproject([{i} + 0.5, {j} + 0.5]).map((one) => one / degrees);
console.log(Math.sin(longitude) * Math.cos(latitude), -Math.cos(longitude) * Math.cos(latitude), Math.sin(latitude));
