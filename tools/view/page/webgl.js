// Draws a list with three.js: lines and points in homogeneous screen coordinates, spheres by the ray of every pixel.
/* global THREE, SHADERS */
import { crossProduct, eyeViewer, homogeneous, inView, lengthOf, sphereWindow, strokesOf } from "./projection.js";

const SHAPES = ["disc", "square", "diamond", "ring", "cross"]; // as point.frag numbers them
const LEAST_SEEN = 1.5; // pixels of radius: a smaller sphere has a ring
const LEAST_DRAWN = 1e-3; // pixels of radius: a smaller one is not drawn
const GREATEST_DEPTH = 1e30; // in units of the nearest: floats end at 3e38
const LEAST_RESOLVED = 1e-5; // of the distance: what the depths of 24 bits tell apart

/// A painter on a canvas; null where there is no WebGL 2.
export function webglPainter(canvas) {
  const context = window.THREE && canvas.getContext("webgl2", { antialias: true, alpha: true });
  if (!context) return null;
  const renderer = new THREE.WebGLRenderer({ canvas, context, alpha: true, logarithmicDepthBuffer: true });
  const camera = new THREE.PerspectiveCamera();
  camera.projectionMatrix.set(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, -1, 0); // what it is handed is projected
  const spheres = { spheres: sphereMesh({}), identities: sphereMesh({ IDENTIFY: 1 }) };
  const painter = { renderer, camera, ...spheres, ...lineMeshes(), ...pointMeshes() };
  return {
    paint: (list, pane) => paintWith(painter, list, pane),
    identify: (list, pane) => identifyWith(painter, list, pane),
    dispose: () => { renderer.dispose(); renderer.forceContextLoss(); },
  };
}

function render({ renderer, camera }, meshes, farthest) {
  camera.far = Math.min(Math.max(farthest, 2), GREATEST_DEPTH); // of the logarithmic depth
  const stage = new THREE.Scene();
  stage.add(...meshes);
  renderer.render(stage, camera);
}

/// Draws a list on a pane; returns the spheres that are too small to see, and sentences on what is not drawn rightly.
function paintWith(painter, list, pane) {
  const ratio = Math.min(devicePixelRatio, 2);
  painter.renderer.setPixelRatio(ratio);
  painter.renderer.setSize(pane.width, pane.height, false);
  const packed = packSpheres(list, pane, ratio);
  fillSpheres(painter.spheres, packed, list, pane);
  const size = packed.small.length > 200 ? 4 : 11;
  const rings = packed.small.map(({ centre, colour }) => ({ at: centre, colour, shape: "ring", size }));
  const ofPoints = fillPoints(painter, [...list.points, ...rings], list, pane, ratio);
  const farthest = Math.max(packed.farthest, ofPoints, fillLines(painter, list, pane));
  const { spheres, thin, thinHidden, thick, thickHidden, points, pointsHidden } = painter;
  render(painter, [spheres, thinHidden, thin, thickHidden, thick, pointsHidden, points], farthest);
  const notes = [];
  if (farthest > GREATEST_DEPTH) notes.push("What is 1e30 times as far as the nearest is not drawn.");
  if (packed.unresolved > 1) {
    notes.push(`${packed.unresolved} spheres are so far off for their size that where two cross, either may be in front.`);
  }
  return { small: packed.small, notes };
}

/// The sphere that every pixel of a pane shows, -1 for none; the row at the bottom first.
function identifyWith(painter, list, pane) {
  const { renderer } = painter;
  const { width, height } = pane;
  const packed = packSpheres(list, pane, 1);
  fillSpheres(painter.identities, packed, list, pane);
  const filters = { minFilter: THREE.NearestFilter, magFilter: THREE.NearestFilter };
  const target = new THREE.WebGLRenderTarget(width, height, filters);
  renderer.setRenderTarget(target);
  render(painter, [painter.identities], packed.farthest);
  const bytes = new Uint8Array(4 * width * height);
  renderer.readRenderTargetPixels(target, 0, 0, width, height, bytes);
  renderer.setRenderTarget(null);
  target.dispose();
  const numberAt = (k) => bytes[k] + 256 * bytes[k + 1] + 65536 * bytes[k + 2];
  return Int32Array.from({ length: width * height }, (_, k) => numberAt(4 * k) - 1);
}

/// The sphere that each of width x height pixels of the view from the eye shows, -1 for none; row j = 0 first.
export function eyePicture(store, width, height) {
  const { figure, conventions } = store.scene();
  const { camera, spheres } = figure;
  if (!camera) throw new Error("without a camera there is no view from the eye");
  const painter = webglPainter(document.createElement("canvas"));
  if (!painter) throw new Error("there is no WebGL 2 here");
  const pane = { viewer: eyeViewer(camera), width: width ?? camera.width, height: height ?? camera.height };
  const list = {
    scene: { figure, conventions }, axes: [camera.U, camera.V, camera.W],
    spheres: spheres.centre.map((centre, index) => ({ index, centre, radius: spheres.radius[index], colour: [0, 0, 0] })),
  };
  const seen = painter.identify(list, pane);
  painter.dispose();
  if (camera.rows !== "top-first") return seen;
  return seen.map((_, k) => seen[(pane.height - 1 - Math.floor(k / pane.width)) * pane.width + (k % pane.width)]);
}

/// What the GPU is told of the spheres, the farthest first: where depths are equal, the nearer is in front.
function packSpheres({ spheres }, { viewer, width, height }, ratio) {
  const [x0, x1, y0, y1] = viewer.window;
  const [across, along] = [Math.round(width * ratio), Math.round(height * ratio)];
  const rays = [x0, y0, (x1 - x0) / across, (y1 - y0) / along];
  const [seen, small] = [[], []];
  for (const sphere of spheres) {
    const centre = inView(viewer, sphere.centre);
    const around = sphereWindow(centre, sphere.radius);
    if (around === null) continue;
    const [wide, high] = [(around[1] - around[0]) / Math.abs(rays[2]), (around[3] - around[2]) / Math.abs(rays[3])];
    const radius = Math.max(wide, high) / 2; // on the screen
    const distance = lengthOf(centre);
    if (radius < LEAST_SEEN * ratio) small.push(sphere);
    if (radius < LEAST_DRAWN || distance + sphere.radius > GREATEST_DEPTH * viewer.nearest) continue;
    const x = pixelRange(around[0], around[1], rays[0], rays[2], across);
    const y = pixelRange(around[2], around[3], rays[1], rays[3], along);
    if (x[0] < x[1] && y[0] < y[1]) seen.push({ ...sphere, centre, distance, x, y });
  }
  seen.sort((a, b) => (b.distance - b.radius) - (a.distance - a.radius));
  const data = new Float32Array(27 * seen.length);
  seen.forEach((sphere, k) => data.set(sphereData(sphere, viewer, rays, across, along), 27 * k));
  return {
    data, rays, small, unresolved: seen.filter(({ radius, distance }) => radius < LEAST_RESOLVED * distance).length,
    farthest: seen.reduce((most, { radius, distance }) => Math.max(most, (distance + radius) / viewer.nearest), 0),
  };
}

/// The pixels between two tangents, and one more on either side.
function pixelRange(low, high, origin, step, count) {
  const ends = [(low - origin) / step, (high - origin) / step].sort((a, b) => a - b);
  return [Math.max(0, Math.floor(ends[0]) - 1), Math.min(count, Math.ceil(ends[1]) + 1)];
}

/// The attributes of one sphere, as sphere.frag reads them: differences are taken here, in doubles.
function sphereData({ index, centre, radius, colour, surroundsEye, distance, x, y }, viewer, rays, across, along) {
  const unit = viewer.nearest;
  const T = centre.map((coordinate) => coordinate / radius);
  const [px, py] = [x, y].map(([first, end], k) => {
    const tangent = centre[2] > 0 ? centre[k] / centre[2] : 0;
    return Math.min(Math.max(Math.floor((tangent - rays[k]) / rays[k + 2]), first), end - 1) + 0.5;
  });
  const D = [rays[0] + rays[2] * px, rays[1] + rays[3] * py, 1];
  const greater = Math.fround(distance / unit);
  const isHalf = surroundsEye && !viewer.isEye && distance > radius;
  return [
    (2 * x[0]) / across - 1, (2 * y[0]) / along - 1, (2 * x[1]) / across - 1, (2 * y[1]) / along - 1,
    ...crossProduct(D, T), (D[0] * centre[0] + D[1] * centre[1] + centre[2]) / unit,
    0, -rays[2] * T[2], rays[2] * T[1], (rays[2] * centre[0]) / unit,
    rays[3] * T[2], 0, -rays[3] * T[0], (rays[3] * centre[1]) / unit,
    greater, distance / unit - greater, radius / unit, distance < radius ? 1 : 0,
    ...colour, index, px, py, isHalf ? 1 : 0,
  ];
}

function sphereMesh(defines) {
  const geometry = new THREE.InstancedBufferGeometry();
  geometry.setAttribute("position", new THREE.Float32BufferAttribute([0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0], 3));
  geometry.setIndex([0, 1, 2, 0, 2, 3]);
  return handed(new THREE.Mesh(geometry, new THREE.ShaderMaterial({
    vertexShader: SHADERS["sphere.vert"], fragmentShader: SHADERS["sphere.frag"], side: THREE.DoubleSide, defines,
    transparent: true, blending: defines.IDENTIFY ? THREE.NoBlending : THREE.NormalBlending,
    uniforms: {
      rays: { value: new THREE.Vector4() }, upward: { value: new THREE.Vector3() },
      counted: { value: new THREE.Vector2() }, rule: { value: new THREE.Vector4() },
    },
  })), 0);
}

/// What is handed over lies on the screen: three need not look.
function handed(mesh, order) {
  mesh.frustumCulled = false;
  mesh.renderOrder = order;
  return mesh;
}

function fillSpheres(mesh, packed, { scene, axes }, { viewer }) {
  const sizes = { bounds: 4, turned: 4, turnedX: 4, turnedY: 4, span: 4, tint: 4, reference: 3 };
  fillBuffer(mesh.geometry, packed.data, sizes, true);
  const { rays, upward, counted, rule } = mesh.material.uniforms;
  rays.value.fromArray(packed.rays);
  upward.value.fromArray(viewer.axes.map((axis) => axis[0] * axes[1][0] + axis[1] * axes[1][1] + axis[2] * axes[1][2]));
  // From the eye what counts is what the scene's conventions say, from elsewhere what lies ahead.
  const told = viewer.isEye ? scene.conventions : {};
  const inRadii = told.t_unit === "radius";
  const unit = inRadii ? 1 : 2 ** scene.figure.scale_exponent / viewer.nearest;
  const greatest = Number.isFinite(told.t_max) ? told.t_max * unit : Infinity;
  counted.value.set((told.t_min ?? 0) * unit, Math.min(greatest, 3e38));
  const hasLarger = told.culling !== "back-faces" && told.root !== "smaller";
  const hasSmaller = told.culling !== "front-faces";
  rule.value.set(viewer.start / viewer.nearest, inRadii ? 1 : 0, hasSmaller ? 1 : 0, hasLarger ? 1 : 0);
}

/// Hands interleaved floats to a geometry; its buffer is kept while it is large enough.
function fillBuffer(geometry, data, sizes, isInstanced) {
  const stride = Object.values(sizes).reduce((sum, size) => sum + size);
  let buffer = geometry.attributes[Object.keys(sizes)[0]]?.data;
  if (!buffer || buffer.array.length < data.length) {
    geometry.dispose();
    const Buffer = isInstanced ? THREE.InstancedInterleavedBuffer : THREE.InterleavedBuffer;
    buffer = new Buffer(new Float32Array(2 * data.length + stride), stride);
    buffer.setUsage(THREE.DynamicDrawUsage);
    let offset = 0;
    for (const [name, size] of Object.entries(sizes)) {
      geometry.setAttribute(name, new THREE.InterleavedBufferAttribute(buffer, size, offset));
      offset += size;
    }
  }
  buffer.array.set(data);
  buffer.needsUpdate = true;
  if (isInstanced) geometry.maxInstancedCount = data.length / stride;
  else geometry.setDrawRange(0, data.length / stride);
}

/// What is before the spheres, and, shining through, what they hide.
function passes(make) {
  const pass = (depthFunc, opacity) => make({ transparent: true, depthWrite: false, depthFunc }, opacity);
  return [pass(THREE.LessEqualDepth, 1), pass(THREE.GreaterDepth, 0.5)];
}

function lineMeshes() {
  const meshes = (linewidth) => {
    const geometry = new THREE.LineSegmentsGeometry();
    const style = { linewidth, color: new THREE.Color(1, 1, 1), vertexColors: THREE.VertexColors };
    return passes((pass, opacity) =>
      handed(new THREE.LineSegments2(geometry, new THREE.LineMaterial({ ...style, ...pass, opacity })), 1));
  };
  const [[thin, thinHidden], [thick, thickHidden]] = [meshes(1.3), meshes(2.6)];
  return { thin, thinHidden, thick, thickHidden };
}

/// Returns the greatest depth.
function fillLines(painter, list, pane) {
  const packed = { thin: [], thick: [] };
  let farthest = 0;
  for (const segment of list.segments) {
    for (const [a, b] of strokesOf(pane, segment)) {
      farthest = Math.max(farthest, a[2], b[2]);
      if (Math.max(a[2], b[2]) > GREATEST_DEPTH) continue;
      const ends = [a[0], a[1], -a[2], b[0], b[1], -b[2]];
      packed[segment.isThick ? "thick" : "thin"].push(...ends, ...segment.colour, ...segment.colour);
    }
  }
  for (const [name, data] of Object.entries(packed)) {
    const sizes = { instanceStart: 3, instanceEnd: 3, instanceColorStart: 3, instanceColorEnd: 3 };
    fillBuffer(painter[name].geometry, data, sizes, true);
    for (const mesh of [painter[name], painter[`${name}Hidden`]]) {
      mesh.material.uniforms.resolution.value.set(pane.width, pane.height);
    }
  }
  return farthest;
}

function pointMeshes() {
  const geometry = new THREE.BufferGeometry();
  const [points, pointsHidden] = passes((pass, opacity) => handed(new THREE.Points(geometry, new THREE.ShaderMaterial({
    ...pass, vertexShader: SHADERS["point.vert"], fragmentShader: SHADERS["point.frag"],
    uniforms: { ratio: { value: 1 }, opacity: { value: opacity }, rim: { value: new THREE.Vector3() } },
  })), 2));
  return { points, pointsHidden };
}

/// Returns the greatest depth.
function fillPoints({ points, pointsHidden }, marks, { palette }, { viewer }, ratio) {
  const data = [];
  let farthest = 0;
  for (const { at, colour, shape, size } of marks) {
    const [x, y, w] = homogeneous(viewer, at);
    if (!(w >= 1) || Math.abs(x) > 1.1 * w || Math.abs(y) > 1.1 * w) continue;
    farthest = Math.max(farthest, w);
    if (w <= GREATEST_DEPTH) data.push(x, y, w, ...colour, SHAPES.indexOf(shape), size);
  }
  fillBuffer(points.geometry, data, { position: 3, tint: 4, size: 1 }, false);
  for (const { material } of [points, pointsHidden]) {
    material.uniforms.ratio.value = ratio;
    material.uniforms.rim.value.fromArray(palette.rim);
  }
  return farthest;
}
