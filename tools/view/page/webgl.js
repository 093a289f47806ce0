// Draws a list with three.js: lines and points in homogeneous screen coordinates, spheres by the ray of every pixel.
/* global SHADERS */
import { crossProduct, dotProduct, homogeneous, inView, lengthOf, sphereWindow, strokesOf } from "./projection.js";

const SHAPES = ["disc", "square", "diamond", "ring", "cross"]; // as point.frag numbers them
const LEAST_SEEN = 1.5; // pixels of radius: smaller spheres get a ring
const LEAST_DRAWN = 1e-3; // pixels of radius: smaller ones are not drawn
const GREATEST_DEPTH = 1e30; // in units of the nearest: floats end at 3e38
const LEAST_RESOLVED = 1e-5; // of the distance: the resolution of 24-bit depths
const QUAD = [0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0];
const HANDED = { // floats passed to each shader
  sphere: { bounds: 4, turned: 4, turnedX: 4, turnedY: 4, span: 4, tint: 4, reference: 3 },
  line: { instanceStart: 3, instanceEnd: 3, instanceColorStart: 3, instanceColorEnd: 3 },
  point: { position: 3, tint: 4, size: 1 },
};
const knownColours = new Map(); // a colour -> its red, green and blue

/// Red, green and blue, from 0 to 1, of a colour as CSS has it.
function rgbOf(colour) {
  if (!knownColours.has(colour)) knownColours.set(colour, new THREE.Color(colour).toArray());
  return knownColours.get(colour);
}

/// A painter on a canvas; null without WebGL 2. With IDENTIFY defined, spheres are painted as their numbers.
export function webglPainter(canvas, defines = {}) {
  const context = window.THREE && canvas.getContext("webgl2", { antialias: true, alpha: true });
  if (!context) return null;
  const renderer = new THREE.WebGLRenderer({ canvas, context, alpha: true, logarithmicDepthBuffer: true });
  const camera = new THREE.PerspectiveCamera();
  camera.projectionMatrix.set(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, -1, 0); // the input is already projected
  const names = ["rays", "upward", "counted", "rule", "ratio", "rim", "resolution"];
  const uniforms = Object.fromEntries(names.map((name) => [name, { value: null }]));
  const layers = {
    spheres: sphereLayer(uniforms, defines), thin: lineLayer(uniforms, 1.3), thick: lineLayer(uniforms, 2.6),
    points: pointLayer(uniforms),
  };
  const stage = new THREE.Scene();
  stage.add(...Object.values(layers).flatMap(({ meshes }) => meshes));
  const set = (values) => Object.entries(values).forEach(([name, value]) => { uniforms[name].value = value; });
  return { paint: (...told) => paintWith({ renderer, camera, stage, layers, set }, ...told), renderer, stage };
}

/// Draws a list on a pane; returns the spheres too small to see, and sentences on what is not drawn correctly.
function paintWith({ renderer, camera, stage, layers, set }, list, pane, ratio = Math.min(devicePixelRatio, 2)) {
  renderer.setPixelRatio(ratio);
  renderer.setSize(pane.width, pane.height, false);
  const packed = { spheres: [], thin: [], thick: [], points: [], small: [], farthest: 0, unresolved: 0 };
  const rays = packSpheres(packed, list.spheres, pane, ratio);
  const size = packed.small.length > 200 ? 4 : 11;
  const rings = packed.small.map(({ centre, colour }) => ({ at: centre, colour, shape: "ring", size }));
  packPoints(packed, [...list.points, ...rings], pane.viewer);
  packLines(packed, list.segments, pane);
  for (const [name, { fill }] of Object.entries(layers)) fill(packed[name]);
  set({
    ...rootsOf(list, pane.viewer), rays, ratio, rim: rgbOf(list.palette.rim),
    resolution: new THREE.Vector2(pane.width, pane.height),
    upward: pane.viewer.axes.map((axis) => dotProduct(axis, list.axes[1])),
  });
  camera.far = Math.min(Math.max(packed.farthest, 2), GREATEST_DEPTH); // of the logarithmic depth
  renderer.render(stage, camera);
  const notes = [
    packed.farthest > GREATEST_DEPTH ? "Objects 1e30 times as far as the nearest are not drawn." : "",
    packed.unresolved > 1
      ? `Where two of ${packed.unresolved} distant spheres intersect, either may be drawn in front.` : "",
  ];
  return { small: packed.small, notes };
}

/// In the view from the eye, the scene's conventions define which roots count; in other views,
/// roots ahead count.
function rootsOf({ camera }, viewer) {
  if (!viewer.isEye) return { counted: [0, 3e38], rule: [0, 0, 1, 1] };
  const { from, to, in_radii: inRadii, smaller, larger } = camera.counts;
  const unit = inRadii ? 1 : viewer.nearest;
  const counted = [from / unit, Math.min((to ?? Infinity) / unit, 3e38)];
  return { counted, rule: [viewer.start / viewer.nearest, inRadii, smaller, larger].map(Number) };
}

/// Packs the spheres for the GPU, the farthest first: at equal depths the nearer is in front. Returns the first pixel's
/// ray, and what it grows by.
function packSpheres(packed, spheres, { viewer, width, height }, ratio) {
  const [x0, x1, y0, y1] = viewer.window;
  const [across, along] = [Math.round(width * ratio), Math.round(height * ratio)];
  const rays = [x0, y0, (x1 - x0) / across, (y1 - y0) / along];
  const seen = [];
  for (const sphere of spheres) {
    const centre = inView(viewer, sphere.centre);
    const around = sphereWindow(centre, sphere.radius);
    if (around === null) continue;
    const [wide, high] = [0, 2].map((k) => (around[k + 1] - around[k]) / Math.abs(rays[2 + k / 2]));
    const radius = Math.max(wide, high) / 2; // on the screen
    const distance = lengthOf(centre);
    if (radius < LEAST_SEEN * ratio) packed.small.push(sphere);
    if (radius < LEAST_DRAWN) continue;
    const x = pixelRange(around[0], around[1], rays[0], rays[2], across);
    const y = pixelRange(around[2], around[3], rays[1], rays[3], along);
    if (!(x[0] < x[1] && y[0] < y[1])) continue;
    const depth = (distance + sphere.radius) / viewer.nearest;
    packed.farthest = Math.max(packed.farthest, depth);
    packed.unresolved += sphere.radius < LEAST_RESOLVED * distance ? 1 : 0;
    const isAroundEye = lengthOf(sphere.centre) < sphere.radius;
    if (depth <= GREATEST_DEPTH) seen.push({ ...sphere, centre, distance, isAroundEye, x, y });
  }
  seen.sort((a, b) => (b.distance - b.radius) - (a.distance - a.radius));
  packed.spheres = seen.flatMap((sphere) => sphereData(sphere, viewer, rays, across, along));
  return rays;
}

/// The pixels between two tangents, and one more on each side.
function pixelRange(low, high, origin, step, count) {
  const ends = [(low - origin) / step, (high - origin) / step].sort((a, b) => a - b);
  return [Math.max(0, Math.floor(ends[0]) - 1), Math.min(count, Math.ceil(ends[1]) + 1)];
}

/// The attributes of one sphere for sphere.frag: differences are computed here, in doubles.
function sphereData({ index, centre, radius, colour, isAroundEye, distance, x, y }, viewer, rays, across, along) {
  const unit = viewer.nearest;
  const T = centre.map((coordinate) => coordinate / radius);
  const [px, py] = [x, y].map(([first, end], k) => {
    const tangent = centre[2] > 0 ? centre[k] / centre[2] : 0;
    return Math.min(Math.max(Math.floor((tangent - rays[k]) / rays[k + 2]), first), end - 1) + 0.5;
  });
  const D = [rays[0] + rays[2] * px, rays[1] + rays[3] * py, 1];
  const greater = Math.fround(distance / unit);
  const isHalf = isAroundEye && !viewer.isEye && distance > radius;
  return [
    (2 * x[0]) / across - 1, (2 * y[0]) / along - 1, (2 * x[1]) / across - 1, (2 * y[1]) / along - 1,
    ...crossProduct(D, T), (D[0] * centre[0] + D[1] * centre[1] + centre[2]) / unit,
    0, -rays[2] * T[2], rays[2] * T[1], (rays[2] * centre[0]) / unit,
    rays[3] * T[2], 0, -rays[3] * T[0], (rays[3] * centre[1]) / unit,
    greater, distance / unit - greater, radius / unit, distance < radius ? 1 : 0,
    ...rgbOf(colour), index, px, py, isHalf ? 1 : 0,
  ];
}

/// Meshes of one geometry, one per material; fill(data) passes them floats, per item as many as `handed` says.
function layerOf(Mesh, geometry, handed, renderOrder, materials) {
  const meshes = materials.map((material) =>
    Object.assign(new Mesh(geometry, material), { frustumCulled: false, renderOrder }));
  const stride = Object.values(handed).reduce((sum, size) => sum + size);
  const Buffer = geometry.isInstancedBufferGeometry ? THREE.InstancedInterleavedBuffer : THREE.InterleavedBuffer;
  const fill = (data) => {
    geometry.dispose(); // of the buffers that the GPU had before
    const buffer = new Buffer(new Float32Array(data), stride);
    let offset = 0;
    for (const [name, size] of Object.entries(handed)) {
      geometry.setAttribute(name, new THREE.InterleavedBufferAttribute(buffer, size, offset));
      offset += size;
    }
    geometry.maxInstancedCount = data.length / stride;
  };
  return { meshes, fill };
}

function shaderMaterial(name, uniforms, more) {
  const [vertexShader, fragmentShader] = [SHADERS[`${name}.vert`], SHADERS[`${name}.frag`]];
  return new THREE.ShaderMaterial({ vertexShader, fragmentShader, uniforms, transparent: true, ...more });
}

function sphereLayer(uniforms, defines) {
  const geometry = new THREE.InstancedBufferGeometry();
  geometry.setAttribute("position", new THREE.Float32BufferAttribute(QUAD, 3));
  geometry.setIndex([0, 1, 2, 0, 2, 3]);
  const material = shaderMaterial("sphere", uniforms, { side: THREE.DoubleSide, defines });
  return layerOf(THREE.Mesh, geometry, HANDED.sphere, 0, [material]);
}

/// Materials for things in front of the spheres and, shining through, for those behind.
function passes(material) {
  const pass = (depthFunc, opacity) => material({ depthWrite: false, depthFunc, transparent: true }, opacity);
  return [pass(THREE.LessEqualDepth, 1), pass(THREE.GreaterDepth, 0.5)];
}

function lineLayer({ resolution }, linewidth) {
  const style = { linewidth, color: new THREE.Color(1, 1, 1), vertexColors: THREE.VertexColors };
  return layerOf(THREE.LineSegments2, new THREE.LineSegmentsGeometry(), HANDED.line, 1, passes((pass, opacity) => {
    const material = new THREE.LineMaterial({ ...style, ...pass, opacity });
    material.uniforms.resolution = resolution;
    return material;
  }));
}

function pointLayer(uniforms) {
  return layerOf(THREE.Points, new THREE.BufferGeometry(), HANDED.point, 2, passes((pass, opacity) =>
    shaderMaterial("point", { ...uniforms, opacity: { value: opacity } }, pass)));
}

function packLines(packed, segments, pane) {
  for (const segment of segments) {
    const colour = rgbOf(segment.colour);
    for (const [a, b] of strokesOf(pane, segment)) {
      packed.farthest = Math.max(packed.farthest, a[2], b[2]);
      if (Math.max(a[2], b[2]) > GREATEST_DEPTH) continue;
      packed[segment.thick ? "thick" : "thin"].push(a[0], a[1], -a[2], b[0], b[1], -b[2], ...colour, ...colour);
    }
  }
}

function packPoints(packed, points, viewer) {
  for (const { at, colour, shape, size } of points) {
    const [x, y, w] = homogeneous(viewer, at);
    if (!(w >= 1) || Math.abs(x) > 1.1 * w || Math.abs(y) > 1.1 * w) continue;
    packed.farthest = Math.max(packed.farthest, w);
    if (w <= GREATEST_DEPTH) packed.points.push(x, y, w, ...rgbOf(colour), SHAPES.indexOf(shape), size);
  }
}
