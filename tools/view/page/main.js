// Reads the data that raycheck put into the page, and shows them.
import { briefSentence, element } from "./dom.js";
import { createStore } from "./store.js";
import { mountFigure } from "./figure.js";
import { followAddress, mountFindings, mountPanel, mountStory } from "./panel.js";
import { mountPicture } from "./picture.js";
import { mountMicroscope } from "./microscope.js";
import { mountChart } from "./chart.js";

const MADE = "Every number but run times is computed exactly and then rounded; this page only draws.";
const byId = (id) => document.getElementById(id);

/// The inflated text (zlib, base64) of the element with this id.
async function inflated(id) {
  const bytes = Uint8Array.from(atob(byId(id).textContent.trim()), (letter) => letter.charCodeAt(0));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Response(stream).text();
}

/// Runs three.js, which the page's policy allows by its hash. If it fails, the figure is drawn
/// without it.
async function runThree() {
  const script = element("script", {});
  script.textContent = await inflated("three");
  document.head.append(script);
}

async function start() {
  const read = JSON.parse(await inflated("document"));
  byId("footer").append(...read.left_out.map((sentence) => element("p", { dir: "auto" }, briefSentence(sentence))),
    element("p", {}, `Made by raycheck ${read.version}. ${MADE}`));
  if (read.scenes.length === 0) { // the page is only a chart
    for (const id of ["story", "seen", "told", "conventions"]) byId(id).remove();
    Object.assign(byId("skip"), { href: "#chart", textContent: "Skip to the chart" });
    mountChart(byId("chart"), read, null);
    return;
  }
  const store = createStore(read);
  window.raycheckPage.store = store;
  followAddress(store);
  store.subscribe(() => byId("conventions").replaceChildren(briefSentence(store.scene().conventions_text)));
  mountStory(byId("story"), store);
  if (read.dial !== null) mountChart(byId("dial"), read, store);
  mountPicture(byId("picture"), store);
  mountMicroscope(byId("microscope"), store);
  mountFindings(byId("findings"), store);
  mountPanel(byId("panel"), store);
  await runThree();
  mountFigure(byId("figure-view"), store);
}

window.raycheckPage = { store: null, ready: null };
window.raycheckPage.ready = start().catch((problem) => {
  (byId("headline") ?? byId("footer")).append(element("p", {}, `This could not be shown: ${problem.message}`));
  throw problem;
});
