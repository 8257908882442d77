"""A client of the page's server that follows no rule it is not told to: raw HTTP, and WebSocket frames by hand."""

from __future__ import annotations

import base64
import json
import os
import socket
import struct
import time
from dataclasses import dataclass
from typing import Any
from urllib.parse import urlsplit

from rig import PATIENCE, check


@dataclass(frozen=True)
class Reply:
    status: int
    headers: dict[str, str]
    body: bytes

    @property
    def text(self) -> str:
        return self.body.decode(errors="replace").strip()


class Door:
    """Where a server is: its address as it was printed."""

    def __init__(self, address: str) -> None:
        parts = urlsplit(address)
        self.port = int(parts.port or 0)
        self.path = parts.path
        self.host = f"127.0.0.1:{self.port}"
        self.origin = f"http://{self.host}"

    def connect(self, receive_bytes: int = 0) -> socket.socket:
        stream = socket.socket()
        if receive_bytes:
            stream.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, receive_bytes)
        stream.settimeout(20)
        stream.connect(("127.0.0.1", self.port))
        return stream

    def raw(self, request: bytes) -> Reply:
        with self.connect() as stream:
            try:
                stream.sendall(request)
            except (BrokenPipeError, ConnectionResetError):
                pass   # it may have been refused before all of it was sent
            return read_reply(stream)

    def ask(self, path: str = "", method: str = "GET", body: bytes = b"", target: str | None = None, **headers: str | None) -> Reply:
        """`path` stands behind the token; `target` replaces both. A header that is None is left out."""
        lines = {"Host": self.host, "Connection": "close", **({"Content-Length": str(len(body)), "Origin": self.origin} if method == "POST" else {})}
        lines.update({name.replace("_", "-"): value for name, value in headers.items() if value is not None})
        for name, value in headers.items():
            if value is None:
                lines.pop(name.replace("_", "-"), None)
        head = "".join(f"{name}: {value}\r\n" for name, value in lines.items())
        return self.raw(f"{method} {self.path + path if target is None else target} HTTP/1.1\r\n{head}\r\n".encode() + body)

    def json(self, path: str) -> Any:
        reply = self.ask(path)
        check(reply.status == 200, f"{path}: {reply.status} {reply.text}")
        return json.loads(reply.body)


def read_reply(stream: socket.socket) -> Reply:
    data = b""
    while b"\r\n\r\n" not in data:
        more = stream.recv(65536)
        check(more, f"the connection ends without a reply: {data[:200]!r}")
        data += more
    head, body = data.split(b"\r\n\r\n", 1)
    lines = head.decode("latin-1").split("\r\n")
    headers = {name.lower(): value.strip() for name, _, value in (line.partition(":") for line in lines[1:])}
    while len(body) < int(headers.get("content-length", "0")):
        more = stream.recv(65536)
        check(more, "a reply is cut off")
        body += more
    return Reply(int(lines[0].split()[1]), headers, body)


class Closed(Exception):
    """The server ended the conversation."""

    def __init__(self, code: int, reason: str) -> None:
        super().__init__(f"{code} {reason}")
        self.code, self.reason = code, reason


class Viewer:
    """One page's socket. `refused` is the reply that came instead of one."""

    def __init__(self, door: Door, receive_bytes: int = 0, **headers: str | None) -> None:
        self.stream = door.connect(receive_bytes)
        lines: dict[str, str | None] = {"Host": door.host, "Origin": door.origin, "Upgrade": "websocket", "Connection": "Upgrade", "Sec-WebSocket-Version": "13",
                                        "Sec-WebSocket-Key": base64.b64encode(os.urandom(16)).decode(), **headers}
        head = "".join(f"{name}: {value}\r\n" for name, value in lines.items() if value is not None)
        self.stream.sendall(f"GET {door.path}socket HTTP/1.1\r\n{head}\r\n".encode())
        self.rest = b""
        reply = read_reply(self.stream)
        self.refused = None if reply.status == 101 else reply
        self.rest = reply.body if reply.status == 101 else b""

    def close(self) -> None:
        self.stream.close()

    def send(self, payload: bytes, code: int = 1) -> None:
        size = len(payload)
        length = bytes([0x80 | size]) if size < 126 else bytes([0x80 | 126]) + struct.pack(">H", size) if size < 65536 else bytes([0x80 | 127]) + struct.pack(">Q", size)
        self.stream.sendall(bytes([0x80 | code]) + length + bytes(4) + payload)   # a mask of zeros is a mask

    def _exactly(self, size: int) -> bytes:
        while len(self.rest) < size:
            more = self.stream.recv(65536)
            if not more:
                raise Closed(0, "without a word")
            self.rest += more
        taken, self.rest = self.rest[:size], self.rest[size:]
        return taken

    def receive(self, seconds: float = 20) -> str | bytes:
        """The next message: a text, or bytes."""
        self.stream.settimeout(seconds)
        while True:
            first, second = self._exactly(2)
            size = second & 127
            if size == 126:
                (size,) = struct.unpack(">H", self._exactly(2))
            elif size == 127:
                (size,) = struct.unpack(">Q", self._exactly(8))
            payload = self._exactly(size)
            code = first & 15
            if code == 8:
                raise Closed(struct.unpack(">H", payload[:2])[0] if len(payload) >= 2 else 0, payload[2:].decode())
            if code == 9:
                self.send(payload, 10)
            if code in (1, 2):
                return payload.decode() if code == 1 else payload

    def topic(self, name: str, seconds: float = PATIENCE, **values: object) -> dict[str, Any]:
        """The next message of a topic in which these values stand; batches of ticks before it are acknowledged."""
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            message = self.receive(max(0.1, end - time.monotonic()))
            if isinstance(message, bytes):
                self.send(b"seen")
                continue
            said = dict(json.loads(message))
            if said["topic"] == name and all(said.get(key) == value for key, value in values.items()):
                return said
        raise TimeoutError(f"no message {name} {values}")

    def batch(self, seconds: float = 20, seen: bool = True) -> tuple[int, int, int]:
        """First tick, ticks from row to row, and rows of the next batch of ticks."""
        while True:
            message = self.receive(seconds)
            if isinstance(message, bytes):
                if seen:
                    self.send(b"seen")
                first, every, rows = struct.unpack_from("<QII", message)
                return first, every, rows
