// The chosen ray: the sentence at the top of the page, the panel of the ray's steps, and the
// findings.
import { brief, briefSentence, choice, copyButton, disclosure, element } from "./dom.js";
import { formula, labelled, mathematics, refill, table } from "./dom.js";
import { placeText } from "./store.js";

const LONGEST_SHOWN = 400; // characters of MathML that are shown at once
const NAMES_TOLD = 4; // the number of agreeing methods that are named before "and 3 more"
const NO_PANEL = "This page has no steps for this ray and sphere.";

/// The sentence that says what went wrong, and the fields that choose another ray.
export function mountStory(root, store) {
  const fields = element("div", { class: "fields", id: "chooser" });
  root.append(fields);
  store.subscribe(() => {
    const told = store.panel();
    const { findings, worst } = store.document;
    const isWorst = findings.length > 0 && store.findingsHere()[0] === findings[0];
    root.querySelector("#headline").replaceChildren(
      element("span", { class: "place" }, placeText(told ?? store.selection), isWorst ? worst : ""), " ",
      element("span", { class: "sentence" }, headlineOf(store, told)));
    refill(fields, chooserFields(store));
  });
}

/// The steps, with the value of each method below the exact value; the output of `explain`; and
/// texts to copy.
export function mountPanel(root, store) {
  const opened = new Map(); // symbol -> whether the reader opened it
  const show = () => {
    const told = store.panel();
    refill(root, element("h2", { id: "panel-heading" }, "Step by step"), told === null ? howToAsk(store) : [
      methodFilter(store, told),
      element("div", { id: "steps" }, told.steps.map((step, k) => stepView(step, k, store, opened))),
      element("h3", {}, "Answers"), verdictList(told, store.methodShown), takeAway(told, store.scene().toml)]);
  };
  store.subscribe(show);
  addEventListener("beforeprint", () => {
    for (const step of root.querySelectorAll("#steps > details")) step.open = true;
  });
  addEventListener("afterprint", show);
}

function headlineOf(store, told) {
  if (told === null) return NO_PANEL;
  const name = store.methodTold();
  const ofName = told.verdicts.filter((one) => one.name === name); // a ray method may share its name
  const verdict = ofName.find((one) => one.wrong) ?? ofName.at(-1);
  const [finding] = store.findingsHere(); // it may be a picture's, which has no steps
  const said = verdict ? [element("strong", { dir: "auto" }, brief(name)), ": ", spoken(verdict.said)]
    : finding ? `${brief(finding.candidate)}: ${briefSentence(finding.sentence)}` : "No method goes wrong here";
  const looks = finding?.looks_like ? ` ${briefSentence(finding.looks_like)}` : "";
  return [said, "; exactly ", spoken(told.exact.said), ".", looks];
}

function chooserFields(store) {
  const { selection, document: { scenes, dial } } = store;
  const { camera, rays } = store.scene().figure;
  const choose = (chosen) => store.set({ selection: chosen });
  const [i, j] = selection.pixel ?? [0, 0];
  const spheres = store.panelsHere().filter(({ sphere }) => sphere !== null).map(({ sphere }) => [sphere, sphere]);
  return [
    scenes.length > 1 && dial === null ? choice("scene", "Scene", scenes.map(({ name }, k) => [k, name]),
      store.scenesIndex, (value) => store.set({ scenesIndex: Number(value) })) : null,
    camera === null ? null : numberField("pixel-i", "Pixel i", i, camera.width, (to) => choose({ pixel: [to, j] })),
    camera === null ? null : numberField("pixel-j", "j", j, camera.height, (to) => choose({ pixel: [i, to] })),
    rays?.length > 1 ? numberField("ray", "Ray", selection.ray, rays.length, (ray) => choose({ ray })) : null,
    spheres.length > 1 ? choice("sphere", "Sphere", spheres, store.panel()?.sphere,
      (value) => choose({ sphere: Number(value) })) : null];
}

function numberField(id, label, value, count, onChange) {
  const change = ({ target }) => (target.checkValidity() ? onChange(target.valueAsNumber) : target.reportValidity());
  return labelled(id, label,
    element("input", { id, type: "number", min: 0, max: count - 1, step: 1, required: true, value, change }));
}

function howToAsk(store) {
  const { pixel, sphere } = store.selection;
  const place = `${pixel === null ? "" : ` --pixel ${pixel.join()}`}${sphere === null ? "" : ` --sphere ${sphere}`}`;
  const command = `${store.scene().command}${place} --out page.html`;
  return element("p", { id: "no-panel" }, `${NO_PANEL} A page with them is made by `,
    element("code", { dir: "auto" }, briefSentence(command)), " ", copyButton("copy-view", "Copy", command));
}

function methodFilter({ methodShown, set }, { verdicts }) {
  const wrong = new Set(verdicts.filter((one) => one.wrong).map(({ name }) => name));
  const names = [...new Set([...wrong, ...verdicts.map(({ name }) => name)])];
  const chip = (name, k) => element("button", { type: "button", class: "chip", dir: "auto",
    id: name === null ? "method-all" : `method-${k}`, "aria-pressed": String(methodShown === name),
    click: () => set({ methodShown: methodShown === name ? null : name }) },
  wrong.has(name) ? element("span", { class: "wrong", "aria-label": "wrong: ", role: "img" }, "\u2717 ") : "",
  brief(name ?? "all methods"));
  return element("div", { id: "methods", role: "group", "aria-label": "Methods shown" }, [null, ...names].map(chip));
}

/// A step is open if the method in question is wrong there.
function stepView(step, k, store, opened) {
  const told = store.methodTold();
  const isShown = (name) => store.methodShown === null || name === store.methodShown;
  const answers = step.answers.map((one) => ({ ...one, names: one.names.filter(isShown) }))
    .filter(({ names }) => names.length > 0);
  const wrong = answers.filter((one) => one.wrong).flatMap(({ names }) => names);
  const first = wrong.includes(told) ? told : wrong[0];
  const more = wrong.length > 1 ? ` and ${wrong.length - 1} more` : "";
  const view = element("details", { id: `step-${k}`, "data-symbol": step.symbol,
    class: first ? "step wrong-step" : "step", open: opened.get(step.symbol) ?? wrong.includes(told) },
  element("summary", { id: `summary-${k}`, click: () => opened.set(step.symbol, !view.open) },
    element("h3", {}, symbolOf(step.symbol)), element("span", { class: "number" }, step.rounded),
    element("span", { class: "wrong" }, first ? `\u2717 goes wrong here: ${brief(first)}${more}` : "")),
  element("p", { class: "formula" }, symbolOf(step.symbol), " = ", formula(step.formula)), closedForm(step),
  element("p", { class: "quiet" }, step.condition),
  answers.length === 0 ? null : table(`Step ${k + 1}, ${step.symbol}: values of methods`, ["methods", "value", "error"],
    answers.map((one) => [agreeing(one.names), spoken(one.said),
      [one.off, one.wrong ? element("strong", { class: "wrong" }, " \u2717 goes wrong here") : ""]]), "values"));
  return view;
}

function closedForm({ symbol, mathml }) {
  if (mathml === null) return null;
  const set = element("div", { class: "closed", tabindex: "0", role: "group",
    "aria-label": `closed form of ${symbol}` }, mathematics(mathml));
  return mathml.length <= LONGEST_SHOWN ? set : disclosure("closed form", set);
}

function agreeing(names) {
  const told = names.map((name) => brief(name));
  const more = told.splice(NAMES_TOLD);
  return [told.join(", "), more.length === 0 ? "" : disclosure(`and ${more.length} more`, more.join(", "))];
}

function verdictList({ verdicts }, methodShown) {
  const shown = verdicts.filter((one) => methodShown === null || one.name === methodShown);
  const groups = [...Map.groupBy(shown, ({ wrong, said }) => `${wrong} ${said}`).values()];
  return element("dl", { id: "verdicts" }, groups.map((same) => element("div", {},
    element("dt", { dir: "auto", class: same[0].wrong ? "wrong" : null },
      same[0].wrong ? "\u2717 " : "", same.map(({ name }) => brief(name)).join(", ")),
    element("dd", { dir: "auto" }, spoken(same[0].said)))));
}

function takeAway({ command, text }, toml) {
  return [element("h3", { class: "screen" }, "Take it away"), element("div", { class: "fields screen" },
    copyButton("copy-toml", "Copy as TOML scene", toml), copyButton("copy-command", "Copy as command", command)),
  element("details", { id: "explain" },
    element("summary", {}, "What ", element("code", { dir: "auto" }, briefSentence(command)), " prints"),
    element("pre", { id: "explain-text", tabindex: "0" }, text))];
}

const symbolOf = (text) => element("i", { class: "symbol" }, formula(text));

/// A sentence in parts [kind, text]: a symbol, a number, its wrong digits as a mark, something wrong, or plain text.
function spoken(parts) {
  return parts.map(([kind, text]) => (kind === "symbol" ? symbolOf(text)
    : element(kind === "mark" ? "mark" : "span", { class: kind }, briefSentence(text))));
}

/// The list of findings; each links to its place.
export function mountFindings(root, store) {
  const { findings, found, words } = store.document;
  if (findings.length === 0) return;
  root.hidden = false;
  const buttons = findings.map((finding) => element("button", {
    type: "button", dir: "auto", click: () => goTo(store, finding),
  }, briefSentence(finding.sentence), " ",
  element("span", { class: "quiet" }, `${brief(finding.candidate)}, ${finding.standing}`)));
  root.replaceChildren(element("h2", { id: "findings-heading" }, `Findings (${found})`),
    element("ol", {}, buttons.map((button) => element("li", {}, button))),
    disclosure("What the words mean", table("Words of this page", ["word", "meaning"], words)));
  store.subscribe(() => buttons.forEach((button, k) =>
    button.setAttribute("aria-current", String(store.findingsHere().includes(findings[k])))));
}

/// Goes to the finding in the page's address ("#finding-3" is the third), now and whenever the
/// address changes.
export function followAddress(store) {
  const follow = () => {
    const number = /^#finding-(\d{1,9})$/.exec(window.location.hash)?.[1];
    const finding = store.document.findings[Number(number) - 1];
    if (finding !== undefined) goTo(store, finding);
  };
  window.addEventListener("hashchange", follow);
  follow();
}

function goTo(store, { scene, pixel, ray, sphere }) {
  store.set({ scenesIndex: scene, methodShown: null, selection: { pixel, ray, sphere } });
}
