// The dial of a stress family: its severities, and each method's error along them.
import { atEachWidth, brief, briefSentence, disclosure, element, rangeField, table } from "./dom.js";
import { curvePlot } from "./plot.js";

const DIAL_TALL = 300; // pixels

export function mountDial(root, store) {
  const { dial } = store.document;
  if (dial === null) return;
  root.hidden = false;
  const position = () => Math.max(0, dial.scenes.indexOf(store.scenesIndex));
  const { input, field } = rangeField("severity", "Severity", dial.severities.length - 1,
    (k) => String(dial.severities[k]), (k) => store.set({ scenesIndex: dial.scenes[k] }));
  const drawing = element("div", { id: "dial-view" });
  const rows = dial.curves.map((curve) => [brief(curve.name), ...curve.points.map((point) =>
    (point.error ?? "-") + (point.wrong === 0 ? "" : `, ${point.wrong} wrong`))]);
  root.append(element("h2", { id: "dial-heading" }, `Dial: ${dial.family}`), element("p", {}, briefSentence(dial.sentence)),
    field, drawing, disclosure("The curves as a table", table(`Largest error, in ${dial.unit}`,
      ["method", ...dial.severities.map(String)], rows)));
  const draw = () => {
    const width = Math.floor(drawing.clientWidth);
    if (width > 0) drawing.replaceChildren(errorCurves(dial, position(), width, store));
  };
  const show = () => {
    input.show(position());
    draw();
  };
  atEachWidth(drawing, draw);
  store.subscribe(show);
  show();
}

function errorCurves(dial, position, width, store) {
  const curves = dial.curves.map(({ name, points }) => ({ name, number: store.methodNumber(name),
    errors: points.map(({ error }) => error), standings: points.map(({ wrong }) => (wrong === 0 ? "right" : "defect")) }));
  return curvePlot({ curves, condition: null, severities: dial.severities, current: position,
    errors: [1, ...curves.flatMap(({ errors }) => errors).filter((error) => error !== null)], width, tall: DIAL_TALL,
    unit: dial.unit, severityText: "severity", label: `Largest error of each method against severity; severity ${dial.severities[position]} is shown`,
    classOf: (same) => (store.methodShown === null || same.some(({ name }) => name === store.methodShown) ? null : "faded"),
    onSeverity: (k) => store.set({ scenesIndex: dial.scenes[k] }) });
}
