// What is told of the chosen ray: the sentence at the page's top, and the panel of its steps.
import { alike, brief, briefSentence, choice, copyButton, disclosure, element, formula, mathematics } from "./dom.js";
import { placeText } from "./store.js";

const LONGEST_SHOWN = 400; // characters of MathML that are shown without being asked for
const NAMES_TOLD = 4; // of methods that agree, before "and 3 more"

/// The sentence that says what went wrong, and the fields that choose another ray.
export function mountStory(root, store) {
  const headline = root.querySelector("#headline");
  const fields = element("div", { class: "fields", id: "chooser" });
  root.append(fields);
  const show = () => {
    const told = store.panel();
    headline.replaceChildren(element("span", { class: "place" }, placeText(told ?? store.selection)), " ",
      element("span", { class: "sentence" }, headlineOf(store, told)));
    const focused = document.activeElement?.id; // fields made anew keep the focus that one of them had
    fields.replaceChildren(...chooserFields(store));
    if (focused) fields.querySelector(`#${CSS.escape(focused)}`)?.focus();
  };
  store.subscribe(show);
  show();
}

/// The steps, each method's value below the exact one, what explain prints, and what can be copied.
export function mountPanel(root, store) {
  const opened = new Map(); // symbol -> whether the reader opened it
  const show = () => {
    const told = store.panel();
    const focused = root.contains(document.activeElement) ? document.activeElement.id : "";
    root.replaceChildren(element("h2", { id: "panel-heading" }, "Step by step"), ...(told === null ? howToAsk(store) : [
      methodFilter(store, told),
      element("div", { id: "steps" }, told.steps.map((step, k) => stepView(step, k, store.methodShown, opened))),
      element("h3", {}, "Answers"), verdictList(told, store.methodShown),
      ...takeAway(told, store.scene().toml)]));
    if (focused) document.getElementById(focused)?.focus();
  };
  store.subscribe(show);
  show();
  let printed = [];
  addEventListener("beforeprint", () => {
    printed = [...root.querySelectorAll("#steps > details:not([open])")];
    for (const step of printed) step.open = true;
  });
  addEventListener("afterprint", () => {
    for (const step of printed) step.open = false;
  });
}

function headlineOf(store, told) {
  if (told === null) return "This page has no panel for this choice.";
  const exactly = told.exact === null ? "no sphere" : told.exact.s === null ? `a ${told.exact.class}`
    : [symbolOf("s"), " = ", element("span", { class: "number" }, told.exact.s)];
  const name = store.methodTold();
  const ofName = told.verdicts.filter((one) => one.name === name); // a ray method may share its name
  const verdict = ofName.find((one) => one.wrong) ?? ofName.at(-1);
  if (!verdict) {
    const found = store.findingsHere().find((one) => one.standing !== null); // of a picture, which tells no steps
    return [found ? `${brief(found.candidate)}: ${briefSentence(found.sentence)}. Exactly: ` : "No method goes wrong here. Exactly: ", exactly, "."];
  }
  const subject = element("strong", { dir: "auto" }, brief(name));
  if (!verdict.error || !told.exact?.s) return [subject, ": ", briefSentence(verdict.text), "; exactly ", exactly, "."];
  return [subject, " answers ", symbolOf("s"), " = ", markedDigits(verdict, 0), "; exactly ",
    element("span", { class: "number" }, told.exact.s), `; off by ${verdict.error} ${verdict.unit}`, verdict.goes_wrong_at === "" ? ""
      : ["; ", element("strong", { class: "wrong" }, "goes wrong at ", symbolOf(verdict.goes_wrong_at))], "."];
}

function chooserFields(store) {
  const { selection, document: { scenes, dial } } = store;
  const { camera, rays } = store.scene().figure;
  const fields = [];
  if (scenes.length > 1 && dial === null) {
    fields.push(choice("scene", "Scene", scenes.map((scene, k) => [k, scene.name]), store.scenesIndex,
      (value) => store.set({ scenesIndex: Number(value) })));
  }
  if (camera !== null) {
    const [i, j] = selection.pixel ?? [0, 0];
    fields.push(numberField("pixel-i", "Pixel i", i, camera.width, (to) => store.set({ selection: { pixel: [to, j] } })),
      numberField("pixel-j", "j", j, camera.height, (to) => store.set({ selection: { pixel: [i, to] } })));
  } else if (rays.length > 1) {
    fields.push(numberField("ray", "Ray", selection.ray, rays.length, (ray) => store.set({ selection: { ray } })));
  }
  const spheres = store.panelsHere().filter((panel) => panel.sphere !== null).map(({ sphere }) => [sphere, String(sphere)]);
  if (spheres.length > 1) {
    fields.push(choice("sphere", "Sphere", spheres, store.panel()?.sphere,
      (value) => store.set({ selection: { sphere: Number(value) } })));
  }
  const toStart = () => store.set({ selection: { ...store.scene().start }, methodShown: null });
  return [...fields, element("button", { type: "button", id: "go-start", click: toStart }, "Back to the start")];
}

function numberField(id, label, value, count, onChange) {
  const change = ({ target }) => {
    const chosen = target.valueAsNumber;
    if (Number.isInteger(chosen) && chosen >= 0 && chosen < count) onChange(chosen);
    else target.value = value;
  };
  return element("label", { for: id, class: "field" }, element("span", {}, label),
    element("input", { id, type: "number", min: 0, max: count - 1, step: 1, value, change }));
}

function howToAsk(store) {
  const { pixel, sphere } = store.selection;
  if (pixel === null) return [element("p", { id: "no-panel" }, "This page has no panel for this choice.")];
  const command = `${store.scene().command ?? "raycheck view SCENE"} --pixel ${pixel.join()}${sphere === null ? "" : ` --sphere ${sphere}`} --out page.html`;
  return [element("p", { id: "no-panel" }, "This page has no panel for this choice. One that has it is made by ",
    element("code", { dir: "auto" }, briefSentence(command)), " ", copyButton("copy-view", "Copy", command))];
}

function methodFilter(store, told) {
  const wrong = new Set(told.verdicts.filter((one) => one.wrong).map((one) => one.name));
  const names = [...new Set([...wrong, ...told.verdicts.map((one) => one.name)])];
  const button = (name, k, text) => element("button", { type: "button", class: "chip", dir: "auto", id: `method-${k}`,
    "aria-pressed": String(store.methodShown === name),
    click: () => store.set({ methodShown: store.methodShown === name ? null : name }) },
  wrong.has(name) ? element("span", { class: "wrong" }, "\u2717 ", element("span", { class: "unseen" }, "wrong: ")) : "",
  brief(text));
  return element("div", { id: "methods", role: "group", "aria-label": "Methods shown" },
    button(null, "all", "all methods"), names.map((name, k) => button(name, k, name)));
}

function stepView(step, k, methodShown, opened) {
  const methods = step.methods.filter((method) => methodShown === null || method.name === methodShown);
  const wrong = methods.filter((method) => method.wrong).length;
  const told = wrong === 0 ? "" : `\u2717 goes wrong here: ${wrong === 1 ? "1 method" : `${wrong} methods`}`;
  const alone = step.condition_alone === null ? "" : `, of this step alone ${step.condition_alone}`;
  const view = element("details", { id: `step-${k}`, "data-symbol": step.symbol, class: wrong > 0 ? "step wrong-step" : "step",
    open: opened.get(step.symbol) ?? wrong > 0 },
  element("summary", { id: `summary-${k}`, click: () => opened.set(step.symbol, !view.open) },
    element("h3", {}, symbolOf(step.symbol)), element("span", { class: "number" }, vectorOf(step.rounded)),
    element("span", { class: "wrong" }, told)),
  element("p", { class: "formula" }, symbolOf(step.symbol), " = ", formula(step.formula)),
  closedForm(step),
  step.condition === null ? null : element("p", { class: "quiet" }, `condition number ${step.condition}${alone}`),
  methods.length > 0 ? methodTable(step, methods) : null);
  return view;
}

function closedForm({ symbol, mathml, latex }) {
  if (mathml === null) {
    return latex === null ? null : element("p", { class: "quiet" },
      `A closed form of ${latex.length} characters, too long to be set here: copy the LaTeX below.`);
  }
  const set = element("div", { class: "closed", tabindex: "0", role: "group", "aria-label": `closed form of ${symbol}` },
    mathematics(mathml));
  return mathml.length <= LONGEST_SHOWN ? set : disclosure("closed form", set);
}

/// Methods whose values, errors and standing agree share a row.
function methodTable(step, methods) {
  const row = ([method, ...others]) => element("tr", {},
    element("th", { scope: "row", dir: "auto" }, agreeing([method, ...others])),
    element("td", { class: "number" }, vectorOf(method.value.map((_, k) => markedDigits(method, k)))),
    element("td", {}, method.error === null ? "" : `off by ${method.error} ${method.unit}`,
      method.alone === null ? "" : element("span", { class: "quiet" }, ` (${method.alone} alone)`),
      method.wrong ? element("strong", { class: "wrong" }, " \u2717 goes wrong here") : ""));
  return element("table", { class: "values" },
    element("caption", { class: "unseen" }, `What methods have for ${step.symbol}`),
    element("thead", { class: "unseen" },
      element("tr", {}, ["methods", "value", "error"].map((text) => element("th", { scope: "col" }, text)))),
    element("tbody", {}, alike(methods, (method) => JSON.stringify({ ...method, name: null })).map(row)));
}

function agreeing(methods) {
  const told = (some) => some.map((method) => brief(method.name)).join(", ");
  if (methods.length <= NAMES_TOLD) return told(methods);
  return [told(methods.slice(0, NAMES_TOLD)),
    disclosure(`and ${methods.length - NAMES_TOLD} more`, told(methods.slice(NAMES_TOLD)))];
}

function vectorOf(parts) {
  if (parts.length === 1) return parts[0];
  return parts.map((part, k) => element("span", { class: "component" },
    k === 0 ? "(" : "", part, k === parts.length - 1 ? ")" : ", "));
}

/// A component's value; what follows its first `right_digits` characters is marked.
function markedDigits(method, k) {
  const [value, right] = [method.value[k], method.right_digits[k]];
  return element("span", { class: "number" }, value.slice(0, right),
    right < value.length ? element("mark", {}, value.slice(right)) : "");
}

function verdictList(told, methodShown) {
  const shown = told.verdicts.filter((one) => methodShown === null || one.name === methodShown);
  return element("dl", { id: "verdicts" }, alike(shown, (one) => JSON.stringify([one.wrong, one.text])).map((same) =>
    element("div", {}, element("dt", { dir: "auto", class: same[0].wrong ? "wrong" : null },
      same[0].wrong ? "\u2717 " : "", same.map((one) => brief(one.name)).join(", ")),
    element("dd", { dir: "auto" }, briefSentence(same[0].text)))));
}

function takeAway(told, toml) {
  return [element("h3", { class: "screen" }, "Take it away"), element("div", { class: "fields screen" },
    copyButton("copy-toml", "Copy as TOML scene", toml), copyButton("copy-command", "Copy as command", told.command),
    copyButton("copy-latex", "Copy as LaTeX", told.latex), copyButton("copy-sage", "Copy as Sage", told.sage)),
  element("details", { id: "explain" },
    element("summary", {}, "What ", element("code", { dir: "auto" }, briefSentence(told.command)), " prints"),
    element("pre", { id: "explain-text", tabindex: "0" }, told.text))];
}

function symbolOf(text) {
  return element("i", { class: "symbol" }, formula(text));
}
