// What is shown: the document as it came, and the reader's choice of scene, pixel or ray, sphere and method.

/// document: as `raycheck view --format json` prints it. `set` takes any of {scenesIndex, selection, methodShown, layers}; a
/// selection or layers given in part keep the rest, except that another pixel or ray forgets the sphere, and another scene
/// starts where that scene says. Each `set` calls every subscriber once with the store and the names of what was set.
export function createStore(document) {
  const subscribers = [];
  const store = {
    document,
    scenesIndex: 0,
    selection: { ...document.scenes[0].start },
    methodShown: null,
    layers: {},
    scene: () => document.scenes[store.scenesIndex],
    panelsHere: () => store.scene().panels.filter((panel) => isHere(panel, store.selection)),
    panel: () => {
      const here = store.panelsHere();
      const sphere = store.selection.sphere;
      return (sphere === null ? here[0] : here.find((panel) => panel.sphere === sphere)) ?? null;
    },
    set(partial) {
      if ("scenesIndex" in partial && partial.scenesIndex !== store.scenesIndex) {
        store.scenesIndex = partial.scenesIndex;
        store.selection = { ...store.scene().start };
      }
      if ("selection" in partial) {
        store.selection = completed(partial.selection, store.selection);
      }
      if ("methodShown" in partial) store.methodShown = partial.methodShown;
      if ("layers" in partial) store.layers = { ...store.layers, ...partial.layers };
      for (const subscriber of subscribers) subscriber(store, Object.keys(partial));
    },
    subscribe: (subscriber) => subscribers.push(subscriber),
    /// Goes right and up by so many pixels of the picture, not beyond its edges; along a list of rays either way is forth.
    walk(right, up) {
      const { camera, rays } = store.scene().figure;
      if (rays !== null) {
        const ray = clamp((store.selection.ray ?? 0) + right + up, rays.length);
        store.set({ selection: { ray } });
      } else if (camera !== null) {
        const [i, j] = store.selection.pixel ?? [0, 0];
        const rows = camera.rows === "top-first" ? -up : up;
        store.set({ selection: { pixel: [clamp(i + right, camera.width), clamp(j + rows, camera.height)] } });
      }
    },
  };
  return store;
}

/// How a selection is told: "pixel (9, 8), sphere 0".
export function placeText({ pixel, ray, sphere }) {
  const told = [];
  if (pixel !== null) told.push(`pixel (${pixel[0]}, ${pixel[1]})`);
  if (ray !== null) told.push(`ray ${ray}`);
  if (sphere !== null) told.push(`sphere ${sphere}`);
  return told.join(", ");
}

/// Arrow keys on `target` walk.
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

export function samePlace(a, b) {
  return a.ray === b.ray && (a.pixel === b.pixel || (a.pixel !== null && b.pixel !== null && a.pixel.join() === b.pixel.join()));
}

function isHere(panel, selection) {
  return samePlace(panel, selection);
}

function completed(partial, before) {
  const chosen = { ...before, ...partial };
  if (!samePlace(chosen, before) && !("sphere" in partial)) chosen.sphere = null;
  return chosen;
}

function clamp(index, count) {
  return Math.min(Math.max(index, 0), count - 1);
}
