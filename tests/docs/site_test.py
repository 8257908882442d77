#!/usr/bin/env python3
"""The site works without a server and a network: site_test.py HTML

Every link within it leads to a file and a place on its page, nothing is fetched from elsewhere, every document is there, and its search finds a word, also in
a browser on the files themselves; without Chromium that test is skipped. The last line counts.
"""

from __future__ import annotations

import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urlsplit

ROOT = Path(__file__).resolve().parents[2]
OUTSIDE = ("http", "https", "mailto")


class Page(HTMLParser):
    """Where a page links to, what it needs to be shown, and the places on it."""

    def __init__(self, path: Path) -> None:
        super().__init__()
        self.links: list[str] = []
        self.needs: list[str] = []
        self.places: set[str] = set()
        self.feed(path.read_text(encoding="utf-8", errors="replace"))

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        of = {name: value or "" for name, value in attrs}
        self.places.update(value for name in ("id", "name") if (value := of.get(name)))
        if tag == "a" and "href" in of:
            self.links.append(of["href"])
        elif tag == "link" and of.get("rel") in ("stylesheet", "icon", "shortcut icon", "preload"):
            self.needs.append(of["href"])
        elif "src" in of:
            self.needs.append(of["src"])


def wrong_links(html: Path) -> tuple[int, list[str]]:
    """How many links within the site there are, and those that lead nowhere or fetch from elsewhere."""
    pages = {path.resolve(): Page(path) for path in sorted(html.rglob("*.html"))}
    count, wrong = 0, []
    for path, page in pages.items():
        for link in page.links + page.needs:
            parts = urlsplit(link)
            if parts.scheme in OUTSIDE or parts.netloc:
                if link in page.needs:
                    wrong.append(f"{path.relative_to(html)}: fetches {link}")
                continue
            if parts.scheme or not (parts.path or parts.fragment):
                continue
            count += 1
            target = (path.parent / unquote(parts.path)).resolve() if parts.path else path
            if not target.is_file():
                wrong.append(f"{path.relative_to(html)}: {link} is not there")
            elif parts.fragment and target in pages and unquote(parts.fragment) not in pages[target].places:
                wrong.append(f"{path.relative_to(html)}: {link} has no such place")
    return count, wrong


def found_in_browser(html: Path, chromium: str, word: str) -> str:
    """The results that the search page shows for a word when it is opened as a file, without a network."""
    with tempfile.TemporaryDirectory() as profile:
        answer = subprocess.run([chromium, "--headless", "--no-sandbox", "--disable-gpu", "--proxy-server=127.0.0.1:9", f"--user-data-dir={profile}",
                                 "--virtual-time-budget=10000", "--dump-dom", f"{(html / 'search.html').resolve().as_uri()}?q={word}"],
                                capture_output=True, text=True, timeout=120, check=False)
    results = re.search(r'<ul[^>]*class="search".*?</ul>', answer.stdout, re.DOTALL)
    return results.group() if results else ""


class SiteTest(unittest.TestCase):
    html = Path()

    def test_every_link_leads_somewhere_and_nothing_is_fetched(self) -> None:
        count, wrong = wrong_links(self.html.resolve())
        self.assertGreater(count, 2000)
        self.assertEqual(wrong[:20], [])

    def test_what_is_wrong_is_noticed(self) -> None:
        with tempfile.TemporaryDirectory() as folder:
            html = Path(folder).resolve()
            (html / "a.html").write_text('<a href="b.html">b</a><a href="#no">no</a><a href="#here" id="here">here</a><script src="https://x.org/x.js"></script>')
            self.assertEqual(wrong_links(html), (3, ["a.html: b.html is not there", "a.html: #no has no such place", "a.html: fetches https://x.org/x.js"]))

    def test_every_document_is_there(self) -> None:
        documents = [*ROOT.glob("*.md"), *(ROOT / "docs").glob("*.md"), ROOT / "hil" / "README.md", ROOT / "shared" / "SPEC.md"]
        self.assertGreater(len(documents), 20)
        self.assertEqual([path.name for path in documents if not (self.html / path.relative_to(ROOT)).with_suffix(".html").is_file()], [])

    def test_the_interfaces_are_there(self) -> None:
        for name, word in (("c", "isotouch_touch_position"), ("core", "step_proxy")):
            pages = [path.read_text(encoding="utf-8", errors="replace") for path in (self.html / "api" / name).glob("*.html")]
            self.assertTrue(any(word in page for page in pages), word)

    def test_the_index_of_the_search_has_the_words_of_the_documents(self) -> None:
        index = (self.html / "searchindex.js").read_text(encoding="utf-8")
        for word in ("hydrant", "buzz", "first-day-with-a-falcon"):
            self.assertIn(word, index)

    def test_a_browser_finds_a_word_on_the_files_themselves(self) -> None:
        chromium = shutil.which("chromium")
        if chromium is None:
            self.skipTest("there is no Chromium")
        self.assertIn("docs/first-day-with-a-falcon.html", found_in_browser(self.html, chromium, "monostable"))
        self.assertNotIn("docs/first-day-with-a-falcon.html", found_in_browser(self.html, chromium, "nosuchwordanywhere"))


if __name__ == "__main__":
    SiteTest.html = Path(sys.argv.pop())
    result = unittest.main(exit=False).result
    failed = len(result.failures) + len(result.errors)
    print(f"{result.testsRun - failed - len(result.skipped)} passed, {failed} failed, {len(result.skipped)} skipped")
    sys.exit(0 if result.wasSuccessful() and result.testsRun > 0 else 1)
