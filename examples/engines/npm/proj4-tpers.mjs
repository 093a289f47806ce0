// proj4js (npm proj4), +proj=tpers, from the plane to the sphere: the point of the unit sphere that is seen from the height
// +h above +lat_0, +lon_0, looking at the centre, with the azimuth +azi up. The plane touches the sphere below the eye; its
// unit is the radius, +R. Undocumented, as PROJ's of the same name; points beside the globe are NaN. Source:
// lib/projections/tpers.js.
import { run } from "./raycheck_candidate.mjs";
import proj4 from "proj4";

const degrees = 180 / Math.PI;
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

function pick({ eye: [x, y, z], up, near, right, top, width, height }, _, [i, j]) {
  const across = Math.hypot(x, y), h = Math.hypot(x, y, z) - 1, lat = Math.atan2(z, across), lon = Math.atan2(y, x);
  if (!(h > 0)) return null;
  const east = [-Math.sin(lon), Math.cos(lon), 0];
  const north = [-Math.sin(lat) * Math.cos(lon), -Math.sin(lat) * Math.sin(lon), Math.cos(lat)];
  const azimuth = Math.atan2(dot(up, east), dot(up, north));
  const globe = `+proj=tpers +R=1 +tilt=0 +azi=${azimuth * degrees} +h=${h} +lat_0=${lat * degrees} +lon_0=${lon * degrees}`;
  const place = [((2 * i + 1) / width - 1) * right, ((2 * j + 1) / height - 1) * top].map((one) => (one / -near) * h);
  const [lambda, phi] = proj4(globe, "+proj=longlat +R=1").forward(place).map((one) => one / degrees);
  if (Number.isNaN(phi)) return null;
  return [Math.cos(phi) * Math.cos(lambda), Math.cos(phi) * Math.sin(lambda), Math.sin(phi)];
}

run("proj4-tpers", {
  rows: "bottom-first", samples: "centres", origin: "focal", root: "smaller", tangent: "either", roots: { ends: "(]" }, placement: "unit",
  view: "centre", windows: "symmetric", returns: "point", level: "ordinary", pick,
});
