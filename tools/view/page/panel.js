// What is told of the chosen ray: the sentence at the page's top, and the panel of its steps.
import { brief, choice, copyButton, disclosure, element, formula, mathematics } from "./dom.js";
import { placeText } from "./store.js";

const LONGEST_SHOWN = 400;  // characters of MathML that are shown without being asked for
const GROUP_SHOWN = 4;      // names of methods that agree, before "and 3 more"

/// The sentence that says what went wrong, and the fields that choose another ray.
export function mountStory(root, store) {
  const headline = root.querySelector("#headline");
  const fields = element("div", { class: "fields", id: "chooser" });
  root.append(fields);
  const show = () => {
    const told = store.panel();
    headline.replaceChildren(element("span", { class: "place" }, placeText(told ?? store.selection)),
      " ", element("span", { class: "sentence" }, sentence(store, told)));
    const focused = document.activeElement?.id;
    fields.replaceChildren(...chooserFields(store));
    if (focused && fields.querySelector(`#${CSS.escape(focused)}`)) {
      document.getElementById(focused).focus();
    }
  };
  store.subscribe(show);
  show();
}

/// The steps, each method's value below the exact one, what explain prints, and what can be copied.
export function mountPanel(root, store) {
  const opened = new Map();  // symbol -> open, where the reader has chosen
  const show = () => {
    const told = store.panel();
    const heading = element("h2", { id: "panel-heading" }, "Step by step");
    if (told === null) {
      root.replaceChildren(heading, howToAsk(store));
      return;
    }
    root.replaceChildren(heading, methodFilter(store, told),
      element("div", { id: "steps" }, told.steps.map((step) => stepView(step, store, opened))),
      element("h3", {}, "Answers"), verdicts(told, store.methodShown),
      element("h3", {}, "Take it away"), takeAway(told));
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

function sentence(store, told) {
  if (told === null) return ["has no panel in this page."];
  const exact = told.steps.find((step) => step.symbol === "s");
  const name = store.methodShown ?? told.worst;
  const verdict = told.verdicts.find((one) => one.name === name && (one.wrong || name !== told.worst));
  if (!verdict) {
    const s = exact ? ["Exactly ", symbol("s"), ` = ${exact.rounded[0]}.`] : [];
    return ["No method goes wrong here. ", ...s];
  }
  const answer = exact?.methods.find((method) => method.name === name);
  const subject = element("strong", { dir: "auto" }, brief(name));
  if (!answer) return [subject, ": ", brief(verdict.text)];
  const wrong = told.steps.find((step) =>
    step.methods.some((method) => method.name === name && method.wrong));
  return [subject, " answers ", symbol("s"), " = ", digits(answer, 0), "; exactly ",
    element("span", { class: "number" }, exact.rounded[0]), "; ", ...errorText(answer),
    ...(wrong ? ["; ", element("strong", { class: "wrong" }, "goes wrong at ", symbol(wrong.symbol))] : []),
    "."];
}

function chooserFields(store) {
  const { selection } = store;
  const { camera, rays } = store.scene().figure;
  const fields = [];
  if (store.document.scenes.length > 1 && store.document.dial === null) {
    fields.push(choice("scene", "Scene", store.document.scenes.map((scene, k) => [k, scene.name]),
      store.scenesIndex, (value) => store.set({ scenesIndex: Number(value) })));
  }
  if (camera !== null) {
    const go = (k, value) => {
      const pixel = [...(selection.pixel ?? [0, 0])];
      pixel[k] = value;
      store.set({ selection: { pixel } });
    };
    fields.push(numberField("pixel-i", "Pixel i", selection.pixel?.[0], camera.width, (i) => go(0, i)),
      numberField("pixel-j", "j", selection.pixel?.[1], camera.height, (j) => go(1, j)));
  } else if (rays.length > 1) {
    fields.push(numberField("ray", "Ray", selection.ray, rays.length,
      (ray) => store.set({ selection: { ray } })));
  }
  const spheres = store.panelsHere().filter((panel) => panel.sphere !== null);
  if (spheres.length > 1) {
    fields.push(choice("sphere", "Sphere", spheres.map((panel) => [panel.sphere, panel.sphere]),
      store.panel()?.sphere, (value) => store.set({ selection: { sphere: Number(value) } })));
  }
  fields.push(element("button", { type: "button", id: "go-start",
    click: () => store.set({ selection: { ...store.scene().start }, methodShown: null }) },
  "Back to the start"));
  return fields;
}

function numberField(id, label, value, count, onChange) {
  return element("label", { for: id, class: "field" }, element("span", {}, label),
    element("input", { id, type: "number", min: 0, max: count - 1, step: 1, value, change: (event) => {
      const chosen = event.target.valueAsNumber;
      if (Number.isInteger(chosen) && chosen >= 0 && chosen < count) onChange(chosen);
      else event.target.value = value;
    } }));
}

function howToAsk(store) {
  const { pixel, ray } = store.selection;
  const which = pixel !== null ? ` --pixel ${pixel.join()}` : ray !== null ? ` --ray ${ray}` : "";
  const command = `raycheck view ${store.scene().name}${which}`;
  return [element("p", {}, "This page has no panel for this choice. One that has it is made by"),
    element("p", {}, element("code", { dir: "auto" }, brief(command)), " ",
      copyButton("copy-view", "Copy", command))].reduce((box, line) => (box.append(line), box),
    element("div", { id: "no-panel" }));
}

function methodFilter(store, told) {
  const wrong = new Set(told.verdicts.filter((one) => one.wrong).map((one) => one.name));
  const names = [...new Set(told.verdicts.map((one) => one.name))];
  const button = (name, ...label) => element("button", { type: "button", class: "chip",
    "aria-pressed": String(store.methodShown === name), dir: "auto",
    click: () => store.set({ methodShown: store.methodShown === name ? null : name }) }, ...label);
  return element("div", { id: "methods", role: "group", "aria-label": "Methods shown" },
    button(null, "all methods"),
    names.map((name) => (wrong.has(name)
      ? button(name, element("span", { class: "wrong" }, "\u2717 wrong: "), brief(name))
      : button(name, brief(name)))));
}

function stepView(step, store, opened) {
  const methods = step.methods.filter((method) =>
    store.methodShown === null || method.name === store.methodShown);
  const wrong = methods.filter((method) => method.wrong).length;
  const view = element("details", {
    id: `step-${step.symbol}`, class: wrong > 0 ? "step wrong-step" : "step",
    open: opened.get(step.symbol) ?? wrong > 0,
  },
  element("summary", { click: () => opened.set(step.symbol, !view.open) },
    element("h3", {}, symbol(step.symbol)),
    element("span", { class: "number" }, vector(step.rounded)),
    wrong > 0 ? element("span", { class: "wrong" }, `\u2717 goes wrong here: ${counted(wrong)}`) : null),
  element("p", { class: "formula" }, symbol(step.symbol), " = ", formula(step.formula)),
  closedForm(step),
  step.condition !== null ? element("p", { class: "quiet" }, `condition number ${step.condition}`,
    step.condition_alone !== null ? `, of this step alone ${step.condition_alone}` : "") : null,
  methods.length > 0 ? methodTable(step, methods) : null);
  return view;
}

function closedForm(step) {
  if (step.mathml === null) {
    return step.latex === null ? null
      : element("p", { class: "quiet" }, `A closed form of ${step.latex.length} characters: `
        + "too long to be set here; it is in the LaTeX below.");
  }
  const set = element("div", { class: "closed", tabindex: "0", role: "group",
    "aria-label": `closed form of ${step.symbol}` }, mathematics(step.mathml));
  return step.mathml.length <= LONGEST_SHOWN ? set : disclosure("closed form", set);
}

/// Methods whose values, errors and standing agree share a row.
function methodTable(step, methods) {
  const rows = new Map();
  for (const method of methods) {
    const key = JSON.stringify({ ...method, name: null });
    rows.set(key, [...(rows.get(key) ?? []), method]);
  }
  const row = (alike) => element("tr", { class: alike[0].wrong ? "wrong-row" : null },
    element("th", { scope: "row", dir: "auto" }, names(alike)),
    element("td", { class: "number" }, components(alike[0])),
    element("td", {}, errorText(alike[0]),
      alike[0].alone !== null ? element("span", { class: "quiet" }, ` (${alike[0].alone} alone)`) : null,
      alike[0].wrong ? element("strong", { class: "wrong" }, " \u2717 goes wrong here") : null));
  return element("table", { class: "values" },
    element("caption", { class: "unseen" }, `What methods have for ${step.symbol}`),
    element("thead", { class: "unseen" }, element("tr", {},
      ["methods", "value", "error"].map((text) => element("th", { scope: "col" }, text)))),
    element("tbody", {}, [...rows.values()].map(row)));
}

function names(alike) {
  const told = alike.slice(0, GROUP_SHOWN).map((method) => brief(method.name)).join(", ");
  if (alike.length <= GROUP_SHOWN) return told;
  const more = alike.slice(GROUP_SHOWN).map((method) => brief(method.name)).join(", ");
  return [told, disclosure(`and ${alike.length - GROUP_SHOWN} more`, more)];
}

function components(method) {
  return vector(method.value.map((_, k) => digits(method, k)));
}

function vector(parts) {
  if (parts.length === 1) return parts[0];
  return parts.map((part, k) => element("span", { class: "component" },
    k === 0 ? "(" : "", part, k === parts.length - 1 ? ")" : ", "));
}

/// A component's value; its digits after the first `right_digits` significant ones are marked.
function digits(method, k) {
  const value = method.value[k];
  let left = method.right_digits[k];
  let end = 0;
  let counting = false;
  while (end < value.length && value[end] !== "e") {
    const digit = value[end] >= "0" && value[end] <= "9";
    counting ||= digit && value[end] !== "0";
    if (digit && counting && left-- === 0) break;
    end++;
  }
  const right = method.right_digits[k] === 0 ? "" : value.slice(0, end);
  const rest = value.slice(right.length);
  if (rest === "" || rest[0] === "e") return element("span", { class: "number" }, value);
  return element("span", { class: "number" }, right, element("mark", {}, rest));
}

function errorText(method) {
  return method.error === null ? [] : [`off by ${method.error} ${method.unit}`];
}

function verdicts(told, methodShown) {
  const shown = told.verdicts.filter((one) => methodShown === null || one.name === methodShown);
  return element("dl", { id: "verdicts" }, shown.map((one) => element("div", {},
    element("dt", { dir: "auto", class: one.wrong ? "wrong" : null },
      one.wrong ? "\u2717 " : "", brief(one.name)),
    element("dd", { dir: "auto" }, brief(one.text)))));
}

function takeAway(told) {
  return element("div", { id: "take-away" },
    element("div", { class: "fields" },
      copyButton("copy-toml", "Copy as TOML scene", told.toml),
      copyButton("copy-command", "Copy as command", told.command),
      copyButton("copy-latex", "Copy as LaTeX", told.latex),
      copyButton("copy-sage", "Copy as Sage", told.sage)),
    disclosure(["What ", element("code", { dir: "auto" }, brief(told.command)), " prints"],
      element("pre", { id: "explain-text", tabindex: "0" }, told.text)));
}

function symbol(text) {
  return element("i", { class: "symbol" }, formula(text));
}

function counted(count) {
  return count === 1 ? "1 method" : `${count} methods`;
}
