// The list of what was found; each goes to its place.
import { brief, briefSentence, element } from "./dom.js";

export function mountFindings(root, store) {
  const { findings } = store.document;
  if (findings.length === 0) return;
  root.hidden = false;
  const buttons = findings.map(({ scene, pixel, ray, sphere, sentence, candidate, standing }) => element("button", {
    type: "button", dir: "auto",
    click: () => store.set({ scenesIndex: scene, methodShown: null, selection: { pixel, ray, sphere } }),
  }, briefSentence(sentence), " ", element("span", { class: "quiet" }, `${brief(candidate)}, ${standing ?? "within its bound"}`)));
  root.replaceChildren(element("h2", { id: "findings-heading" }, `Findings (${findings.length})`),
    element("ol", {}, buttons.map((button) => element("li", {}, button))));
  const show = () => buttons.forEach((button, k) =>
    button.setAttribute("aria-current", String(store.findingsHere().includes(findings[k]))));
  store.subscribe(show);
  show();
}
