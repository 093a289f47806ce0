// Draws a list of figure.js with three.js. Everything reaches it in homogeneous screen coordinates; spheres are met by the
// ray of every pixel.

import { arrowHead, clipSegment, crossProduct, dashed, eyeViewer, homogeneous, inView, lengthOf, sphereWindow } from "./projection.js";

const SHAPES = ["disc", "square", "diamond", "ring", "cross", "dot"];
const LEAST_RADIUS = 1.5; // pixels: a smaller sphere has a mark
const LEAST_DRAWN = 1e-3; // pixels: a smaller one is the mark alone
const GREATEST_DEPTH = 1e30; // in units of the nearest depth: floats end at 3e38

// Depth is the logarithm that three writes for lines, so that spheres, lines and points hide one another.
// With D = (x, y, 1), T the way to the centre: perpendicular.xyz = D x T / r and perpendicular.w = D . T at a pixel beside the
// centre, and what they grow by from pixel to pixel. |T| comes in two floats, all lengths in units of the nearest depth.
/// A painter on a canvas; null where there is no WebGL 2.
export function webglPainter(canvas) {
  const context = globalThis.THREE && canvas.getContext("webgl2", { antialias: true, alpha: true });
  if (!context) return null;
  const renderer = new THREE.WebGLRenderer({ canvas, context, antialias: true, alpha: true, logarithmicDepthBuffer: true });
  const camera = new THREE.PerspectiveCamera();
  // Screen coordinates come in as they are; depth only by the fragments.
  camera.projectionMatrix.set(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, -1, 0);
  const stage = new THREE.Scene();
  const parts = { spheres: sphereMesh(false), ids: sphereMesh(true), ...lineMeshes(), ...pointMeshes() };
  stage.add(...Object.values(parts));
  const show = (ids) => Object.entries(parts).forEach(([name, part]) => { part.visible = (name === "ids") === ids; });
  const finish = (farthest) => { camera.far = Math.min(Math.max(farthest, 2), GREATEST_DEPTH); };
  return {
    /// Draws; returns sentences about what could not be drawn, and the spheres that only have a mark.
    paint(list, viewer, width, height, ratio) {
      renderer.setPixelRatio(ratio);
      renderer.setSize(width, height, false);
      const spheres = packSpheres(list.spheres, viewer, width * ratio, height * ratio, LEAST_RADIUS * ratio);
      fillSpheres(parts.spheres, spheres, viewer, list.scene, width * ratio, height * ratio, list.axes[1]);
      const marks = spheres.small.map(({ centre, colour }) => ({ at: centre, colour, shape: "ring", size: spheres.small.length > 200 ? 4 : 11 }));
      const farthest = Math.max(
        spheres.farthest, fillLines(parts, list, viewer, width, height),
        fillPoints(parts, [...list.points, ...marks], viewer, list.palette, ratio),
      );
      finish(farthest);
      show(false);
      renderer.render(stage, camera);
      return { small: spheres.small, notes: [...spheres.notes, ...depthNotes(farthest, spheres)] };
    },
    /// Which sphere every pixel shows, -1 for none; the row at the bottom first.
    identify(list, viewer, width, height) {
      const spheres = packSpheres(list.spheres, viewer, width, height, 0);
      fillSpheres(parts.ids, spheres, viewer, list.scene, width, height, list.axes[1]);
      finish(spheres.farthest);
      show(true);
      const target = new THREE.WebGLRenderTarget(width, height, { minFilter: THREE.NearestFilter, magFilter: THREE.NearestFilter });
      renderer.setRenderTarget(target);
      renderer.clear();
      renderer.render(stage, camera);
      const bytes = new Uint8Array(4 * width * height);
      renderer.readRenderTargetPixels(target, 0, 0, width, height, bytes);
      renderer.setRenderTarget(null);
      target.dispose();
      return Int32Array.from({ length: width * height }, (_, k) => bytes[4 * k] + 256 * bytes[4 * k + 1] + 65536 * bytes[4 * k + 2] - 1);
    },
    dispose() {
      renderer.dispose();
      renderer.forceContextLoss();
    },
  };
}

/// Which sphere each of width x height pixels of a scene's view from the eye shows, -1 for none; row j = 0 first.
export function eyePicture(store, width, height) {
  const scene = store.scene();
  const { camera, spheres } = scene.figure;
  if (!camera) throw new Error("a scene without a camera has no view from the eye");
  const painter = webglPainter(document.createElement("canvas"));
  if (!painter) throw new Error("there is no WebGL 2 here");
  const [across, down] = [width ?? camera.width, height ?? camera.height];
  const list = {
    scene, axes: [camera.U, camera.V, camera.W],
    spheres: spheres.centre.map((centre, index) => ({ index, centre, radius: spheres.radius[index], colour: [0, 0, 0] })),
  };
  const seen = painter.identify(list, eyeViewer(camera), across, down);
  painter.dispose();
  if (camera.rows !== "top-first") return seen;
  return seen.map((_, k) => seen[(down - 1 - Math.floor(k / across)) * across + (k % across)]);
}

function depthNotes(farthest, { crowded }) {
  const notes = [];
  if (farthest > GREATEST_DEPTH) notes.push("What is farther than 1e30 times the nearest is not drawn.");
  if (crowded > 1) notes.push(`${crowded} spheres are so small beside their distance that where two overlap, either may be before the other; go to one of them.`);
  return notes;
}

/// What the GPU is told of each sphere, the farthest first. `small`: those whose radius is less than `least` pixels.
function packSpheres(spheres, viewer, width, height, least) {
  const [x0, x1, y0, y1] = viewer.window;
  const rays = [x0, y0, (x1 - x0) / width, (y1 - y0) / height];
  const packed = { count: 0, small: [], notes: [], farthest: 0, crowded: 0, rays };
  const seen = [];
  for (const sphere of spheres) {
    const centre = inView(viewer, sphere.centre);
    const distance = lengthOf(centre);
    const bounds = sphereWindow(centre, sphere.radius);
    if (bounds === null) continue;
    const pixels = Math.max((bounds[1] - bounds[0]) / Math.abs(rays[2]), (bounds[3] - bounds[2]) / Math.abs(rays[3])) / 2;
    if (pixels < least) packed.small.push(sphere);
    if (pixels < LEAST_DRAWN || distance + sphere.radius > GREATEST_DEPTH * viewer.nearest) continue;
    const window = [...pixelsOf(bounds[0], bounds[1], rays[0], rays[2], width), ...pixelsOf(bounds[2], bounds[3], rays[1], rays[3], height)];
    if (window[0] < window[1] && window[2] < window[3]) seen.push({ sphere, centre, distance, window });
  }
  seen.sort((a, b) => (b.distance - b.sphere.radius) - (a.distance - a.sphere.radius));
  packed.count = seen.length;
  packed.data = new Float32Array(27 * seen.length);
  seen.forEach((one, k) => {
    packed.data.set(sphereData(one, viewer, rays, width, height), 27 * k);
    packed.farthest = Math.max(packed.farthest, (one.distance + one.sphere.radius) / viewer.nearest);
    if (one.sphere.radius < one.distance * 1e-5) packed.crowded += 1;
  });
  return packed;
}

/// The pixels, from the first to the last and one more on either side, between two tangents.
function pixelsOf(low, high, origin, step, count) {
  const ends = [(low - origin) / step, (high - origin) / step].sort((a, b) => a - b);
  return [Math.max(0, Math.floor(ends[0]) - 1), Math.min(count, Math.ceil(ends[1]) + 1)];
}

function sphereData({ sphere, centre, distance, window }, viewer, rays, width, height) {
  const r = sphere.radius;
  const T = centre.map((x) => x / r);
  const unit = viewer.nearest;
  // The middle of a pixel beside the centre, or as near to it as the screen goes.
  const middle = (tangent, origin, step, first, last) => Math.min(Math.max(Math.floor((tangent - origin) / step), first), last - 1) + 0.5;
  const isBefore = centre[2] > 0;
  const x = middle(isBefore ? centre[0] / centre[2] : 0, rays[0], rays[2], window[0], window[1]);
  const y = middle(isBefore ? centre[1] / centre[2] : 0, rays[1], rays[3], window[2], window[3]);
  const D = [rays[0] + rays[2] * x, rays[1] + rays[3] * y, 1];
  const far = Math.fround(distance / unit);
  return [
    (2 * window[0]) / width - 1, (2 * window[2]) / height - 1, (2 * window[1]) / width - 1, (2 * window[3]) / height - 1,
    ...crossProduct(D, T), (D[0] * centre[0] + D[1] * centre[1] + centre[2]) / unit,
    0, -rays[2] * T[2], rays[2] * T[1], (rays[2] * centre[0]) / unit,
    rays[3] * T[2], 0, -rays[3] * T[0], (rays[3] * centre[1]) / unit,
    far, distance / unit - far, r / unit, distance < r ? 1 : 0,
    ...sphere.colour, sphere.index,
    x, y, sphere.surroundsEye && viewer.start === 0 && distance >= r ? 1 : 0,
  ];
}

function sphereMesh(isFlat) {
  const geometry = new THREE.InstancedBufferGeometry();
  geometry.setAttribute("position", new THREE.Float32BufferAttribute([0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0], 3));
  geometry.setIndex([0, 1, 2, 0, 2, 3]);
  const uniforms = { rays: [4], upward: [3], counted: [2], rule: [4] };
  const material = new THREE.ShaderMaterial({
    vertexShader: SPHERE_VERTEX, fragmentShader: SPHERE_FRAGMENT, side: THREE.DoubleSide, transparent: !isFlat, depthWrite: true,
    blending: isFlat ? THREE.NoBlending : THREE.NormalBlending, defines: isFlat ? { FLAT: 1 } : {},
    uniforms: Object.fromEntries(Object.entries(uniforms).map(([name, [size]]) => [name, { value: new THREE[`Vector${size}`]() }])),
  });
  return always(new THREE.Mesh(geometry, material), 0);
}

/// Nothing is culled by three: what it is handed lies on the screen.
function always(mesh, order) {
  mesh.frustumCulled = false;
  mesh.renderOrder = order;
  return mesh;
}

function fillSpheres(mesh, packed, viewer, scene, width, height, up) {
  fillBuffer(mesh.geometry, packed.data, 27, {
    window: [4, 0], perpendicular: [4, 4], perpendicularX: [4, 8], perpendicularY: [4, 12], span: [4, 16], tint: [4, 20], reference: [3, 24],
  });
  const { rays, upward, counted, rule } = mesh.material.uniforms;
  rays.value.fromArray(packed.rays);
  upward.value.fromArray(viewer.axes.map((axis) => axis[0] * up[0] + axis[1] * up[1] + axis[2] * up[2]));
  const own = viewer.isEye ? scene.conventions : {};
  const isPerRadius = own.t_unit === "radius";
  const inUnits = (t) => (isPerRadius ? t : (t * 2 ** scene.figure.scale_exponent) / viewer.nearest);
  counted.value.set(inUnits(numberOf(own.t_min, 0)), Math.min(inUnits(numberOf(own.t_max, Infinity)), 3e38));
  rule.value.set(
    viewer.start / viewer.nearest, isPerRadius ? 1 : 0, { "back-faces": 1, "front-faces": 2 }[own.culling] ?? 0, own.root === "smaller" ? 1 : 0,
  );
}

function numberOf(told, otherwise) {
  return told === undefined || told === null || told === "infinity" ? otherwise : Number(told);
}

/// Hands interleaved floats to a geometry, as instances or as vertices; its buffer is kept while it is large enough.
function fillBuffer(geometry, data, stride, attributes, isInstanced = true) {
  let buffer = geometry.attributes[Object.keys(attributes)[0]]?.data;
  if (!buffer || buffer.array.length < data.length) {
    const Buffer = isInstanced ? THREE.InstancedInterleavedBuffer : THREE.InterleavedBuffer;
    buffer = new Buffer(new Float32Array(Math.max(2 * data.length, stride)), stride);
    buffer.setUsage(THREE.DynamicDrawUsage);
    for (const [name, [size, offset]] of Object.entries(attributes)) {
      geometry.setAttribute(name, new THREE.InterleavedBufferAttribute(buffer, size, offset));
    }
  }
  buffer.array.set(data);
  buffer.needsUpdate = true;
  if (isInstanced) geometry.maxInstancedCount = data.length / stride;
  else geometry.setDrawRange(0, data.length / stride);
}

function lineMeshes() {
  const mesh = (geometry, linewidth, isHidden) => always(new THREE.LineSegments2(geometry, new THREE.LineMaterial({
    linewidth, vertexColors: THREE.VertexColors, transparent: true, depthWrite: false,
    opacity: isHidden ? 0.3 : 1, depthFunc: isHidden ? THREE.GreaterDepth : THREE.LessEqualDepth,
  })), 1);
  const [thin, thick] = [new THREE.LineSegmentsGeometry(), new THREE.LineSegmentsGeometry()];
  return {
    thin: mesh(thin, 1.3, false), thinHidden: mesh(thin, 1.3, true), thick: mesh(thick, 2.6, false), thickHidden: mesh(thick, 2.6, true),
  };
}

/// Fills the lines; returns the greatest depth.
function fillLines(parts, list, viewer, width, height) {
  const packed = { thin: [], thick: [] };
  let farthest = 0;
  for (const { from, to, colour, thick, isDashed, hasArrow } of list.segments) {
    const [start, end] = [from, to].map((point) => homogeneous(viewer, point).map((x) => x / viewer.nearest));
    const clipped = clipSegment(start, end, 1);
    if (!clipped || clipped[1][2] > GREATEST_DEPTH || clipped[0][2] > GREATEST_DEPTH) continue;
    const pieces = isDashed ? dashed(...clipped, width, height) : [clipped];
    if (hasArrow && clipped[1].every((x, k) => x === end[k])) pieces.push(...arrowHead(...clipped, width, height));
    for (const [a, b] of pieces) {
      packed[thick ? "thick" : "thin"].push(a[0], a[1], -a[2], b[0], b[1], -b[2], ...colour, ...colour);
      farthest = Math.max(farthest, a[2], b[2]);
    }
  }
  const attributes = { instanceStart: [3, 0], instanceEnd: [3, 3], instanceColorStart: [3, 6], instanceColorEnd: [3, 9] };
  for (const name of ["thin", "thick"]) {
    fillBuffer(parts[name].geometry, packed[name], 12, attributes);
    for (const mesh of [parts[name], parts[`${name}Hidden`]]) mesh.material.uniforms.resolution.value.set(width, height);
  }
  return farthest;
}

function pointMeshes() {
  const geometry = new THREE.BufferGeometry();
  const mesh = (isHidden) => always(new THREE.Points(geometry, new THREE.ShaderMaterial({
    vertexShader: POINT_VERTEX, fragmentShader: POINT_FRAGMENT, transparent: true, depthWrite: false,
    depthFunc: isHidden ? THREE.GreaterDepth : THREE.LessEqualDepth,
    uniforms: { ratio: { value: 1 }, opacity: { value: isHidden ? 0.35 : 1 }, rim: { value: new THREE.Vector3() } },
  })), 2);
  return { points: mesh(false), pointsHidden: mesh(true) };
}

function fillPoints({ points, pointsHidden }, marked, viewer, palette, ratio) {
  const data = [];
  let farthest = 0;
  for (const { at, colour, shape, size } of marked) {
    const [x, y, w] = homogeneous(viewer, at).map((value) => value / viewer.nearest);
    if (!(w >= 1) || w > GREATEST_DEPTH || Math.abs(x) > 1.1 * w || Math.abs(y) > 1.1 * w) continue;
    data.push(x, y, w, ...colour, SHAPES.indexOf(shape), size);
    farthest = Math.max(farthest, w);
  }
  fillBuffer(points.geometry, data, 8, { position: [3, 0], tint: [4, 3], size: [1, 7] }, false);
  for (const { material } of [points, pointsHidden]) {
    material.uniforms.ratio.value = ratio;
    material.uniforms.rim.value.fromArray(palette.rim);
  }
  return farthest;
}
