"""Charts of errors: names beside methods, choices, hover and focus, the table, and accessibility (axe-core)."""
import unittest

import access_test
import pages
from pages import PageTest, candidate, page_of

METHODS = "quadratic,cross,cross2,robust"
HOSTILE = "<img src=x onerror=alert(1)>"
MISSES = "intersect = lambda ray, sphere, asked: None"


def chart_of(*arguments):
    return page_of(*arguments, option="--view")


def tradeoff():
    return chart_of("tradeoff", "--family", "distance,surface,up", "--method", METHODS + ",rays/direct,rays/lecture", "--cases", "600")


def stress():
    return chart_of("stress", "--family", "distance,surface,scale", "--method", METHODS, "--cases", "30")


class Charts(PageTest):
    def choose(self, name, value):
        self.run_script("""const field = document.querySelector(`#chart-${arguments[0]}, #${arguments[0]}`);
          field.value = arguments[1];
          field.dispatchEvent(new Event(field.localName === "select" ? "change" : "input", { bubbles: true }));""", name, value)

    def marks(self):
        """The position of every method's mark in the large chart, by the method's number."""
        return self.run_script("""return Object.fromEntries([...document.querySelectorAll("#chart-drawing g[data-method] circle")].map((mark) =>
          [mark.parentNode.dataset.method, [Number(mark.getAttribute("cx")), Number(mark.getAttribute("cy"))]]));""")

    def facet(self, title):
        """Its number."""
        return self.run_script("return [...document.querySelectorAll('#chart-facet option')].findIndex((one) => one.textContent === arguments[0])", title)

    def names(self):
        return self.run_script("return [...document.querySelectorAll('#chart-drawing g[data-method] text')].map((one) => one.textContent)")

    def test_every_method_has_its_name_beside_it(self):
        self.open(tradeoff())
        self.assertEqual(sorted(self.names()), sorted(METHODS.split(",")))
        self.open(stress())
        self.assertEqual(sorted(self.names()), sorted(METHODS.split(",")))

    def test_the_dial_moves_the_points(self):
        self.open(tradeoff())
        self.choose("facet", self.facet("Intersections on distance"))
        self.choose("severity", 1)
        near = self.marks()
        self.choose("severity", 9)
        far = self.marks()
        self.assertEqual([near[k][0] for k in near], [far[k][0] for k in far])  # run times stay
        self.assertNotEqual([near[k][1] for k in near], [far[k][1] for k in far])
        self.assertIn("at severity 8", self.text("#chart-heading"))
        self.choose("severity", 0)
        self.assertNotIn("at severity", self.text("#chart-heading"))

    def test_choices_are_shown_and_persist(self):
        self.open(tradeoff())
        self.run_script("document.querySelector('#chart-facet').focus()")
        self.choose("facet", self.facet("Rays on distance, surface, up"))
        self.assertEqual(self.run_script("return document.activeElement.id"), "chart-facet")
        self.choose("quantity", "1")
        self.choose("quantile", "0")
        self.assertEqual(self.text("#chart-heading"), "Rays on distance, surface, up: median pixel point error against run time")
        self.assertEqual(sorted(self.names()), ["direct", "lecture"])

    def test_pointing_and_focus_show_figures(self):
        self.open(stress())
        for event in ("pointerover", "focusin"):
            self.run_script("""document.querySelector("#chart-methods .chip").dispatchEvent(new Event(arguments[0], { bubbles: true }))""", event)
            self.assertTrue(self.text("#chart-readout").startswith("quadratic: 99.9% parameter error in ulp by severity: 0: "))
            self.assertEqual(self.run_script("return document.querySelectorAll('#chart-drawing .faded text').length"), 3)

    def test_a_method_without_a_run_time_is_listed(self):
        path = candidate("kept.py", MISSES)
        self.open(chart_of("tradeoff", "--family", "distance", "--method", "cross", "--cases", "20", "--candidate", f"command:python3 {path}"))
        self.assertEqual(self.names(), ["cross"])
        self.assertRegex(self.text("#chart-absent"), r"^Not drawn: command:python3 .*kept\.py \(not timed: it runs in a sandbox")

    def test_small_charts_show_every_family_and_link_to_it(self):
        self.open(stress())
        self.assertEqual(self.run_script("return [...document.querySelectorAll('.multiple span')].map((one) => one.textContent)"), ["distance", "surface", "scale"])
        self.run_script("document.querySelectorAll('.multiple')[1].click()")
        self.assertTrue(self.text("#chart-heading").startswith("Intersections on surface: "))
        self.assertEqual(self.run_script("return document.querySelector('.multiple[aria-current=true] span').textContent"), "surface")

    def test_the_table_has_every_figure(self):
        self.open(stress())
        self.run_script("document.querySelector('#chart details').open = true")
        rows = self.run_script("""return new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => done(
          [...document.querySelectorAll("#chart tbody tr")].map((row) => [...row.children].map((cell) => cell.textContent))))));""")
        self.assertEqual(len(rows), 4 * 16)
        self.assertEqual(rows[0][:3], ["quadratic", "-", "0"])
        self.assertTrue(all(len(row) == 12 for row in rows))

    def test_a_hostile_name_is_text(self):
        path = candidate("named.py", MISSES)
        self.open(chart_of("stress", "--family", "distance", "--severity", "0..1", "--cases", "5", "--method", "cross",
                           "--candidate", f'command:env "A={HOSTILE}" python3 {path}'))
        self.assertIn(HOSTILE, self.text("#chart-methods"))
        self.assertEqual(self.run_script("return document.querySelectorAll('main img').length"), 0)


@unittest.skipUnless(access_test.AXE.exists(), "there is no axe-core here: ./run packages ci")
class ChartsForEveryone(access_test.Accessibility):
    test_broken_pages_are_found = test_pages_of_a_grade_in_every_look = None  # as for the other pages

    def test_every_kind_of_page_in_every_look(self):
        for page in (tradeoff(), stress()):
            self.open(page)
            self.look_at_all_of(page.name)


if __name__ == "__main__":
    pages.main()
