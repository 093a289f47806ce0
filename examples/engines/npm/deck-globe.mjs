// deck.gl (npm @deck.gl/core), GlobeView: viewport.unproject, "Unproject pixel coordinates on screen into world
// coordinates", here a longitude and a latitude. The camera looks at the centre; its bearing is the azimuth that is up.
// Beside the globe it gives a point, too. Silent about errors. Source: dist/viewports/globe-viewport.js.
import { run } from "./raycheck_candidate.mjs";
import "./node_modules/@deck.gl/core/dist.min.js"; // one file, for a browser: a sandbox opens few

const degrees = 180 / Math.PI;
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

function pick({ eye: [x, y, z], up, near, top, width, height }, _, [i, j]) {
  // Longitude 0 is at -y.
  const across = Math.hypot(x, y), distance = Math.hypot(x, y, z), lat = Math.atan2(z, across), lng = Math.atan2(x, -y);
  const east = [Math.cos(lng), Math.sin(lng), 0];
  const north = [-Math.sin(lat) * Math.sin(lng), Math.sin(lat) * Math.cos(lng), Math.cos(lat)];
  if (!(distance > 1)) return null;
  const altitude = -near / (2 * top); // of the eye above the globe, in heights of the window
  const scale = (altitude * height) / (256 * (distance - 1)); // of a globe of 256 pixels
  const zoom = Math.log2(scale * Math.PI * Math.cos(Math.min(Math.abs(lat) * degrees, 85.051129) / degrees));
  const view = new globalThis.deck._GlobeView({ nearZMultiplier: altitude / 2 }).makeViewport({ width, height, viewState: {
    longitude: lng * degrees, latitude: lat * degrees, zoom, bearing: Math.atan2(dot(up, east), dot(up, north)) * degrees,
    altitude,
  } });
  const [longitude, latitude] = view.unproject([i + 0.5, j + 0.5]).map((one) => one / degrees);
  if (Number.isNaN(latitude)) return null;
  return [Math.sin(longitude) * Math.cos(latitude), -Math.cos(longitude) * Math.cos(latitude), Math.sin(latitude)];
}

run("deck-globe", {
  rows: "top-first", samples: "centres", origin: "focal", root: "smaller", tangent: "either", roots: { ends: "(]" }, placement: "unit",
  view: "centre", windows: "square-pixels", returns: "point", level: "ordinary", pick,
});
