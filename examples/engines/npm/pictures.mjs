// Pictures by a library's camera and its function for spheres: draw(castOf) reads an NFF file and writes a PPM file, the two
// arguments of the command. castOf(camera) returns a function that makes the ray through (x, y) of the picture, in pixels from
// its upper left corner, and returns a function that gives the distance of a sphere along this ray, nothing for a miss, or
// true for a hit without a distance, which is white. Scenes with the eye in a sphere are left out for a function that `culls`:
// that does not hit spheres from inside.
import { readFileSync, writeFileSync } from "node:fs";

export function draw(castOf, { culls = false } = {}) {
  const [, , scene, image] = process.argv;
  const view = {}, spheres = [];
  for (const line of readFileSync(scene, "utf8").split("\n")) {
    const [name, ...words] = line.split(" ");
    view[name] = words.map(Number);
    if (name === "s") spheres.push({ centre: view.s.slice(0, 3), radius: view.s[3], colour: view.f.slice(0, 3) });
  }
  const { from: eye, at, up, angle: [angle], resolution: [width, height] } = view;
  if (culls && spheres.some(({ centre, radius }) => Math.hypot(...centre.map((x, k) => x - eye[k])) - radius < 0.01)) process.exit(77);
  const cast = castOf({ eye, at, up, angle, width, height });
  const pixels = Buffer.alloc(3 * width * height);
  for (let k = 0; k < width * height; ++k) {
    const distance = cast((k % width) + 0.5, Math.floor(k / width) + 0.5);
    let nearest = Infinity;
    for (const { centre, radius, colour } of spheres) {
      const found = distance(centre, radius) ?? Infinity;
      if (found === true) pixels.fill(255, 3 * k, 3 * k + 3);
      if (found === true || !(found < nearest)) continue;
      nearest = found;
      pixels.set(colour.map((channel) => Math.round(255 * channel)), 3 * k);
    }
  }
  writeFileSync(image, Buffer.concat([Buffer.from(`P6 ${width} ${height} 255\n`), pixels]));
}
