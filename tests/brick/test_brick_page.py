"""The page of the virtual brick: access to it, what it sends, and what a real browser shows."""

from __future__ import annotations

import asyncio
import contextlib
import json
import re
import socket
import time
import urllib.error
import urllib.request
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any
from urllib.parse import urlsplit

import aiohttp
import pytest
from selenium.webdriver import ActionChains, Chrome
from selenium.webdriver.common.by import By
from selenium.webdriver.support.ui import WebDriverWait
from support.browser import chromium, complaints, scrolls_sideways
from support.server import Client, Served, command, served

from ev3proto.brick.servers.server import Options

WITH_PAGE = Options(port=0, beacon=False, page=0)


@pytest.fixture
def brick(tmp_path: Path) -> Iterator[Served]:
    with served(tmp_path, WITH_PAGE) as brick:
        yield brick


def fetch(url: str, **headers: str) -> tuple[int, Any, bytes]:
    """Status, headers and body of the response to a plain client."""
    request = urllib.request.Request(url, headers={name.replace("_", "-"): value for name, value in headers.items()})
    try:
        with urllib.request.urlopen(request, timeout=30) as response:
            return response.status, response.headers, response.read()
    except urllib.error.HTTPError as error:
        return error.code, error.headers, error.read()


def test_link_opens_the_page_and_nothing_else_does(brick: Served) -> None:
    link = brick.now.link
    parts = urlsplit(link)
    assert parts.hostname == "127.0.0.1"
    status, headers, body = fetch(link)
    assert status == 200
    assert b"/page.js" in body
    plain = link.partition("?")[0]
    assert fetch(plain)[0] == 403
    assert fetch(plain + "?token=guessed")[0] == 403
    assert fetch(plain + "live")[0] == 403
    cookie = headers["Set-Cookie"]
    assert "HttpOnly" in cookie
    assert "SameSite=Strict" in cookie
    assert fetch(plain + "page.js", Cookie=cookie.partition(";")[0])[0] == 200
    # A name that resolves to this computer, and a page of another site.
    assert fetch(link, Host=f"ev3.example:{parts.port}")[0] == 403
    assert fetch(link, Host="127.0.0.1:1")[0] == 403
    assert fetch(link, Origin="http://ev3.example")[0] == 403
    assert fetch(link, Origin="null")[0] == 403


def test_policy_of_the_page(brick: Served) -> None:
    _, headers, body = fetch(brick.now.link)
    policy = headers["Content-Security-Policy"]
    assert "default-src 'none'" in policy
    assert "unsafe" not in policy
    assert headers["X-Content-Type-Options"] == "nosniff"
    assert headers["Referrer-Policy"] == "no-referrer"
    assert not re.search(rb"<script(?![^>]*src=)|style=|\son\w+=", body)


@pytest.mark.parametrize(
    "request_",
    [
        bytes.fromhex("16030100c6010000c20303") + bytes(180),  # TLS
        b"GET /\x1b[31m HTTP/1.1\r\nHost: x\r\n\r\n",
        b"GET / HTTP/1.1\r\nX: " + b"a" * 100_000 + b"\r\n\r\n",
        b"POST / HTTP/1.1\r\nHost: 127.0.0.1\r\nTransfer-Encoding: chunked\r\n\r\nzz\r\n",
    ],
)
def test_what_is_not_http_is_refused_in_a_sentence(
    brick: Served, request_: bytes, caplog: pytest.LogCaptureFixture, capfd: pytest.CaptureFixture[str]
) -> None:
    port = int(re.findall(r":(\d+)/", brick.now.link)[0])
    for _ in range(2):
        with socket.create_connection(("127.0.0.1", port), 10) as client, contextlib.suppress(ConnectionError):
            client.sendall(request_)
            assert client.recv(100).startswith(b"HTTP/1.0 400 ")
    assert fetch(brick.now.link)[0] == 200
    assert set(brick.said) <= {"a request to the page was not HTTP, and was refused"}
    assert len(brick.said) <= 1
    assert (caplog.text, capfd.readouterr().err) == ("", "")


def test_silent_connections_give_way(brick: Served, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("ev3proto.brick.servers.page.server.MOST_PAGE_CONNECTIONS", 5)
    port = urlsplit(brick.now.link).port
    with contextlib.ExitStack() as stack:
        silent = [stack.enter_context(socket.create_connection(("127.0.0.1", port), 30)) for _ in range(8)]
        assert fetch(brick.now.link)[0] == 200
        for client in silent[:3]:
            with contextlib.suppress(ConnectionError):
                assert client.recv(1) == b""
        silent[-1].settimeout(0.1)
        with pytest.raises(TimeoutError):
            silent[-1].recv(1)
    assert brick.said == []


def test_token_is_another_one_at_each_start(tmp_path: Path) -> None:
    with served(tmp_path, WITH_PAGE) as first, served(tmp_path, WITH_PAGE) as second:
        assert first.now.link.partition("token=")[2] != second.now.link.partition("token=")[2]


def test_actions_and_what_is_wrong_with_them(brick: Served, tmp_path: Path) -> None:
    (tmp_path / "prjs").mkdir(exist_ok=True)
    (tmp_path / "prjs" / "robot.rbf").write_bytes(b"LEGO")

    async def talk() -> list[dict[str, Any]]:
        found: list[dict[str, Any]] = []
        url = brick.now.link.replace("http", "ws", 1).replace("/?", "/live?")
        async with aiohttp.ClientSession() as session, session.ws_connect(url) as socket:
            for action in (
                "no JSON",
                '{"do": "fly"}',
                '{"do": "press", "button": "middle"}',
                '{"do": "plug", "port": 9, "type": 16}',
                '{"do": "plug", "port": 1, "type": 16}',
                '{"do": "read", "port": 1, "mode": 0, "values": [4000]}',
                '{"do": "read", "port": 1, "mode": 0, "values": ["x"]}',
                '{"do": "read", "port": 1, "mode": 7, "values": [1]}',
                '{"do": "list", "path": "/etc"}',
                '{"do": "fetch", "path": "/home/root/lms2012/../../../etc/passwd"}',
                '{"do": "fetch", "path": "/home/root/lms2012/prjs/robot.rbf"}',
                '{"do": "list", "path": "/home/root/lms2012"}',
            ):
                await socket.send_str(action)
            until = time.monotonic() + 30
            while time.monotonic() < until and not any("folder" in message for message in found):
                found.append(json.loads(await socket.receive_str(timeout=30)))
        return found

    messages = asyncio.run(talk())
    assert "facts" in messages[0] or "facts" in messages[1]
    errors = [message["error"] for message in messages if "error" in message]
    assert len(errors) == 8
    assert errors[-2:] == ["no such folder: /etc", "no such file: /home/root/lms2012/../../../etc/passwd"]
    (file,) = [message["file"] for message in messages if "file" in message]
    assert file == {"path": "/home/root/lms2012/prjs/robot.rbf", "contents": "TEVHTw=="}
    (folder,) = [message["folder"] for message in messages if "folder" in message]
    assert [entry["name"] for entry in folder["entries"]] == ["apps", "prjs", "sys", "tools"]
    assert brick.now.brick.equipment.inputs.plugged()[1].raw() == 4000


@pytest.mark.parametrize("width", [390, 1400])
def test_page_in_a_browser(tmp_path: Path, width: int) -> None:
    (tmp_path / "prjs").mkdir()
    (tmp_path / "<img src=x>.rbf").write_bytes(b"12345")
    with (
        served(tmp_path, replace(WITH_PAGE, clients=2)) as brick,
        Client(brick.port) as client,
        chromium(tmp_path / "profile", width) as browser,
    ):
        _look(browser, brick, client)
        assert complaints(browser) == []


def _look(browser: Chrome, brick: Served, client: Client) -> None:
    wait = WebDriverWait(browser, 60, 0.05)
    browser.get(brick.now.link)
    assert "token" not in browser.current_url
    brick.now.brick.plug("A", 7)
    client.ask(
        command(
            "UI_DRAW(FILLRECT, 1, 0, 0, 60, 40)\nUI_DRAW(UPDATE)\nUI_WRITE(LED, 6)\n"
            "SOUND(TONE, 50, 440, 3000)\nOUTPUT_SPEED(0, 1, 50)\nOUTPUT_START(0, 1)"
        )
    )
    wait.until(lambda _: browser.find_element(By.ID, "leds").text == "LED_ORANGE_FLASH")
    assert "orange" in str(browser.find_element(By.ID, "pad").get_attribute("class"))
    pixel = "return [...document.getElementById('display').getContext('2d').getImageData(arguments[0], 5, 1, 1).data]"
    wait.until(lambda _: browser.execute_script(pixel, 59)[0] < 60)
    assert browser.execute_script(pixel, 60)[0] > 180
    wait.until(lambda _: "rotate(" in str(browser.find_element(By.CSS_SELECTOR, ".wheel").get_attribute("style")))
    wait.until(lambda _: "FREQUENCY=440" in browser.find_element(By.ID, "talks").text)

    # A move without a motor is named.
    client.ask(command("OUTPUT_STEP_SPEED(0, D, 50, 0, 90, 0, 1)"))
    wait.until(lambda _: "a move on D does not end: no motor is" in browser.find_element(By.ID, "waiting").text)

    # A button is pressed, a sensor is plugged in and dragged.
    brick.now.brick.plug(1, 29, {0: (10,)})
    slider = wait.until(lambda _: browser.find_element(By.CSS_SELECTOR, ".sensor input"))
    drag = "arguments[0].value = 77; arguments[0].dispatchEvent(new Event('input'))"
    browser.execute_script(drag, slider)
    browser.find_element(By.CSS_SELECTOR, "[data-button=enter]").click()
    read = command("DATA8 light\nDATA8 enter\nINPUT_READ(0, 0, 0, -1, light)\nUI_BUTTON(SHORTPRESS, 2, enter)", 7)
    wait.until(lambda _: client.ask(read)[5] == 77)
    # The button is released in a separate message.
    wait.until(lambda _: brick.now.brick.equipment.buttons.bump(2))

    # A distance has its unit; a touch sensor is a button.
    brick.now.brick.plug(2, 30, {0: (1941,)})
    wait.until(lambda _: "194.1 cm" in browser.find_element(By.ID, "sensors").text)
    brick.now.brick.plug(3, 16)
    touch = wait.until(lambda _: browser.find_element(By.CSS_SELECTOR, ".touch"))
    ActionChains(browser).click_and_hold(touch).perform()
    wait.until(lambda _: brick.now.brick.equipment.inputs.plugged()[3].raw() == 2000 and touch.text == "pressed")
    ActionChains(browser).release().perform()
    wait.until(lambda _: brick.now.brick.equipment.inputs.plugged()[3].raw() == 1000 and touch.text == "not pressed")
    # A sensor that is declared: its title, the name of its value, and what is set there.
    mode = {"name": "HEADING", "format": "DATA_16", "raw": (0, 359), "symbol": "deg", "values": ["heading"]}
    brick.now.brick.plug(3, {"type": 62, "title": "I2C compass", "modes": [mode]}, {0: (90,)})
    label = "Port 3, HEADING, heading"
    compass = wait.until(lambda _: browser.find_element(By.CSS_SELECTOR, f"[aria-label='{label}']"))
    wait.until(lambda _: "90 degrees" in browser.find_element(By.ID, "sensors").text)
    chosen = browser.find_element(By.CSS_SELECTOR, "[aria-label='Port 3'] option:checked")
    assert chosen.text == "I2C compass"
    browser.execute_script(drag.replace("77", "270"), compass)
    wait.until(lambda _: brick.now.brick.equipment.inputs.plugged()[3].raw() == 270)
    assert not scrolls_sideways(browser)

    # Lines that do not match are hidden; a name is shown as text.
    browser.find_element(By.ID, "talk-filter").send_keys("input_read")
    assert "FREQUENCY" not in browser.find_element(By.ID, "talks").text
    assert "INPUT_READ" in browser.find_element(By.ID, "talks").text
    wait.until(lambda _: "<img src=x>.rbf" in browser.find_element(By.ID, "files").text)
