// The list of what was found; each goes to its place.
import { brief, briefSentence, disclosure, element, table } from "./dom.js";

export function mountFindings(root, store) {
  const { findings, found, words } = store.document;
  if (findings.length === 0) return;
  root.hidden = false;
  const buttons = findings.map(({ scene, pixel, ray, sphere, sentence, candidate, standing }) => element("button", {
    type: "button", dir: "auto",
    click: () => store.set({ scenesIndex: scene, methodShown: null, selection: { pixel, ray, sphere } }),
  }, briefSentence(sentence), " ", element("span", { class: "quiet" }, `${brief(candidate)}, ${standing}`)));
  root.replaceChildren(element("h2", { id: "findings-heading" }, `Findings (${found})`),
    element("ol", {}, buttons.map((button) => element("li", {}, button))),
    disclosure("What the words mean", table("Words of this page", ["word", "meaning"], words)));
  store.subscribe(() => buttons.forEach((button, k) =>
    button.setAttribute("aria-current", String(store.findingsHere().includes(findings[k])))));
}
