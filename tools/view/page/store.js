// What is shown: the document as it came, and the reader's choice of scene, ray, sphere, method.

/// document: as `raycheck view --format json` prints it. `set` takes any of {scenesIndex,
/// selection, methodShown, layers} and calls every subscriber once with the store and the names of
/// what was set. A selection given in part keeps the rest, except that another pixel or ray forgets
/// the sphere; another scene starts where it says. The first scene is the first finding's.
export function createStore(document) {
  const subscribers = [];
  const numbers = new Map(); // of methods, as they are asked for
  const first = document.findings[0]?.scene ?? 0;
  const store = {
    document,
    scenesIndex: first,
    selection: { ...document.scenes[first].start },
    methodShown: null,
    layers: {},
    scene: () => document.scenes[store.scenesIndex],
    /// All that is told of the chosen pixel or ray, a panel a sphere.
    panelsHere: () => store.scene().panels.filter((panel) => samePlace(panel, store.selection)),
    panel: () => {
      const { sphere } = store.selection;
      const here = store.panelsHere();
      return (sphere === null ? here[0] : here.find((panel) => panel.sphere === sphere)) ?? null;
    },
    /// Which shape and colour a method has, everywhere in the page.
    methodNumber(name) {
      if (!numbers.has(name)) numbers.set(name, numbers.size);
      return numbers.get(name);
    },
    /// What was found at the chosen place, the worst first.
    findingsHere: () => document.findings.filter((one) => one.scene === store.scenesIndex
      && samePlace(one, store.selection) && [null, store.panel()?.sphere].includes(one.sphere)),
    /// The method that the page speaks of: the one shown, or the worst one here; null where none goes wrong.
    methodTold: () => store.methodShown ?? store.findingsHere()[0]?.method
      ?? store.panel()?.verdicts.find((one) => one.wrong)?.name ?? null,
    set(partial) {
      if ("scenesIndex" in partial && partial.scenesIndex !== store.scenesIndex) {
        store.scenesIndex = partial.scenesIndex;
        store.selection = { ...store.scene().start };
      }
      if ("selection" in partial) store.selection = completed(partial.selection, store.selection);
      if ("methodShown" in partial) store.methodShown = partial.methodShown;
      if ("layers" in partial) store.layers = { ...store.layers, ...partial.layers };
      for (const subscriber of subscribers) subscriber(store, Object.keys(partial));
    },
    subscribe: (subscriber) => subscribers.push(subscriber),
    /// Goes so many pixels right and up in the picture, or rays forth, not beyond its edges.
    walk(right, up) {
      const { camera, rays } = store.scene().figure;
      if (camera === null) {
        const ray = within((store.selection.ray ?? 0) + right - up, rays.length);
        store.set({ selection: { ray } });
      } else {
        const [i, j] = store.selection.pixel ?? [0, 0];
        const rows = camera.rows === "top-first" ? -up : up;
        const pixel = [within(i + right, camera.width), within(j + rows, camera.height)];
        store.set({ selection: { pixel } });
      }
    },
  };
  return store;
}

/// "pixel (9, 8), sphere 0"
export function placeText({ pixel, ray, sphere }) {
  const told = [];
  if (pixel !== null) told.push(`pixel (${pixel[0]}, ${pixel[1]})`);
  if (ray !== null) told.push(`ray ${ray}`);
  if (sphere !== null) told.push(`sphere ${sphere}`);
  return told.join(", ");
}

/// The same pixel or ray.
export function samePlace(a, b) {
  return a.ray === b.ray && String(a.pixel) === String(b.pixel);
}

/// Arrow keys on `target` walk from pixel to pixel, ten at once with Shift.
export function walkByKeys(target, store) {
  const steps = { ArrowRight: [1, 0], ArrowLeft: [-1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };
  target.addEventListener("keydown", (event) => {
    const step = steps[event.key];
    if (step === undefined || event.altKey || event.ctrlKey || event.metaKey) return;
    event.preventDefault();
    const wide = event.shiftKey ? 10 : 1;
    store.walk(step[0] * wide, step[1] * wide);
  });
}

function completed(partial, before) {
  const chosen = { ...before, ...partial };
  if (!samePlace(chosen, before) && !("sphere" in partial)) chosen.sphere = null;
  return chosen;
}

function within(index, count) {
  return Math.min(Math.max(index, 0), count - 1);
}
