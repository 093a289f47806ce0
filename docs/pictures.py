"""Makes the pages of `raycheck view` in the documentation, and their pictures.

A command in a document makes a page: `$ ./run view SCENE --out NAME.html`, `check ... --view NAME.html`, or a line
`{{ARGUMENTS}}` of a template (docs/generate.py). A comment above each picture specifies the picture:

    <!-- picture {"page": "NAME.html", "part": "#microscope"} -->
    ![description](lecture/NAME.webp)

    page    the page
    part    an element of the page, by a CSS selector; default: the figure
    width   of the window, in pixels; default: 700
    scale   of the picture; default: 1
    set     fields of the page and their values, by CSS selectors
    store   values for the page's store (tools/view/page/store.js)

Pictures are WebP, which Chromium can write: half as large as PNG.
"""
import base64
import json
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "tests/browser"))
import webdriver  # noqa: E402

PAGE = re.compile(r"^\$ \./run (.* --(?:out|view) (\S+\.html)\b.*)$", re.MULTILINE)
PICTURE = re.compile(r"<!-- picture (\{.*?\}) -->\s*!\[[^\]]*\]\(([^)]+)\)")
HEIGHT = 1000  # of the window
QUALITY = 80

# Resolves once the page is ready, or has drawn the values set.
READY = """return window.raycheckPage.ready.then(() => new Promise((done) =>
  requestAnimationFrame(() => requestAnimationFrame(done))));"""
SET = """const [store, fields] = arguments;
raycheckPage.store?.set(store); // a chart has none
for (const [selector, value] of Object.entries(fields)) {
  const field = document.querySelector(selector);
  field.value = value;
  if (field.value !== String(value)) throw new Error(`${selector} does not accept ${value}`);
  for (const kind of ["input", "change"]) field.dispatchEvent(new Event(kind, { bubbles: true }));
}"""
PLACE = """const { x, y, width, height } = document.querySelector(arguments[0]).getBoundingClientRect();
return { x: x + scrollX, y: y + scrollY, width, height };"""


def made_pages(text, folder, program):
    """Runs the commands of a document that make pages."""
    for arguments, name in PAGE.findall(text):
        result = subprocess.run(f"{program} {arguments.replace(name, str(folder / name))}", shell=True, cwd=ROOT, text=True,
                                stderr=subprocess.PIPE, stdout=subprocess.DEVNULL)
        if result.returncode not in (0, 1):
            sys.exit(f"./run {arguments}: {result.stderr}")


def picture(browser, page, wanted):
    browser.command("Emulation.setDeviceMetricsOverride", width=wanted.get("width", 700), height=HEIGHT,
                    deviceScaleFactor=1, mobile=False)
    browser.open(page)
    browser.run(READY)
    browser.run(SET, wanted.get("store", {}), wanted.get("set", {}))
    browser.run(READY)
    place = browser.run(PLACE, wanted.get("part", ".figure-stage"))
    place["scale"] = wanted.get("scale", 1)
    taken = browser.command("Page.captureScreenshot", format="webp", quality=QUALITY, clip=place, captureBeyondViewport=True)
    return base64.b64decode(taken["data"])


def make(documents, folder, program):
    """Makes the pages of documents in a folder, which keeps them, and the documents' pictures of them."""
    folder = pathlib.Path(folder).resolve()
    folder.mkdir(parents=True, exist_ok=True)
    for document in documents:
        made_pages(document.read_text(), folder, program)
    take(documents, folder)


def take(documents, folder):
    """Takes the documents' pictures of the pages in a folder."""
    if reason := webdriver.missing():
        sys.exit(reason)
    browser = webdriver.Browser("--hide-scrollbars")
    try:
        for document in documents:
            for wanted, name in PICTURE.findall(document.read_text()):
                wanted = json.loads(wanted)
                if not (folder / wanted["page"]).exists():
                    sys.exit(f"{document.name}: {name} is a picture of {wanted['page']}, which no command makes")
                path = document.parent / name
                path.parent.mkdir(exist_ok=True)
                path.write_bytes(picture(browser, folder / wanted["page"], wanted))
                print(f"{path.relative_to(ROOT)}  {path.stat().st_size} bytes")
    finally:
        browser.close()
