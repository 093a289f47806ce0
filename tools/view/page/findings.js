// The list of what was found; each goes to its place.
import { brief, briefSentence, disclosure, element, table } from "./dom.js";

export function mountFindings(root, store) {
  const { findings, found, words } = store.document;
  if (findings.length === 0) return;
  root.hidden = false;
  const buttons = findings.map((finding) => element("button", {
    type: "button", dir: "auto", click: () => open(store, finding),
  }, briefSentence(finding.sentence), " ",
  element("span", { class: "quiet" }, `${brief(finding.candidate)}, ${finding.standing}`)));
  root.replaceChildren(element("h2", { id: "findings-heading" }, `Findings (${found})`),
    element("ol", {}, buttons.map((button) => element("li", {}, button))),
    disclosure("What the words mean", table("Words of this page", ["word", "meaning"], words)));
  store.subscribe(() => buttons.forEach((button, k) =>
    button.setAttribute("aria-current", String(store.findingsHere().includes(findings[k])))));
}

/// Goes to the finding that the page's address names, "#finding-3" the third, now and whenever it changes.
export function followAddress(store) {
  const follow = () => {
    const number = /^#finding-(\d{1,9})$/.exec(window.location.hash)?.[1];
    const finding = store.document.findings[Number(number) - 1];
    if (finding !== undefined) open(store, finding);
  };
  window.addEventListener("hashchange", follow);
  follow();
}

function open(store, { scene, pixel, ray, sphere }) {
  store.set({ scenesIndex: scene, methodShown: null, selection: { pixel, ray, sphere } });
}
