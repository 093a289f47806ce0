// Elements of HTML, SVG and MathML. Texts are always inserted as text, never as markup.

const SVG = "http://www.w3.org/2000/svg";
const LONGEST_NAME = 60; // characters of a name that is shown whole
const LONGEST_SENTENCE = 400;

/// Makes an element. An attribute whose value is a function listens to the event of that name; null
/// and false are left out, true is an empty attribute. Children are nodes, texts, lists of them,
/// null.
export function element(tag, attributes, ...children) {
  return filled(document.createElement(tag), attributes, children);
}

export function svg(tag, attributes, ...children) {
  return filled(document.createElementNS(SVG, tag), attributes, children);
}

function filled(node, attributes, children) {
  for (const [name, value] of Object.entries(attributes ?? {})) {
    if (typeof value === "function") node.addEventListener(name, value);
    else if (value === true) node.setAttribute(name, "");
    else if (value !== null && value !== undefined && value !== false) node.setAttribute(name, value);
  }
  node.append(...children.flat(Infinity).filter((child) => child !== null && child !== undefined));
  return node;
}

/// Replaces the children of `target`. A focused child keeps the focus, by its id.
export function refill(target, ...children) {
  const focused = target.contains(document.activeElement) ? document.activeElement.id : "";
  target.replaceChildren(...children.flat(Infinity).filter((child) => child !== null));
  if (focused !== "") document.getElementById(focused)?.focus();
}

/// MathML that raycheck made from its own numbers.
export function mathematics(mathml) {
  return document.adoptNode(new DOMParser().parseFromString(mathml, "text/html").body.firstElementChild);
}

/// Formulas within a line: "r^2 - v" with a raised 2, a minus sign, Greek letters.
export function formula(text) {
  const signs = { alpha: "\u03b1", beta: "\u03b2", "-": "\u2212", " . ": " \u00b7 ", " x ": " \u00d7 " };
  const told = text.replace(/\balpha\b|\bbeta\b|-| \. | x /g, (word) => signs[word]);
  return told.split(/\^(\d)/).map((part, k) => (k % 2 === 1 ? element("sup", {}, part) : part));
}

/// Cuts a name that is too long, and adds its length.
export function brief(text, longest = LONGEST_NAME) {
  return text.length <= longest ? text : `${text.slice(0, longest)}\u2026 (${text.length} characters)`;
}

export const briefSentence = (text) => brief(text, LONGEST_SENTENCE);

/// A table that scrolls sideways if it is too wide; the first cell of a row is its heading.
export function table(caption, columns, rows, look = "wide") {
  const cell = (content, k) => element(k === 0 ? "th" : "td", { scope: k === 0 ? "row" : null, dir: "auto" }, content);
  return element("div", { class: look, tabindex: "0", role: "region", "aria-label": caption }, element("table", {},
    element("caption", {}, caption),
    element("thead", {}, element("tr", {}, columns.map((column) => element("th", { scope: "col" }, column)))),
    element("tbody", {}, rows.map((row) => element("tr", {}, row.map(cell))))));
}

export function disclosure(summary, ...children) {
  return element("details", {}, element("summary", {}, summary), ...children);
}

export function labelled(id, label, ...fields) {
  return element("label", { for: id, class: "field" }, element("span", {}, label), fields);
}

/// A labelled choice among [value, text] pairs.
export function choice(id, label, options, chosen, onChoice) {
  return labelled(id, label, element("select", { id, change: (event) => onChoice(event.target.value) },
    options.map(([value, text]) =>
      element("option", { value, selected: String(value) === String(chosen) }, brief(String(text))))));
}

/// A labelled slider from 0 to `last` that shows its value; its show(k) sets it.
export function rangeField(id, label, last, tell, onInput, first = 0) {
  const output = element("output", { for: id });
  const input = element("input", { id, type: "range", min: 0, max: last, step: 1 });
  const show = (k) => {
    input.value = k;
    input.setAttribute("aria-valuetext", tell(k));
    output.replaceChildren(tell(k));
  };
  input.addEventListener("input", () => {
    show(input.valueAsNumber);
    onInput(input.valueAsNumber);
  });
  show(first);
  return Object.assign(labelled(id, label, input, output), { show });
}

/// A button that copies; if the browser denies access to the clipboard, a text to copy from.
export function copyButton(id, label, text) {
  const said = element("span", { role: "status", class: "said" });
  const copy = async () => {
    try {
      await navigator.clipboard.writeText(text);
      said.replaceChildren("copied");
    } catch {
      const area = element("textarea", { readonly: true, rows: "6", "aria-label": label }, text);
      said.replaceChildren("Press Ctrl+C:", area);
      area.select();
    }
  };
  return element("span", { class: "copy" }, element("button", { id, type: "button", click: copy }, label), said);
}

/// Calls draw whenever the width of `target` has changed.
export function atEachWidth(target, draw) {
  let drawn = 0;
  new ResizeObserver(() => {
    if (target.clientWidth !== drawn) draw();
    drawn = target.clientWidth;
  }).observe(target);
}
