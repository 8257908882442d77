#!/usr/bin/env python3
"""Links of the documents lead somewhere, and the glossary has each term once."""

from __future__ import annotations

import re
import unittest
from collections import Counter
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]


def pages() -> list[Path]:
    return [*sorted(ROOT.glob("*.md")), *sorted((ROOT / "docs").glob("*.md")), ROOT / "hil" / "README.md"]


def anchors(page: Path) -> set[str]:
    """The names by which a page's headings are linked to: lower case, spaces as hyphens, other signs left out."""
    headings = re.findall(r"^#+ +(.+)$", page.read_text(encoding="utf-8"), re.MULTILINE)
    return {re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-") for heading in headings}


class LinksTest(unittest.TestCase):
    def test_every_link_within_the_tree_leads_to_a_file_and_a_heading(self) -> None:
        links = 0
        for page in pages():
            for target in re.findall(r"\]\(([^)\s]+)\)", page.read_text(encoding="utf-8")):
                if "://" in target:
                    continue
                links += 1
                with self.subTest(page=page.name, link=target):
                    path, _, anchor = target.partition("#")
                    file = (page.parent / path).resolve() if path else page
                    self.assertTrue(file.exists())
                    if anchor:
                        self.assertIn(anchor, anchors(file))
        self.assertGreater(links, 20)

    def test_the_glossary_has_each_term_once(self) -> None:
        text = (ROOT / "GLOSSARY.md").read_text(encoding="utf-8")
        terms = Counter(term.strip().lower() for group in re.findall(r"^- \*\*([^*]+)\*\*", text, re.MULTILINE) for term in group.rstrip(".").split(","))
        self.assertGreater(len(terms), 80)
        self.assertEqual([term for term, count in terms.items() if count > 1], [])


if __name__ == "__main__":
    unittest.main()
