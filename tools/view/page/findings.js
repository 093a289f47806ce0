// The list of what was found; each goes to its place.
import { brief, element } from "./dom.js";
import { samePlace } from "./store.js";

export function mountFindings(root, store) {
  const { findings } = store.document;
  if (findings.length === 0) return;
  root.hidden = false;
  const buttons = findings.map((finding) => element("button", { type: "button", dir: "auto",
    click: () => store.set({ scenesIndex: finding.scene, methodShown: null,
      selection: { pixel: finding.pixel, ray: finding.ray, sphere: finding.sphere } }) },
  brief(finding.sentence), " ",
  element("span", { class: "quiet" }, `${brief(finding.candidate)}, ${finding.standing}`)));
  root.replaceChildren(element("h2", { id: "findings-heading" }, `Findings (${findings.length})`),
    element("ol", {}, buttons.map((button) => element("li", {}, button))));
  const show = () => buttons.forEach((button, k) => {
    const { scene, sphere } = findings[k];
    const here = scene === store.scenesIndex && samePlace(findings[k], store.selection)
      && (sphere === null || sphere === (store.panel()?.sphere ?? sphere));
    button.setAttribute("aria-current", String(here));
  });
  store.subscribe(show);
  show();
}
