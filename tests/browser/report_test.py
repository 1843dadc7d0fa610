"""report_test.py SETTLE FOLDER: a campaign's page as people meet it, in a headless Chromium.

Ends with 77, which ctest shows as skipped, where there is no Chromium."""
import json
import pathlib
import shutil
import subprocess
import sys
import unittest

import chromium

CASE = """
format = 1
title = "A small column"
source = "docs/theory.md"
gravity = 9.81
geometry = { shape = "column", height = 1.0, width = 0.125, dimension = 2 }
material.fill = { law = "rate", youngs_modulus = 400e3, poissons_ratio = 0.25, density = 1720.0 }
construction = { layers = 2, convention = "float", material = "fill" }
mpm = { element_size = 0.125 }
probes.axis = { points_per_layer = 5 }
[[check]]
quantity = "settlement"
between = ["mpm", "exact"]
limit = 0.02
[[check]]
quantity = "vertical-stress"
between = ["mpm", "exact"]
limit = 0.2
"""
CAMPAIGN = """
format = 1
title = "Four columns"
[[run]]
name = "column of {construction.layers}"
case = "column.toml"
solvers = ["mpm"]
matrix = { "construction.layers" = [1, 2, 4] }
[[run]]
name = "too strict"
case = "column.toml"
solvers = ["mpm"]
set = { "check.0.limit" = 1e-9 }
"""

SHOWN = """[...document.querySelectorAll("%s tbody tr")].filter(row => row.getClientRects().length > 0)
           .map(row => row.cells[0].firstChild.textContent)"""


def written(settle, folder):
    """The page of a campaign run by the real solver."""
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "column.toml").write_text(CASE)
    (folder / "campaign.toml").write_text(CAMPAIGN)
    shutil.rmtree(folder / "out", ignore_errors=True)
    ended = subprocess.run([settle, "campaign", folder / "campaign.toml", "--out", folder / "out"],
                           capture_output=True, text=True)
    assert ended.returncode == 1, ended.stdout + ended.stderr  # one case is too strict
    return folder / "out" / "report.html"


class Page(unittest.TestCase):
    browser = address = None

    @classmethod
    def setUpClass(cls):
        cls.browser.size(1280)
        cls.browser.media()
        cls.browser.open(cls.address)

    def value(self, expression):
        return self.browser.evaluate(expression)

    def shown(self, table):
        return self.value(SHOWN % table)

    def choose(self, selector, value):
        self.value(f"""(() => {{ const field = document.querySelector('{selector}');
          field[field.type === "checkbox" ? "checked" : "value"] = {json.dumps(value)};
          field.dispatchEvent(new Event("input", {{bubbles: true}})); }})()""")

    def everything(self):
        self.value("document.querySelector('#filters button[type=reset]').click()")
        self.value("new Promise(done => setTimeout(done, 20))")

    def view(self, name):
        self.value(f"document.querySelector('[data-view={name}]').click()")

    def test_figures_have_a_size_and_a_name(self):
        figures = self.value("""(() => { document.querySelectorAll("details").forEach(each => { each.open = true; });
          return [...document.querySelectorAll("figure svg[role=img], figure img")].map(each => { const box = each.getBoundingClientRect();
            return [box.width, box.height, each.getAttribute("aria-label") || each.getAttribute("alt") ||
                    (document.getElementById(each.getAttribute("aria-labelledby")) || {}).textContent || "",
                    each.tagName === "IMG" ? each.naturalWidth : each.querySelectorAll("path, use").length]; }); })()""")
        self.assertGreaterEqual(len(figures), 8)  # settlement and stress of four cases
        for width, height, name, parts in figures:
            self.assertGreater(width, 100)
            self.assertGreater(height, 100)
            self.assertGreater(parts, 0)
            self.assertTrue(name)

    def test_a_text_finds_cases_and_the_count_is_said(self):
        self.view("view-index")
        self.choose("#filter-text", "of 2")
        self.assertEqual(self.shown("#index-table"), ["column of 2"])
        self.assertRegex(self.value("document.querySelector('#shown').textContent"), r"^1 of 4 cases, \d+ of \d+ verdicts$")
        self.assertEqual(self.value("document.querySelector('#shown').getAttribute('aria-live')"), "polite")
        self.assertEqual(self.value("document.querySelectorAll('#runs > details:not(.out)').length"), 1)
        self.everything()
        self.assertEqual(len(self.shown("#index-table")), 4)

    def test_failures_stand_first_and_are_found_by_their_status(self):
        self.view("view-index")
        self.assertEqual(self.shown("#index-table")[0], "too strict")
        self.choose("#filters input[value=p]", False)
        self.assertEqual(self.shown("#index-table"), ["too strict"])
        self.view("view-problems")
        self.assertEqual(self.shown("#problem-table"), ["too strict"])
        self.everything()

    def test_leg_and_quantity_narrow_the_matrix(self):
        self.view("view-matrix")
        leg = self.value("[...document.querySelector('#filter-leg').options].find(each => each.text === 'mpm − exact').value")
        quantity = self.value("[...document.querySelector('#filter-quantity').options].find(each => each.text === 'settlement').value")
        self.choose("#filter-leg", leg)
        self.choose("#filter-quantity", quantity)
        row = self.value("[...document.querySelector('#matrix-table tbody tr').cells].map(cell => cell.innerText.trim())")
        self.assertEqual(row, ["too strict", "✗ failed", "✗ 0 of 1", "–"])
        self.everything()
        row = self.value("[...document.querySelector('#matrix-table tbody tr').cells].map(cell => cell.innerText.trim())")
        self.assertEqual(row[2], "✗ 1 of 2")
        self.assertTrue(row[3].startswith("✓"))

    def test_the_keyboard_sorts_a_table(self):
        self.view("view-index")
        self.value("document.querySelector('#index-table thead th button').focus()")
        self.browser.press("Enter", 13)
        self.assertEqual(self.shown("#index-table"), ["column of 1", "column of 2", "column of 4", "too strict"])
        head = "document.querySelector('#index-table thead th').getAttribute('aria-sort')"
        self.assertEqual(self.value(head), "ascending")
        self.browser.press("Enter", 13)
        self.assertEqual(self.shown("#index-table")[0], "too strict")
        self.assertEqual(self.value(head), "descending")
        self.everything()
        self.assertIsNone(self.value(head))

    def test_numbers_are_sorted_as_numbers(self):
        self.view("view-index")
        column = self.value("[...document.querySelectorAll('#index-table thead th')].findIndex(head => head.innerText.startsWith('MPM settlement'))")
        self.value(f"document.querySelectorAll('#index-table thead button')[{column}].click()")
        values = self.value(f"[...document.querySelectorAll('#index-table tbody tr')].map(row => parseFloat(row.cells[{column}].textContent))")
        self.assertEqual(values, sorted(values))
        self.everything()

    def test_a_link_unfolds_its_case(self):
        self.value("document.querySelectorAll('#runs > details').forEach(each => { each.open = false; })")
        self.view("view-index")
        self.value("document.querySelectorAll('#index-table tbody a')[2].click()")
        self.assertEqual(self.value("document.querySelectorAll('#runs > details[open]').length"), 1)

    def test_a_phone_needs_no_sideways_scroll(self):
        self.browser.size(390)
        self.value("document.querySelectorAll('details').forEach(each => { each.open = true; })")
        for view in ("view-problems", "view-index", "view-matrix"):
            self.view(view)
            wide = self.value("""[...document.querySelectorAll("body *")].filter(each => !each.closest(".scroll, svg, pre, math, .skip, .formulas") &&
              each.getBoundingClientRect().right > innerWidth + 1).map(each => each.outerHTML.slice(0, 80))""")
            self.assertEqual(wide, [])
            self.assertLessEqual(self.value("document.documentElement.scrollWidth"), 390)
        self.browser.size(1280)

    def test_what_scrolls_can_be_reached_by_the_keyboard_and_nothing_else(self):
        self.browser.size(390)
        self.value("document.querySelectorAll('details').forEach(each => { each.open = false; })")
        self.value("document.querySelector('#runs > details').open = true")
        self.value("new Promise(done => setTimeout(done, 50))")
        wrong = self.value("""[...document.querySelectorAll("#runs > details[open] > .scroll")].filter(each =>
          (each.scrollWidth > each.clientWidth) !== (each.tabIndex === 0 && each.getAttribute("aria-label") !== null))
          .map(each => each.textContent.slice(0, 40))""")
        self.assertEqual(wrong, [])
        self.assertGreater(self.value("document.querySelectorAll('#runs .scroll[tabindex]').length"), 0)
        self.browser.size(1280)

    def test_headings_labels_and_tables_are_in_order(self):
        levels = self.value("[...document.querySelectorAll('h1,h2,h3,h4,h5,h6')].map(each => Number(each.tagName[1]))")
        self.assertEqual(levels.count(1), 1)
        for before, after in zip(levels, levels[1:]):
            self.assertLessEqual(after, before + 1)
        self.assertEqual(self.value("""[...document.querySelectorAll("input, select, button")].filter(each =>
          !(each.labels && each.labels.length) && !each.textContent.trim()).map(each => each.outerHTML)"""), [])
        self.assertEqual(self.value("[...document.querySelectorAll('table')].filter(each => !each.caption || !each.caption.textContent).length"), 0)
        self.assertEqual(self.value("[...document.querySelectorAll('thead th')].filter(each => !each.scope).length"), 0)
        self.assertEqual(self.value("(ids => ids.length - new Set(ids).size)([...document.querySelectorAll('[id]')].map(each => each.id))"), 0)
        self.assertTrue(self.value("document.documentElement.lang && document.title"))

    def test_words_are_readable_in_light_and_dark(self):
        for scheme in ("light", "dark"):
            self.browser.media(scheme=scheme)
            poor = self.value("""(() => {
              const numbers = text => text.match(/[\\d.]+/g).map(Number);
              const light = text => { const [r, g, b] = numbers(text).map(v => v / 255).map(v => v <= 0.04045 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4);
                return 0.2126 * r + 0.7152 * g + 0.0722 * b; };
              const behind = element => { for (let at = element; at; at = at.parentElement) { const colour = getComputedStyle(at).backgroundColor;
                if (numbers(colour)[3] !== 0) return colour; } return "rgb(255,255,255)"; };
              return [...document.querySelectorAll("p, a, th, td, b, small, button, label, legend, caption, summary, h2, code")]
                .filter(each => each.textContent.trim()).map(each => { const a = light(getComputedStyle(each).color), b = light(behind(each));
                  return [(Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05), each.outerHTML.slice(0, 90)]; }).filter(each => each[0] < 4.5); })()""")
            self.assertEqual(poor, [], scheme)
        self.browser.media()

    def test_print_shows_every_view(self):
        self.browser.media("print")
        self.assertEqual(self.value("[...document.querySelectorAll('#cases > section')].filter(each => each.getClientRects().length === 0).length"), 0)
        self.assertEqual(self.value("document.querySelector('#filters').getClientRects().length"), 0)
        self.browser.media()


class PageWithoutScript(unittest.TestCase):
    def test_shows_everything_and_offers_nothing_that_does_not_work(self):
        browser = Page.browser
        browser.call("Emulation.setScriptExecutionDisabled", value=True)
        try:
            browser.open(Page.address)
            visible = "[...document.querySelectorAll(%r)].filter(each => each.getClientRects().length > 0).length"
            self.assertEqual(browser.evaluate(visible % "#cases > section"), 3)
            self.assertEqual(browser.evaluate(visible % "button, input, select"), 0)
            self.assertEqual(browser.evaluate(visible % "#index-table tbody tr"), 4)
        finally:
            browser.call("Emulation.setScriptExecutionDisabled", value=False)


class Printed(unittest.TestCase):
    settle = folder = None

    def test_a_pdf_has_the_same_bytes_each_time(self):
        printed = []
        for _ in range(2):
            ended = subprocess.run([self.settle, "report", self.folder, "--format", "pdf"], capture_output=True, text=True)
            self.assertEqual(ended.returncode, 1, ended.stderr)  # that of the verdicts
            printed.append((self.folder / "report.pdf").read_bytes())
        self.assertTrue(printed[0].startswith(b"%PDF-"))
        self.assertGreater(len(printed[0]), 20000)
        self.assertEqual(printed[0], printed[1])


class Quiet(unittest.TestCase):
    """Runs last: what all the others have set off."""

    def test_nothing_was_fetched_and_no_error_occurred(self):
        fetched = [url for url in Page.browser.requests if url != Page.address and not url.startswith(("data:", "about:"))]
        self.assertEqual(fetched, [])
        self.assertIn(Page.address, Page.browser.requests)
        self.assertEqual(Page.browser.errors, [])


def main():
    program = chromium.find()
    if program is None:
        print("skipped: there is no chromium (Debian: apt-get install chromium)")
        return 77
    page = written(sys.argv[1], pathlib.Path(sys.argv[2]))
    with chromium.Chromium(program) as browser:
        Page.browser, Page.address = browser, page.resolve().as_uri()
        Printed.settle, Printed.folder = sys.argv[1], page.parent
        loader = unittest.defaultTestLoader
        suite = unittest.TestSuite(map(loader.loadTestsFromTestCase, (Page, PageWithoutScript, Printed, Quiet)))
        passed = unittest.TextTestRunner(verbosity=2).run(suite).wasSuccessful()
    return 0 if passed else 1


if __name__ == "__main__":
    sys.exit(main())
