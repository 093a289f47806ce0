// Elements of HTML, SVG and MathML; all text goes in as text.

const SVG = "http://www.w3.org/2000/svg";
const MATHML = "http://www.w3.org/1998/Math/MathML";

/// An element; attributes whose value is a function listen to the event of that name, null and false are left out, true is an
/// empty attribute. Children are nodes, texts, lists of them, or null.
export function element(tag, attributes, ...children) {
  return filled(document.createElement(tag), attributes, children);
}

export function svg(tag, attributes, ...children) {
  return filled(document.createElementNS(SVG, tag), attributes, children);
}

/// A formula that the document brings as MathML: its elements and texts, without attributes except those of layout.
export function formula(mathml) {
  const parsed = new DOMParser().parseFromString(mathml, "text/html").body.firstElementChild;
  return copied(parsed);
}

/// A table with a caption; the first cell of every row is its heading.
export function table(caption, columns, rows) {
  const cells = (row) => row.map((cell, k) => (k === 0 ? element("th", { scope: "row" }, cell) : element("td", {}, cell)));
  return element("div", { class: "wide", tabindex: "0", role: "region", "aria-label": caption },
    element("table", {},
      element("caption", {}, caption),
      element("thead", {}, element("tr", {}, columns.map((column) => element("th", { scope: "col" }, column)))),
      element("tbody", {}, rows.map((row) => element("tr", {}, cells(row))))));
}

/// The mark of method number k: eight shapes, seven colours, so that 56 differ.
export function glyph(k, x, y, size = 5) {
  const shapes = [
    "M1 0A1 1 0 1 1 -1 0A1 1 0 1 1 1 0Z",
    "M-.9 -.9H.9V.9H-.9Z",
    "M0 -1.2L1.1 .8H-1.1Z",
    "M0 -1.3L1.1 0L0 1.3L-1.1 0Z",
    "M-.4 -1.2H.4V-.4H1.2V.4H.4V1.2H-.4V.4H-1.2V-.4H-.4Z",
    "M0 1.2L1.1 -.8H-1.1Z",
    "M0 -1.4L.4 -.4L1.4 0L.4 .4L0 1.4L-.4 .4L-1.4 0L-.4 -.4Z",
    "M-.6 -1.1H.6L1.2 0L.6 1.1H-.6L-1.2 0Z",
  ];
  return svg("path", {
    d: shapes[k % shapes.length], class: `glyph series-${k % 7}`, transform: `translate(${x} ${y}) scale(${size})`,
  });
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

function copied(node) {
  if (node === null || node.nodeType === Node.TEXT_NODE) return document.createTextNode(node?.data ?? "");
  if (node.namespaceURI !== MATHML) return document.createTextNode(node.textContent);
  const copy = document.createElementNS(MATHML, node.localName);
  for (const name of ["display", "stretchy", "form", "lspace", "rspace"]) {
    if (node.hasAttribute(name)) copy.setAttribute(name, node.getAttribute(name));
  }
  copy.append(...Array.from(node.childNodes, copied));
  return copy;
}
