// The state of the page: the loaded document, and the reader's choice of scene, ray, sphere and
// method.

/// document: as `raycheck view --format json` prints it. `set` takes any of {scenesIndex, selection, methodShown,
/// layers} and calls every subscriber with the store and the names of what was set; a new subscriber is called at once.
/// A partial selection keeps the rest, except that another pixel or ray drops the sphere; another scene begins with its
/// start selection. The first scene is the first finding's.
export function createStore(document) {
  const subscribers = [];
  const first = document.findings[0]?.scene ?? 0;
  const store = {
    document,
    scenesIndex: first,
    selection: { ...document.scenes[first].start },
    methodShown: null,
    layers: {},
    scene: () => document.scenes[store.scenesIndex],
    /// The panels of the chosen pixel or ray, one per sphere.
    panelsHere: () => store.scene().panels.filter((panel) => samePlace(panel, store.selection)),
    panel: () => {
      const { sphere } = store.selection;
      const here = store.panelsHere();
      return (sphere === null ? here[0] : here.find((panel) => panel.sphere === sphere)) ?? null;
    },
    /// The findings at the chosen place, the worst first.
    findingsHere: () => document.findings.filter((one) => one.scene === store.scenesIndex
      && samePlace(one, store.selection) && [null, store.panel()?.sphere].includes(one.sphere)),
    /// The method in question: the method shown, or the worst method here; null if no method is
    /// wrong.
    methodTold: () => store.methodShown ?? store.findingsHere()[0]?.method
      ?? store.panel()?.verdicts.find((one) => one.wrong)?.name ?? null,
    set(partial) {
      if ("scenesIndex" in partial && partial.scenesIndex !== store.scenesIndex) {
        store.scenesIndex = partial.scenesIndex;
        store.selection = { ...store.scene().start };
      }
      if ("selection" in partial) {
        const chosen = { ...store.selection, ...partial.selection };
        if (!samePlace(chosen, store.selection) && !("sphere" in partial.selection)) chosen.sphere = null;
        store.selection = chosen;
      }
      if ("methodShown" in partial) store.methodShown = partial.methodShown;
      Object.assign(store.layers, partial.layers);
      for (const subscriber of subscribers) subscriber(store, Object.keys(partial));
    },
    subscribe(subscriber) {
      subscribers.push(subscriber);
      subscriber(store, []);
    },
    /// Moves the selection by pixels right and up in the picture, or by rays, but not beyond the
    /// edges.
    walk(right, up) {
      const { camera, rays } = store.scene().figure;
      const within = (index, count) => Math.min(Math.max(index, 0), count - 1);
      const { ray, pixel } = store.selection;
      if (camera === null) return store.set({ selection: { ray: within((ray ?? 0) + right - up, rays.length) } });
      const [i, j] = pixel ?? [0, 0];
      const rows = camera.rows === "top-first" ? -up : up;
      return store.set({ selection: { pixel: [within(i + right, camera.width), within(j + rows, camera.height)] } });
    },
  };
  return store;
}

/// "pixel (9, 8), sphere 0"
export function placeText({ pixel, ray, sphere }) {
  return [pixel && `pixel (${pixel.join(", ")})`, ray !== null && `ray ${ray}`, sphere !== null && `sphere ${sphere}`]
    .filter(Boolean).join(", ");
}

/// Whether two selections have the same pixel or ray.
const samePlace = (a, b) => a.ray === b.ray && String(a.pixel) === String(b.pixel);

/// Arrow keys on `target` walk from pixel to pixel, and with Shift by ten pixels.
export function walkByKeys(target, store) {
  const steps = { ArrowRight: [1, 0], ArrowLeft: [-1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };
  target.addEventListener("keydown", (event) => {
    const step = steps[event.key];
    if (step === undefined || event.altKey || event.ctrlKey || event.metaKey) return;
    event.preventDefault();
    store.walk(...step.map((one) => one * (event.shiftKey ? 10 : 1)));
  });
}
