// A candidate for raycheck in JavaScript (Node 18 or later), without dependencies.
//
//     import { run } from "./raycheck_candidate.mjs";
//
//     const pixelRay = (camera, conventions, pixel) => ...
//     const intersect = (ray, sphere, conventions) => ...
//
//     run("mine", { pixelRay, intersect });
//
// and then `raycheck check SCENE --candidate "command:node mine.mjs"`. In CommonJS:
// import("./raycheck_candidate.mjs").then(({ run }) => run("mine", { intersect })). The functions, all optional:
//
//     frame(camera) -> [u, v, w]                               the camera's axes
//     pixelPoint(camera, conventions, pixel) -> point          P
//     pixelRay(camera, conventions, pixel) -> { origin, direction }   from P, direction unit
//     focalRay(camera, conventions, pixel) -> { origin, direction }   from the eye
//     intersect(ray, sphere, conventions) -> { s, point } or null
//     intersectBatch(rays, sphere, conventions) -> an array of the same, one for each ray; instead of `intersect`
//     nearest(ray, spheres, conventions) -> index or null
//     pick(camera, conventions, pixel, sphere) -> { s, point } or null       the point seen through a pixel
//
// Vectors are arrays [x, y, z], pixels [i, j], a ray { origin, direction }, a sphere { centre, radius }, a camera { eye,
// lookAt, up, near, left, right, bottom, top, width, height }. Any of the functions may be async. What they fix or promise
// is declared beside them, by its name in `raycheck list`: run("mine", { rows: "top-first", tMin: 1e-4, lengths: [1e-9, 1e9],
// precision: "single", intersect }); roots: "as-asked" follows conventions.roots. If `intersect` does not return s and the
// point, declare what it returns: returns: "parameter", "distance" or "squared-distance" for a number, "point" for a vector,
// "class" for true or false, "roots" for both roots, [v - d, v + d]; null, undefined and false are misses.
// Output of the functions goes to standard error. The protocol is that of docs/candidates.md.
const reply = process.stdout.write.bind(process.stdout);
process.stdout.write = process.stderr.write.bind(process.stderr); // also for console.log
console.log = console.info = console.debug = console.error;

const protocolNames = {
  frame: "frame", pixelPoint: "pixel_point", pixelRay: "pixel_ray", focalRay: "focal_ray",
  intersect: "intersect", intersectBatch: "intersect", nearest: "nearest", pick: "pick",
};
const conventionNames = ["rows", "samples", "origin", "root", "tangent"];
const rootsNames = { ends: "interval", tMin: "t_min", tMax: "t_max", unit: "t_unit", culling: "culling" };

const numberOf = (word) => (word.endsWith("inf") ? (word[0] === "-" ? -Infinity : Infinity) : Number(word));

function wordOf(number) {
  if (typeof number !== "number") throw new TypeError(`not a number: ${number}`);
  if (Number.isFinite(number)) return Object.is(number, -0) ? "-0" : String(number);
  return Number.isNaN(number) ? "nan" : number > 0 ? "inf" : "-inf";
}

const line = (...values) => values.flatMap((value) => Array.from(value, wordOf)).join(" ");

function rootsOf([ends, tMin, tMax, unit, culling]) {
  return { ends, tMin: numberOf(tMin), tMax: numberOf(tMax), unit, culling };
}

function cameraOf(words) {
  const n = words.map(numberOf);
  const [near, left, right, bottom, top, width, height] = n.slice(9);
  return { eye: n.slice(0, 3), lookAt: n.slice(3, 6), up: n.slice(6, 9), near, left, right, bottom, top, width, height };
}

// The lines of the standard input, as they come.
async function* linesOf(stream) {
  let rest = "";
  stream.setEncoding("utf8");
  for await (const chunk of stream) {
    const lines = (rest + chunk).split("\n");
    rest = lines.pop();
    yield* lines;
  }
}

async function nextRows(lines, count) {
  const rows = [];
  while (rows.length < Number(count)) rows.push((await lines.next()).value.split(" ").map(numberOf));
  return rows;
}

// A request after its first line.
async function readRequest(lines, first) {
  const [, id, name] = first.split(" ");
  const request = { id, name, conventions: null };
  for (;;) {
    const [kind, ...words] = (await lines.next()).value.split(" ");
    if (kind === "end") return request;
    else if (kind === "conventions") {
      request.conventions = Object.fromEntries(conventionNames.map((key, k) => [key, words[k]]));
      request.conventions.roots = rootsOf(["[]", "0", "inf", "absolute", "none"]);
    } else if (kind === "roots") request.conventions.roots = rootsOf(words);
    else if (kind === "camera") request.camera = cameraOf(words);
    else if (kind === "pixels") request.pixels = await nextRows(lines, words[0]);
    else if (kind === "rays")
      request.rays = (await nextRows(lines, words[0])).map((row) => ({ origin: row.slice(0, 3), direction: row.slice(3) }));
    else if (kind === "spheres")
      request.spheres = (await nextRows(lines, words[0])).map((row) => ({ centre: row.slice(0, 3), radius: row[3] }));
    else throw new Error(`no such part of a request: ${kind}`);
  }
}

// s and Q of a hit for the reply: 0 for values that are not returned; null for a miss.
function hitWords(hit, returns) {
  if (hit === null || hit === undefined || hit === false) return null;
  if (returns === "class" && hit !== true) throw new TypeError(`neither true nor false: ${hit}`);
  if (returns === "class") return line([0, 0, 0, 0]);
  if (returns === "point") return line([0], hit);
  if (returns === "roots") return line(hit, [0, 0]);
  return returns === "hit" ? line([hit.s], hit.point) : line([hit, 0, 0, 0]);
}

async function answer(functions, returns, { name, camera, pixels, rays, spheres, conventions }) {
  if (name === "frame") return (await functions.frame(camera)).map((axis) => line(axis));
  const lines = [];
  if (name === "intersect" || name === "pick") {
    for (const [s, sphere] of spheres.entries()) {
      const one = (asked) => (pixels ? functions.pick(camera, conventions, asked, sphere) : functions.intersect(asked, sphere, conventions));
      const batch = rays && (await functions.intersectBatch?.(rays, sphere, conventions));
      for (const [r, asked] of (pixels ?? rays).entries()) {
        const hit = hitWords(batch ? batch[r] : await one(asked), returns);
        if (hit) lines.push(`${r} ${s} ${hit}`);
      }
    }
  } else if (name === "nearest") {
    for (const ray of rays) lines.push(`${(await functions.nearest(ray, spheres, conventions)) ?? "none"}`);
  } else {
    const key = { pixel_point: "pixelPoint", pixel_ray: "pixelRay", focal_ray: "focalRay" }[name];
    for (const pixel of pixels) {
      const found = await functions[key](camera, conventions, pixel);
      lines.push(key === "pixelPoint" ? line(found) : line(found.origin, found.direction));
    }
  }
  return lines;
}

// A declaration as lines: a word, a number, several in an array, or roots with their members.
function statements(key, value) {
  if (key === "roots" && typeof value === "object") {
    return Object.entries(value).flatMap(([member, one]) => {
      if (!(member in rootsNames)) throw new Error(`raycheck_candidate.run: no such roots: ${member}`);
      return statements(rootsNames[member], one);
    });
  }
  const name = key.replace(/[A-Z]/g, (letter) => `_${letter.toLowerCase()}`);
  return [[name, ...[value].flat().map((one) => (typeof one === "string" ? one : wordOf(one)))].join(" ")];
}

/** Answers raycheck until it has no more requests. */
export async function run(name, given) {
  const functions = Object.keys(given).filter((key) => typeof given[key] === "function");
  const unknown = functions.find((key) => !(key in protocolNames));
  if (unknown) throw new Error(`raycheck_candidate.run: no such function: ${unknown}`);
  const said = [`raycheck 1 ${name || "-"}`, ...new Set(functions.map((key) => `function ${protocolNames[key]}`))];
  for (const [key, value] of Object.entries(given)) {
    if (typeof value !== "function" && value !== null && value !== undefined) said.push(...statements(key, value));
  }
  const { returns = "hit" } = given;
  const lines = linesOf(process.stdin);
  if (!(await lines.next()).value?.startsWith("raycheck ")) throw new Error("raycheck_candidate.run: not started by --candidate: 'raycheck 1' is missing on standard input");
  reply(`${[...said, "ready"].join("\n")}\n`);
  for (let first = await lines.next(); !first.done; first = await lines.next()) {
    const request = await readRequest(lines, first.value);
    let body = [];
    let last = `end ${request.id}`;
    try {
      body = await answer(given, returns, request);
    } catch (error) { // thrown by the functions: its message belongs in the report
      last = `error ${request.id} ${String(error).split(/\s+/).join(" ")}`;
    }
    reply(`${[`reply ${request.id}`, ...body, last].join("\n")}\n`);
  }
}
