// Elements of HTML, SVG and MathML; all text goes in as text.

const SVG = "http://www.w3.org/2000/svg";
export const LETTER = 6.7; // pixels: a letter of a drawing's label is narrower
const LONGEST_NAME = 60; // characters of a name that is shown whole
const LONGEST_SENTENCE = 400;

/// An element. An attribute whose value is a function listens to the event of that name; null and
/// false are left out, true is an empty attribute. Children are nodes, texts, lists of them, null.
export function element(tag, attributes, ...children) {
  return filled(document.createElement(tag), attributes, children);
}

export function svg(tag, attributes, ...children) {
  return filled(document.createElementNS(SVG, tag), attributes, children);
}

/// MathML that raycheck made of its own numbers.
export function mathematics(mathml) {
  return document.adoptNode(new DOMParser().parseFromString(mathml, "text/html").body.firstElementChild);
}

/// "r^2 - v" with a raised 2, a minus, Greek letters: how formulas are told in a line.
export function formula(text) {
  const signs = { alpha: "\u03b1", beta: "\u03b2", "-": "\u2212", " . ": " \u00b7 ", " x ": " \u00d7 " };
  const told = text.replace(/\balpha\b|\bbeta\b|-| \. | x /g, (word) => signs[word]);
  const parts = told.split(/\^(\d)/);
  return parts.map((part, k) => (k % 2 === 1 ? element("sup", {}, part) : part));
}

/// A name that is too long is cut short, with how long it is.
export function brief(text, longest = LONGEST_NAME) {
  return text.length <= longest ? text : `${text.slice(0, longest)}\u2026 (${text.length} characters)`;
}

export function briefSentence(text) {
  return brief(text, LONGEST_SENTENCE);
}

/// Lists of the items whose keys are the same, in the order of their firsts.
export function alike(items, keyOf) {
  const groups = new Map();
  for (const item of items) {
    const key = keyOf(item);
    groups.set(key, [...(groups.get(key) ?? []), item]);
  }
  return [...groups.values()];
}

/// A table that scrolls sideways where it is too wide; the first cell of a row is its heading.
export function table(caption, columns, rows) {
  const cells = (row) => row.map((cell, k) => (k === 0 ? element("th", { scope: "row" }, cell) : element("td", {}, cell)));
  return element("div", { class: "wide", tabindex: "0", role: "region", "aria-label": caption }, element("table", {},
    element("caption", {}, caption),
    element("thead", {}, element("tr", {}, columns.map((column) => element("th", { scope: "col" }, column)))),
    element("tbody", {}, rows.map((row) => element("tr", {}, cells(row))))));
}

export function disclosure(summary, ...children) {
  return element("details", {}, element("summary", {}, summary), ...children);
}

/// A labelled choice among [value, text] pairs.
export function choice(id, label, options, chosen, onChoice) {
  return element("label", { for: id, class: "field" }, element("span", {}, label),
    element("select", { id, change: (event) => onChoice(event.target.value) }, options.map(([value, text]) =>
      element("option", { value, selected: String(value) === String(chosen) }, brief(String(text))))));
}

/// A labelled range of 0 to `last` that tells its value; input.show(k) sets it.
export function rangeField(id, label, last, tell, onInput) {
  const output = element("output", { for: id });
  const input = element("input", { id, type: "range", min: 0, max: last, step: 1, input: () => {
    input.show(input.valueAsNumber);
    onInput(input.valueAsNumber);
  } });
  input.show = (k) => {
    input.value = k;
    input.setAttribute("aria-valuetext", tell(k));
    output.replaceChildren(tell(k));
  };
  return { input, field: element("label", { for: id, class: "field" }, element("span", {}, label), input, output) };
}

/// A button that copies; where the browser keeps the clipboard to itself, a text to copy from.
export function copyButton(id, label, text) {
  const said = element("span", { role: "status", class: "said" });
  const button = element("button", { id, type: "button", click: async () => {
    try {
      await navigator.clipboard.writeText(text);
      said.replaceChildren("copied");
    } catch {
      const area = element("textarea", { readonly: true, rows: "6", "aria-label": label });
      area.value = text;
      said.replaceChildren("Press Ctrl+C:", area);
      area.select();
    }
  } }, label);
  return element("span", { class: "copy" }, button, said);
}

/// Calls draw whenever the width of `target` has changed.
export function atEachWidth(target, draw) {
  let drawn = 0;
  new ResizeObserver(() => {
    if (target.clientWidth !== drawn) draw();
    drawn = target.clientWidth;
  }).observe(target);
}

/// The mark of method number k: eight shapes and seven colours, so that 56 differ.
export function glyph(k, x, y, size = 5) {
  const shapes = ["M1 0A1 1 0 1 1 -1 0A1 1 0 1 1 1 0Z", "M-.9 -.9H.9V.9H-.9Z", "M0 -1.2L1.1 .8H-1.1Z", "M0 -1.3L1.1 0L0 1.3L-1.1 0Z",
    "M-.4 -1.2H.4V-.4H1.2V.4H.4V1.2H-.4V.4H-1.2V-.4H-.4Z", "M0 1.2L1.1 -.8H-1.1Z",
    "M0 -1.4L.4 -.4L1.4 0L.4 .4L0 1.4L-.4 .4L-1.4 0L-.4 -.4Z", "M-.6 -1.1H.6L1.2 0L.6 1.1H-.6L-1.2 0Z"];
  return svg("path", { d: shapes[k % 8], class: `glyph series-${k % 7}`, transform: `translate(${x} ${y}) scale(${size})` });
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
