"""Texts that would do harm as HTML: names of files, messages of candidates, contents of scenes."""
import shutil
import subprocess

import pages
from pages import PageTest, ROOT, Shared, candidate, temporary

ALERT = "<img src=x onerror=alert(1)>"
NAME = f"</script>{ALERT}.toml"  # a folder "<", and in it a file
BIDI = "\u202e\u2066\u200f"
SPOKEN = f"""</script></title></style>-->{ALERT}"'`&lt;\\u003c{BIDI}"""
LONG = "<b>" * 34_000  # over 10^5 characters
# Elements that pages do not have by themselves, and the scripts of the page.
FOREIGN = """const own = new Set(document.querySelectorAll("svg, svg *, math, math *"));
  const made = [...document.querySelectorAll("*")].filter((one) => !own.has(one));
  return [made.filter((one) => /^(img|b|iframe|object|embed|base|form|link|meta)$/.test(one.localName)
      && !one.closest("head") && !one.closest("#picture-view")).length,
    document.scripts.length, document.querySelectorAll("[onerror], [onclick], [onload], [style*=expression]").length,
    document.querySelectorAll("head > *").length];"""
SAYS = "def intersect(ray, sphere, asked):\n    raise ValueError({!r})\n"


class HostileText(PageTest):
    def page(self, *arguments):
        """Makes a page in the folder of this run, so that its paths are short."""
        out = temporary("hostile.html")
        made = subprocess.run([Shared.program, "view", *arguments, "--out", out], cwd=Shared.folder, text=True, capture_output=True)
        self.assertEqual(made.returncode, 0, made.stderr)
        return out

    def scene_named(self, name):
        path = Shared.folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(ROOT / "scene/examples/first-camera.toml", path)
        return name

    def check_plain(self, plain):
        """Texts do not become elements: the page has only the elements of a page with plain text."""
        self.assertEqual(self.run_script(FOREIGN), plain)
        self.assertFalse(self.run_script("return 'alerted' in window"))

    def everything_seen(self):
        """Opens all details, and draws every layer and ray of the figure."""
        self.run_script("""for (const one of document.querySelectorAll("details")) one.open = true;
          raycheckPage.store.set({ layers: { rays: "all", names: true } });
          for (const button of document.querySelectorAll("#panel .copy button")) button.click();""")

    def setUp(self):
        self.browser.command("Page.addScriptToEvaluateOnNewDocument", source="window.alert = () => { window.alerted = true; };")
        self.open(self.page(self.scene_named("plain.toml")))
        self.everything_seen()
        self.plain = self.run_script(FOREIGN)
        self.assertEqual(self.plain[0], 0)

    def test_the_name_of_a_file_is_text(self):
        for name in (NAME, f"{BIDI}\u0627'\"&amp;.toml", "{script} {document} {0} $& .toml", "</title><b>.toml", "<!--<script>.toml"):
            with self.subTest(name):
                self.open(self.page(self.scene_named(name)))
                self.everything_seen()
                self.check_plain(self.plain)
                shown = self.text("#title")
                self.assertEqual(self.run_script("return document.title"), " ".join(shown.split()))
                self.assertEqual([mark for mark in BIDI if mark in shown], [])
                if not any(mark in name for mark in BIDI):
                    self.assertEqual(shown, name.rsplit("/", 1)[-1])

    def test_a_candidates_message_is_text(self):
        path = candidate(f"<b>&amp;{BIDI}.py", SAYS.format(SPOKEN), SPOKEN.replace(" ", ""))
        self.check_candidate(f'command:python3 {path.name} "{NAME}"', "<b>", ALERT)

    def test_a_candidates_long_message_is_text(self):
        path = candidate("long.py", SAYS.format(LONG), "long")
        self.check_candidate(f'command:python3 {path.name} "{LONG}"', "<b><b>", LONG)

    def check_candidate(self, command, in_short, at_length):
        self.open(self.page(self.scene_named("plain.toml"), "--candidate", command))
        self.everything_seen()
        self.check_plain(self.plain)
        self.assertIn(in_short, self.text("#verdicts"))
        self.assertIn(at_length, self.text("#explain-text"))
        self.assertEqual(self.run_script("return document.documentElement.scrollWidth - document.documentElement.clientWidth"), 0)

    def test_nothing_but_the_page_itself_runs(self):
        """The policy works: elements added later neither run nor load."""
        page = self.page(self.scene_named("plain.toml"))
        text = page.read_text()
        attack = f"""<script>window.alerted = 1;</script><img src=x onerror="window.alerted = 2"><img src="file:///etc/hostname">
          <iframe srcdoc="<script>parent.alerted = 3</script>"></iframe><link rel="stylesheet" href="x.css">
          <style>header {{ display: none; }}</style><p style="color: red" id="styled">x</p><base href="http://localhost/">"""
        attacked = temporary("attacked.html", text.replace("<main>", attack + "<main>", 1))
        self.assertGreater(attacked.stat().st_size, page.stat().st_size)
        self.check_page()
        self.browser.open(attacked)
        self.browser.run(pages.READY)
        self.run_script("""const script = document.createElement("script");
          script.textContent = "window.alerted = 4";
          document.body.append(script);
          setTimeout("window.alerted = 5");
          return new Promise((done) => fetch("file:///etc/hostname").then(done, () => done()));""")
        self.assertFalse(self.run_script("return 'alerted' in window"))
        self.assertEqual(self.run_script("return getComputedStyle(document.querySelector('header')).display"), "flex")
        self.assertNotEqual(self.run_script("return getComputedStyle(document.querySelector('#styled')).color"), "rgb(255, 0, 0)")
        self.assertEqual(self.run_script("return document.baseURI.slice(0, 5)"), "file:")
        self.assertGreater(len(self.browser.problems()), 5)
        self.assertEqual(self.browser.answered(), [f"file://{attacked}"])


if __name__ == "__main__":
    pages.main()
