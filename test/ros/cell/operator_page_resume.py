#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The Lamina authors
# SPDX-License-Identifier: BSD-3-Clause
"""Resumes a job that was cut off by the page, in headless Chromium, with the keyboard alone.

Usage: operator_page_resume.py URL FOLDER   exits 1 and says what was not so

The unit is in Aborted, its streamer there again. Acknowledges, clears, resets, and goes through the steps: Start waits for all of
them, says which comes first, and has what was confirmed. With LAMINA_PICTURES, pictures of the steps are left in that folder.
"""
import os
import sys
import time

from operator_page_browser import CONTRAST, SETTLING, Page, require
from selenium.webdriver.common.keys import Keys

STEPS = ("link", "place", "part", "ready", "way")


def picture(page, name):
    folder = os.environ.get("LAMINA_PICTURES")
    if folder:
        page.browser.save_screenshot(f"{folder}/{name}.png")


def states(page):
    return page.script("return [...document.querySelectorAll('#resume-steps li')].map((row) => row.dataset.state)")


def recover(page):
    page.state("Aborted")
    find = "return [...document.querySelectorAll('#alarm-list button:not([hidden])')].map((b) => b.ariaLabel)"
    page.wait(lambda: page.script(find), "alarms to acknowledge")
    while names := [name for name in page.script(find) if name]:
        page.do(names[0])
        page.wait(lambda: names[0] not in page.script(find), f"{names[0]} done")
    until = time.monotonic() + 60
    while page.text("#state-name") == "Aborted" and time.monotonic() < until:
        page.do_next("Clear")  # refused until the streamer was heard of again
        time.sleep(0.5)
    page.state("Stopped")
    page.do_next("Reset")
    page.state("Idle")


def look_at(page, scheme, name):
    page.browser.execute_cdp_cmd("Emulation.setEmulatedMedia", {"features": [{"name": "prefers-color-scheme", "value": scheme}]})
    count, faults = page.script(CONTRAST)
    require(count and not faults, f"contrast in {scheme}: {faults}")
    picture(page, f"{name}_{scheme}")


def walk(page):
    page.do_next("Start")
    page.wait(lambda: page.script("return document.getElementById('resume').open"), "the steps")
    require(page.focused() == "Go back", f"the focus is on '{page.focused()}'")
    page.wait(lambda: states(page) == ["done", "done", "person", "person", "person"], "what the machine proves")
    names = page.script("return [...document.querySelectorAll('#resume-steps h3')].map((h) => h.innerText)")
    require(names == ["Link to the machine", "Place on the part", "Part on the plate", "Heat and process", "Way to the bead"], f"steps {names}")
    require("each is run once" in page.text("#resume-steps"), "what is known of the place is not told")
    look_at(page, "dark", "resume_steps")
    look_at(page, "light", "resume_steps")
    page.do("Start")
    require(page.text("#resume-left") == "First: Part on the plate.", f"Start says '{page.text('#resume-left')}'")
    require(page.focused() == "The part stands where it stood", f"the focus went to '{page.focused()}'")
    require(page.text("#state-name") == "Idle", "it started without its steps")
    for name in ("The part stands where it stood", "Heat and process are ready", "The way is free"):
        page.go_to(name)
        page.press(Keys.SPACE)
    require(states(page) == ["done"] * 5, f"after all was confirmed {states(page)}")
    require(page.text("#resume-left") == "All is confirmed. Start resumes the job.", page.text("#resume-left"))
    page.press(Keys.SPACE)
    require(page.text("#resume-left") == "One step is left.", "what was confirmed cannot be taken back")
    page.press(Keys.SPACE)
    look_at(page, "light", "resume_confirmed")
    small = page.script("return [...document.querySelectorAll('#resume button, #resume label:not([hidden])')]"
                        ".filter((e) => e.getBoundingClientRect().height < 44).map((e) => e.innerText)")
    require(not small, f"too small for a finger: {small}")
    telephone = {"width": 360, "height": 740, "deviceScaleFactor": 1, "mobile": True}
    page.browser.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", telephone)
    wide = page.script("const d = document.getElementById('resume'); return d.scrollWidth > d.clientWidth + 1")
    picture(page, "resume_telephone")
    page.browser.execute_cdp_cmd("Emulation.clearDeviceMetricsOverride", {})
    require(not wide, "the steps are wider than a telephone")


def leave_and_start(page):
    page.press(Keys.ESCAPE)
    require(page.focused() == "Start", f"the focus went to '{page.focused()}', not back to Start")
    time.sleep(SETTLING)
    page.do("Start")
    page.wait(lambda: states(page) == ["done", "done", "person", "person", "person"], "the steps anew, nothing confirmed")
    for name in ("The part stands where it stood", "Heat and process are ready", "The way is free"):
        page.go_to(name)
        page.press(Keys.SPACE)
    page.do("Start")
    page.wait(lambda: page.text("#state-name") in ("Starting", "Printing"), "the job resumed")
    page.state("Printing")


def main():
    url, folder = sys.argv[1:]
    page = Page(url, folder)
    try:
        recover(page)
        walk(page)
        leave_and_start(page)
    except AssertionError as error:
        print(f"operator_page_resume: {error}", file=sys.stderr)
        page.browser.save_screenshot(f"{os.environ.get('LAMINA_PICTURES', folder)}/failed.png")
        return 1
    finally:
        page.browser.quit()
    return 0


if __name__ == "__main__":
    sys.exit(main())
