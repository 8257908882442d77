#!/usr/bin/env python3
"""The messages that docs/troubleshooting.md quotes are still those of the programs, and none of those that stop the force is missing there."""

from __future__ import annotations

import re
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PROGRAMS = ("isotouch ", "isotouchd ", "journalctl ", "ssh ", "lsusb ", "cmake ", "./dev ")
SOURCES = [path for folder in ("firmware", "host", "shared") for pattern in ("*.h", "*.cpp", "*.ts") for path in sorted((ROOT / folder).rglob(pattern))
           if "node_modules" not in path.parts]


def source(text: str) -> str:
    """Source text in which a literal that goes on in the next line is one, without escapes."""
    return re.sub(r'"\s*\n\s*"', "", text).replace('\\"', '"')


def is_message(span: str) -> bool:
    """A sentence of a program, not a name or a command to type."""
    return len(span.split()) >= 3 and (not span.startswith(PROGRAMS) or ";" in span)


def spans_of(page: str) -> list[str]:
    """The code spans of a page outside of blocks, each in one line."""
    prose = re.sub(r"^```.*?^```$", "", page, flags=re.MULTILINE | re.DOTALL)
    return [" ".join(each.split()) for each in re.findall(r"`([^`]+)`", prose)]


def exists(message: str, texts: list[str]) -> bool:
    """Are all parts of a message, between what differs each time, in one source?"""
    parts = [part.strip() for part in message.split("…") if part.strip(" ().;:,")]
    return bool(parts) and any(all(part in text for part in parts) for text in texts)


def literals(text: str, pattern: str) -> list[str]:
    return [match.group(1) for match in re.finditer(pattern, text)]


class MessagesTest(unittest.TestCase):
    page: str
    texts: list[str]
    spans: list[str]
    messages: list[str]

    @classmethod
    def setUpClass(cls) -> None:
        cls.texts = [source(path.read_text(encoding="utf-8")) for path in SOURCES]
        cls.page = (ROOT / "docs" / "troubleshooting.md").read_text(encoding="utf-8")
        cls.spans = spans_of(cls.page)
        cls.messages = [span for span in cls.spans if is_message(span)]

    def read(self, path: str) -> str:
        return source((ROOT / path).read_text(encoding="utf-8"))

    def all_are_quoted(self, sentences: list[str], least: int) -> None:
        self.assertGreaterEqual(len(sentences), least)
        self.assertEqual([sentence for sentence in sentences if not any(sentence.strip() in span for span in self.spans)], [])

    def test_every_message_is_in_the_sources(self) -> None:
        self.assertGreater(len(self.messages), 90)
        self.assertEqual([message for message in self.messages if not exists(message, self.texts)], [])

    def test_a_message_that_no_program_prints_is_noticed(self) -> None:
        for invented in ("the device did not reply in time; check its cable and power supply", "the field takes … bytes, and [limits] field_mb allows",
                         "the encoders jumped … of the surface closes gaps"):
            self.assertFalse(exists(invented, self.texts), invented)

    def test_every_fault_is_there_with_its_name(self) -> None:
        faults = re.findall(r'\{kFault\w+,\s*"(\w+)",\s*"([^"]+)"\}', self.read("shared/fault_names.h"))
        self.assertEqual(len(faults), len(re.findall(r"kFault\w+ = 1", self.read("shared/tick_io.h"))))
        self.all_are_quoted([sentence for _, sentence in faults], 11)
        self.assertEqual([name for name, _ in faults if f"(*{name}*)" not in self.page], [])

    def test_every_reason_to_wait_is_there(self) -> None:
        text = self.read("shared/files/state_text.cpp")
        self.all_are_quoted(literals(text, r'\{k\w+, "([^"]+)"\}') + literals(text, r'string_view k\w+ = "([^"]+)"'), 7)
        states = re.findall(r'\{"(\w+)", ":([^"]*)"\}', text)
        self.assertEqual(len(states), 7)
        waiting = [(name, sentence.strip()) for name, sentence in states if name not in ("active", "fault")]
        self.assertEqual([name for name, _ in waiting if f"(state *{name}*)" not in self.page], [])
        self.all_are_quoted([sentence for _, sentence in waiting if sentence], 4)

    def test_every_reason_of_the_guard_is_there(self) -> None:
        table = self.read("shared/fault_names.h").split("kGuardVerdictNames = {")[1].split("};")[0]
        self.all_are_quoted([name for name in re.findall(r'"([^"]+)"', table) if name != "none"], 17)

    def test_every_trouble_with_the_device_is_there(self) -> None:
        self.all_are_quoted(literals(self.read("firmware/falcon/link_error.h"), r'case LinkError::k\w+: return "([^"]+)"'), 8)

    def test_every_reason_to_refuse_a_build_is_there(self) -> None:
        calls = re.findall(r"\b(?:refuse|limit)\((.*?)\);", self.read("host/field/verdict.cpp"), re.DOTALL)
        sentences = [max(re.findall(r'"([^"]+)"', call), key=len).split(";")[0].strip() for call in calls if '"' in call]
        self.all_are_quoted(sentences, 22)


if __name__ == "__main__":
    unittest.main()
