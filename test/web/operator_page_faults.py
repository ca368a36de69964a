#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The Lamina authors
# SPDX-License-Identifier: BSD-3-Clause
"""The operator's page, in headless Chromium, before a server that fails.

Usage: operator_page_faults.py PAGE_FOLDER SCRATCH_FOLDER   exits 1 and says what was not so, 77 without a browser

The server is started anew and knows the page's key no more; its WebSocket falls silent and stays open, as behind a cable that was
pulled; it answers slowly. Fingers press twice.
"""
import base64
import hashlib
import http.server
import json
import os
import shutil
import sys
import threading
import time

try:
    from selenium import webdriver
    from selenium.webdriver.chrome.options import Options
    from selenium.webdriver.chrome.service import Service
    from selenium.webdriver.common.by import By
except ImportError:
    webdriver = None

PATIENCE = 60  # s: far above what anything takes, for loaded machines
FLAGS = ("--headless=new", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking",
         "--disable-component-update", "--disable-sync", "--disable-dev-shm-usage", "--window-size=1280,900")
TYPES = {".html": "text/html", ".js": "text/javascript", ".css": "text/css", ".svg": "image/svg+xml"}
PICTURE = base64.b64decode("R0lGODlhAQABAIAAAAAAAP///ywAAAAAAQABAAACAUwAOw==")


class Cell:
    """What the server is told to do, and what it was asked."""

    def __init__(self):
        self.csrf = "first"
        self.state = "Execute"
        self.sequence = 1
        self.machine_age_s = 0
        self.has_camera = False
        self.socket = "live"  # or silent
        self.after = {}  # the state that a command leads to
        self.resume_refusal = None  # of a job that was cut off; empty if it can be resumed
        self.resume_steps = []
        self.upload_s = 0.0
        self.forms = []  # of the uploads
        self.bodies = []  # of the commands
        self.pressed = []  # when each was, as the page has it, and when it came [s]
        self.refused = 0  # questions who is logged in that are answered by 503 first
        self.events, self.samples = [], []
        self.clock_s = 0.0  # what its clock is ahead by
        self.commands, self.uploads, self.pictures, self.sockets, self.asked = [], 0, 0, 0, 0

    def shown(self):
        unit = {"state": self.state, "sequence": self.sequence, "in_state_s": 1, "mode": "Production", "mode_number": 1,
                "accepted_now": ["Hold", "Stop", "Abort", "Reset", "Start", "Clear"], "resume_waits": self.resume_refusal is not None,
                "resume_refusal": self.resume_refusal or "", "resume_steps": self.resume_steps, "is_part_on_plate": False}
        return {"utc_s": int(time.time() + self.clock_s), "is_fresh": True, "age_s": 0, "notices": [], "unit": unit, "job": None, "alarms": [], "queue": [],
                "progress": {"lines": 10, "lines_acknowledged": 1, "layer": -1, "fraction": 0.1},
                "machine": {"nozzle_degc": 210.0, "bed_degc": 60.0, "position_m": [0, 0, 0], "age_s": self.machine_age_s, "failure": ""},
                "startup": [], "loop": None, "layers": [], "deviation_number": 0, "has_camera": self.has_camera, "parts": 0, "defective": 0,
                "clock_s": time.monotonic(),
                "key_requests": []}


class Handler(http.server.BaseHTTPRequestHandler):
    protocol_version = "HTTP/1.1"
    cell = None
    page = ""

    def log_message(self, *_):
        pass

    def answer(self, status, value, kind="application/json"):
        body = value if isinstance(value, bytes) else json.dumps(value).encode()
        self.send_response(status)
        self.send_header("Content-Type", kind)
        self.send_header("Content-Length", str(len(body)))
        self.send_header("Cache-Control", "no-store")
        self.end_headers()
        self.wfile.write(body)

    def do_GET(self):
        cell, path = self.cell, self.path.split("?")[0]
        if path == "/" or path.startswith("/page/"):
            name = "index.html" if path == "/" else os.path.basename(path)
            with open(f"{self.page}/{name}", "rb") as file:
                self.answer(200, file.read(), TYPES[os.path.splitext(name)[1]])
        elif path == "/api/v1/session" and cell.refused > 0:
            cell.refused -= 1
            self.answer(503, {"code": "busy", "message": "busy"})
        elif path == "/api/v1/session":
            self.answer(200, {"version": "1", "is_known": True, "name": "this host", "role": "maintenance", "csrf": cell.csrf, "is_local": True,
                              "needs_no_token": True})
        elif path == "/api/v1/state":
            cell.asked += 1
            self.answer(200, cell.shown())
        elif path == "/api/v1/history":
            begin = float(self.path.partition("from=")[2] or 0)
            self.answer(200, {name: [row for row in rows if row["utc_s"] >= begin]
                              for name, rows in (("samples", cell.samples), ("events", cell.events))})
        elif path == "/api/v1/tokens":
            self.answer(200, {"tokens": []})
        elif path == "/api/v1/camera":
            cell.pictures += 1
            self.answer(200, PICTURE, "image/gif")
        elif path == "/api/v1/ws":
            self.speak()
        else:
            self.answer(404, {"code": "unknown", "message": "unknown"})

    def speak(self):
        """A WebSocket that gives the state twenty times a second, or once and then nothing, and never ends by itself."""
        cell = self.cell
        cell.sockets += 1
        key = self.headers["Sec-WebSocket-Key"] + "258EAFA5-E914-47DA-95CA-C5AB0DC85B11"
        accept = base64.b64encode(hashlib.sha1(key.encode()).digest()).decode()
        self.wfile.write(("HTTP/1.1 101 Switching Protocols\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
                          f"Sec-WebSocket-Accept: {accept}\r\n\r\n").encode())
        is_live = cell.socket == "live"
        try:
            while True:
                if is_live and cell.socket == "live":
                    text = json.dumps(cell.shown()).encode()
                    self.wfile.write(bytes([0x81, 126]) + len(text).to_bytes(2, "big") + text)
                time.sleep(0.05)
        except OSError:
            pass
        self.close_connection = True

    def do_POST(self):
        cell = self.cell
        body = self.rfile.read(int(self.headers.get("Content-Length", 0)))
        if self.headers.get("X-CSRF-Token") != cell.csrf:
            self.answer(403, {"code": "no_csrf_token", "message": "the header X-CSRF-Token is missing or another one"})
        elif self.path == "/api/v1/commands":
            cell.bodies.append(json.loads(body))
            cell.pressed.append((float(self.headers.get("X-Pressed-At", "nan")), time.monotonic()))
            command = cell.bodies[-1]["command"]
            cell.commands.append(command)
            if command in cell.after:
                cell.state, cell.sequence = cell.after[command], cell.sequence + 1
            self.answer(200, {"message": ""})
        elif self.path == "/api/v1/jobs":
            cell.uploads += 1
            cell.forms.append(body.decode())
            time.sleep(cell.upload_s)
            self.answer(201, {"job": 1, "name": "a.gcode", "bytes": 1, "sha256": ""})
        else:
            self.answer(404, {"code": "unknown", "message": "unknown"})


def require(is_so, what):
    if not is_so:
        raise AssertionError(what)


class Page:
    def __init__(self, url, folder):
        options = Options()
        for flag in (*FLAGS, f"--user-data-dir={folder}/browser"):
            options.add_argument(flag)
        options.binary_location = "/usr/bin/chromium"
        self.browser = webdriver.Chrome(service=Service("/usr/bin/chromedriver"), options=options)
        self.url = url

    def open(self):
        self.browser.get(self.url)
        self.wait(lambda: self.text("#state-name") != "", "a state")

    def text(self, selector):
        return self.browser.execute_script("return document.querySelector(arguments[0])?.innerText ?? ''", selector)

    def script(self, text):
        return self.browser.execute_script(text)

    def press(self, name, times=1):
        """Presses within one turn of the browser, as the second press of two that are close."""
        self.browser.execute_script("for (let i = 0; i < arguments[1]; ++i) document.getElementById(arguments[0]).click()", name, times)

    def wait(self, is_so, what):
        until = time.monotonic() + PATIENCE
        while time.monotonic() < until:
            if is_so():
                return
            time.sleep(0.02)
        raise AssertionError(f"not in {PATIENCE} s: {what}; the page says: {self.text('body')[:600]}")


def check_server_started_anew(page, cell):
    """Its key is another one: Hold goes through all the same."""
    page.open()
    cell.csrf = "second"
    page.press("hold")
    page.wait(lambda: "accepted" in page.text("#command-answer"), "Hold is accepted by the server that was started anew")
    require(cell.commands == ["Hold"], f"commands were {cell.commands}")


def check_time_of_a_press(page, cell):
    """By the server's clock, not before the state by which it was pressed and not after it came."""
    before = time.monotonic()
    page.open()
    page.press("hold")
    page.wait(lambda: cell.pressed, "Hold has come")
    pressed, came = cell.pressed[0]
    require(before <= pressed <= came + 0.001, f"pressed at {pressed} s; expected {before} to {came} s")


def check_busy_server(page, cell):
    """The page waits for a server that does not say yet who is logged in."""
    cell.refused = 2
    page.open()


def check_silent_socket(page, cell):
    """A WebSocket that is open and says nothing: the state is asked for, and another one is opened."""
    page.open()
    before = cell.sockets
    cell.socket = "silent"
    cell.state = "Held"
    page.wait(lambda: page.text("#state-name") == "Held", "the page asks for the state by itself")
    page.wait(lambda: cell.sockets > before, "another WebSocket")
    cell.socket = "live"
    cell.state = "Execute"
    page.wait(lambda: page.text("#state-name") == "Printing" and page.text("#stale") == "", "the link is there again")


def check_camera_after_loss(page, cell):
    """The picture is asked for anew once the link is there again: that of before would stand still."""
    cell.has_camera = True
    page.open()
    page.wait(lambda: cell.pictures > 0, "a picture")
    before, sockets = cell.pictures, cell.sockets
    cell.socket = "silent"
    page.wait(lambda: cell.sockets > sockets, "another WebSocket")
    cell.socket = "live"
    page.wait(lambda: cell.pictures > before, "the picture anew")


def check_second_press(page, cell):
    """Reset pressed twice does not start: by the second press the same button says Start."""
    cell.state = "Stopped"
    cell.after = {"Reset": "Idle", "Start": "Starting"}
    page.open()
    page.press("next")
    page.wait(lambda: page.text("#next") == "Start", "Start is offered")
    page.press("next")
    time.sleep(0.3)
    require(cell.commands == ["Reset"], f"the second press of Reset has given {cell.commands}")
    time.sleep(1.0)
    page.press("next")
    page.wait(lambda: cell.commands == ["Reset", "Start"], f"Start, where it was meant; commands were {cell.commands}")


def check_resume_only_where_it_can_be_done(page, cell):
    """Start of a job that was cut off goes through what a resume needs, and offers no resume that would be refused."""
    cell.state, cell.resume_refusal = "Idle", ""
    cell.resume_steps = [{"name": "part", "state": "person", "text": "the part stands where it stood"}]
    page.open()
    page.press("next")
    page.wait(lambda: page.script("return document.getElementById('resume').open"), "the steps")
    require(page.script("return document.activeElement.id") == "resume-back", "the focus is on the way back")
    page.script("document.getElementById('resume-start').click()")
    require(page.script("return document.getElementById('resume').open"), "nothing starts before a person has looked")
    require(page.script("return document.getElementById('resume-discard').checkVisibility()"), "the job can be discarded")
    page.script("document.getElementById('resume-back').click()")
    page.wait(lambda: not page.script("return document.getElementById('resume').open"), "the steps are closed")

    # What stands against it may go by: the steps show it, and go on once it has.
    place = {"name": "place", "state": "waits", "text": "the machine still moves"}
    cell.resume_refusal, cell.resume_steps = "the machine still moves", [place]
    page.wait(lambda: "still moves" in page.text("#state-detail"), "why it is not resumed, before anything is pressed")
    require("only be discarded" not in page.text("#state-detail"), page.text("#state-detail"))
    page.press("next")
    page.wait(lambda: page.script("return document.getElementById('resume').open"), "the steps, whatever stands against it now")
    require("still moves" in page.text("#resume-steps"), "the step does not say what it waits for")
    page.script("document.getElementById('resume-start').click()")
    require(page.script("return document.getElementById('resume').open"), "a resume that would be refused is started")
    require(page.script("return document.getElementById('resume-discard').checkVisibility()"), "the job can be discarded")
    cell.resume_refusal, cell.resume_steps = "", [{**place, "state": "person", "text": "it begins after 15.2 mm"}]
    page.wait(lambda: page.script("return document.getElementById('resume-place').checkVisibility()"), "the place, once it is known")
    page.script("document.getElementById('resume-back').click()")
    page.wait(lambda: not page.script("return document.getElementById('resume').open"), "the steps are closed")
    require(cell.commands == [], f"going back has given {cell.commands}")

    # What never goes by, in the words of the unit.
    cell.resume_refusal = "the part that was cut off was taken away; discard its job"
    page.wait(lambda: "can only be discarded: the part" in page.text("#state-detail"), "nothing is said to be waited for")
    cell.resume_refusal = ""


def check_resume_from_the_place_that_was_confirmed(page, cell):
    """The command says where the job begins that a person has looked at; a place that becomes another one is looked at anew."""
    place = {"name": "place", "state": "person", "text": "it begins after 15.25 mm", "begin_mm": 15.25}
    cell.state, cell.resume_refusal, cell.resume_steps = "Idle", "", [place]
    page.open()
    page.press("next")
    page.wait(lambda: page.script("return document.getElementById('resume').open"), "the steps")
    page.press("resume-place")
    cell.resume_steps = [{**place, "text": "it begins after 21.5 mm", "begin_mm": 21.5}]
    page.wait(lambda: not page.script("return document.getElementById('resume-place').checked"), "another place, not confirmed")
    page.press("resume-place")
    page.press("resume-start")
    page.wait(lambda: cell.commands == ["Start"], "Start")
    sent = {name: cell.bodies[0].get(name) for name in ("cut_off", "confirmed", "confirmed_begin_mm")}
    require(sent == {"cut_off": "resume", "confirmed": ["place"], "confirmed_begin_mm": 21.5}, f"Start was sent with {sent}")


def check_resume_in_a_low_window(page, cell):
    """In a window of 600 px, the head of the steps and their answers are seen whatever has the focus; the steps go by between them."""
    names = ("link", "place", "part", "ready", "way")
    cell.state, cell.resume_refusal = "Idle", ""
    cell.resume_steps = [{"name": name, "state": "person", "text": f"{name}: " + "what is known, and what is not. " * 9} for name in names]
    page.open()
    seen = """const box = (id) => document.getElementById(id).getBoundingClientRect();
      const list = box("resume-steps");
      const isSeen = (id, within) => box(id).top >= within.top - 1 && box(id).bottom <= within.bottom + 1;
      const window_ = { top: 0, bottom: innerHeight };
      const step = document.activeElement.closest("#resume-steps") ? document.activeElement.id : "";
      return { unseen: ["resume-title", "resume-text", "resume-left", "resume-back", "resume-start"].filter((id) => !isSeen(id, window_)),
        list: list.height, step, isStepSeen: !step || isSeen(step, list) };"""
    for width, height in ((1280, 600), (740, 360)):
        page.browser.execute_cdp_cmd("Emulation.setDeviceMetricsOverride",
                                     {"width": width, "height": height, "deviceScaleFactor": 1, "mobile": False})
        page.wait(lambda: page.script("return innerHeight") == height, f"a window of {height} px")
        page.press("next")
        page.wait(lambda: page.script("return document.getElementById('resume').open"), "the steps")
        for focus in ("resume-back", "resume-way", "resume-link", "resume-start"):
            page.script(f"document.getElementById('{focus}').focus()")
            found = page.script(seen)
            picture = os.environ.get("LAMINA_PICTURES")
            if picture:
                page.browser.save_screenshot(f"{picture}/resume_{width}x{height}_{focus}.png")
            require(not found["unseen"], f"in {width} x {height} with the focus on {focus}: {found['unseen']} not seen")
            require(found["isStepSeen"] and found["list"] >= 80, f"in {width} x {height} with the focus on {focus}: {found}")
        page.press("resume-back")
        page.wait(lambda: not page.script("return document.getElementById('resume').open"), "the steps are closed")
    page.browser.execute_cdp_cmd("Emulation.clearDeviceMetricsOverride", {})


def check_confirmed_place_with_noise(page, cell):
    """What encoders report varies: the place stays confirmed. Another place, or one that is known otherwise, is looked at anew."""
    rests = {"name": "place", "state": "person", "text": "the nozzle rests at 17.2 mm; it begins after 15.2 mm", "begin_mm": 15.24}
    cell.state, cell.resume_refusal, cell.resume_steps = "Idle", "", [rests]
    page.open()
    page.press("next")
    page.wait(lambda: page.script("return document.getElementById('resume').open"), "the steps")

    def is_confirmed(step):
        cell.resume_steps = [step]
        page.wait(lambda: step["text"] in page.text("#resume-steps"), f"the place '{step['text']}'")
        return page.script("return document.getElementById('resume-place').checked")

    page.press("resume-place")
    require(is_confirmed({**rests, "text": "the nozzle rests at 17.3 mm; it begins after 15.3 mm", "begin_mm": 15.26}), "noise withdraws it")
    require(is_confirmed({**rests, "text": "the nozzle rests at 17.7 mm; it begins after 15.7 mm", "begin_mm": 15.73}), "noise withdraws it")
    require(not is_confirmed({**rests, "text": "the nozzle rests at 17.8 mm; it begins after 15.8 mm", "begin_mm": 15.75}), "it crept away")
    page.press("resume-place")
    require(not is_confirmed({**rests, "text": "it is not known; it begins after 15.8 mm", "begin_mm": 15.75}), "known otherwise")


def check_upload_pressed_twice(page, cell, folder):
    cell.upload_s = 1.0
    program = f"{folder}/a.gcode"
    with open(program, "w", encoding="utf-8") as file:
        file.write("G1 X1\n")
    page.open()
    page.browser.find_element(By.ID, "program").send_keys(program)
    page.press("upload", 2)
    page.wait(lambda: "waits in the queue" in page.text("#upload-answer"), "the upload")
    time.sleep(1.5)
    require(cell.uploads == 1, f"the file was sent {cell.uploads} times")


def check_mesh_fields(page, cell, folder):
    """What a mesh is sliced by is asked where one is chosen, by fields that have names, and sent with it; programs ask nothing."""
    for name in ("a.gcode", "b.stl"):
        with open(f"{folder}/{name}", "w", encoding="utf-8") as file:
            file.write("\n")
    page.open()
    choice = page.browser.find_element(By.ID, "program")
    choice.send_keys(f"{folder}/a.gcode")
    require(not page.browser.find_element(By.ID, "mesh-fields").is_displayed(), "a program asks how it is sliced")
    choice.send_keys(f"{folder}/b.stl")
    names = []
    for field, value in (("material", "pla"), ("process", "fine"), ("settings", "walls.count=2")):
        control = page.browser.find_element(By.ID, f"mesh-{field}")
        names.append(control.accessible_name)
        control.send_keys(value)
    require(all(names), f"fields without a name: {names}")
    page.press("upload")
    page.wait(lambda: "waits in the queue" in page.text("#upload-answer"), "the upload")
    for field, value in (("material", "pla"), ("process", "fine"), ("settings", "walls.count=2")):
        require(f'name="{field}"\r\n\r\n{value}\r\n' in cell.forms[-1], f"the form has no {field}: {cell.forms[-1]}")
    require(not page.browser.find_element(By.ID, "mesh-fields").is_displayed(), "the fields stay after the upload")


def check_old_figures(page, cell):
    """Temperatures that the machine reported long ago are not shown as those of now; events tell their day."""
    cell.machine_age_s = 600
    cell.events = [{"number": 1, "utc_s": time.time() - 30 * 86400, "kind": "state", "text": "Idle"},
                   {"number": 2, "utc_s": time.time(), "kind": "state", "text": "Execute"}]
    page.open()
    page.wait(lambda: "10 min ago" in page.text("#heat"), f"how old the temperatures are; it says '{page.text('#heat')}'")
    page.wait(lambda: "Idle" in page.text("#event-list"), "the log")
    day = page.browser.execute_script("return new Date(arguments[0] * 1000).toLocaleDateString()", cell.events[0]["utc_s"])
    require(day in page.text("#event-list"), f"the log does not say that an event is of {day}: '{page.text('#event-list')}'")
    today = page.browser.execute_script("return new Date(arguments[0] * 1000).toLocaleDateString()", cell.events[1]["utc_s"])
    require(today not in page.text("#event-list"), "the log gives the day of what was today")


def check_clock_set_back(page, cell):
    """What happens after the clock was set back by an hour is in the log."""
    row = {"nozzle_degc": 210.0, "bed_degc": 60.0, "fraction": 0.1}
    cell.clock_s = 3600.0
    cell.samples = [{"utc_s": time.time() + 3600.0 - age, **row} for age in range(60, 0, -1)]
    cell.events = [{"number": 1, "utc_s": time.time() + 3600.0 - 10, "kind": "state", "text": "before"}]
    page.open()
    page.wait(lambda: "before" in page.text("#event-list"), "the log")
    cell.clock_s = 0.0
    cell.samples.append({"utc_s": time.time(), **row})
    cell.events.append({"number": 2, "utc_s": time.time(), "kind": "state", "text": "afterwards"})
    page.wait(lambda: "afterwards" in page.text("#event-list"), "what happened after the clock was set back")


def main():
    source, folder = sys.argv[1:]
    if webdriver is None or not os.access("/usr/bin/chromium", os.X_OK) or not os.access("/usr/bin/chromedriver", os.X_OK):
        print("operator_page_faults: Chromium, its driver or python3-selenium is not installed (tools/install-dependencies --checks)")
        return 77
    shutil.rmtree(folder, ignore_errors=True)
    os.makedirs(folder)
    Handler.page = source
    server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), Handler)
    server.daemon_threads = True
    threading.Thread(target=server.serve_forever, daemon=True).start()
    page = Page(f"http://127.0.0.1:{server.server_address[1]}/", folder)
    failed = 0
    try:
        for check, more in ((check_server_started_anew, ()), (check_busy_server, ()), (check_time_of_a_press, ()),
                            (check_silent_socket, ()), (check_camera_after_loss, ()),
                            (check_second_press, ()),
                            (check_resume_only_where_it_can_be_done, ()),
                            (check_resume_from_the_place_that_was_confirmed, ()), (check_resume_in_a_low_window, ()),
                            (check_confirmed_place_with_noise, ()), (check_upload_pressed_twice, (folder,)),
                            (check_mesh_fields, (folder,)), (check_old_figures, ()),
                            (check_clock_set_back, ())):
            Handler.cell = Cell()
            try:
                check(page, Handler.cell, *more)
            except AssertionError as error:
                failed += 1
                print(f"operator_page_faults: {check.__name__}: {error}", file=sys.stderr)
    finally:
        page.browser.quit()
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
