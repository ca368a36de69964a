#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The Lamina authors
# SPDX-License-Identifier: BSD-3-Clause
"""Operates a cell by its page, in headless Chromium, with the keyboard alone.

Usage: operator_page_browser.py URL PROGRAM FOLDER PAGE_PROCESS   exits 1 and says what was not so

Uploads PROGRAM, releases it, starts, holds, goes on, aborts, acknowledges, clears. Names and roles of all controls, contrast in
light and dark, sizes on a telephone, and that nothing is asked of another host are looked at on the way; then PAGE_PROCESS is
stopped for a while, which the page has to say.
"""
import contextlib
import os
import signal
import sys
import time

from selenium import webdriver
from selenium.webdriver.chrome.options import Options
from selenium.webdriver.chrome.service import Service
from selenium.webdriver.common.action_chains import ActionChains
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys

PATIENCE = 120  # s: far above what anything takes, for loaded machines
SETTLING = 0.8  # s: commands.js ignores presses for 0.7 s after the button has changed
FLAGS = ("--headless=new", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking",
         "--disable-component-update", "--disable-sync", "--disable-dev-shm-usage", "--window-size=1280,900")

# The contrast of all texts that are seen, with the place of those below what WCAG 2.2 asks for.
CONTRAST = r"""
const channel = (value) => { const part = value / 255; return part <= 0.04045 ? part / 12.92 : ((part + 0.055) / 1.055) ** 2.4; };
const luminance = ([r, g, b]) => 0.2126 * channel(r) + 0.7152 * channel(g) + 0.0722 * channel(b);
const parsed = (text) => (text.match(/[\d.]+/g) || []).map(Number);
const ground = (element) => {
  for (let at = element; at; at = at.parentElement) {
    const [r, g, b, a = 1] = parsed(getComputedStyle(at).backgroundColor);
    if (a === 1 && r !== undefined) return [r, g, b];
  }
  return matchMedia("(prefers-color-scheme: dark)").matches ? [18, 18, 18] : [255, 255, 255];
};
const faults = [];
let count = 0;
const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
while (walker.nextNode()) {
  const element = walker.currentNode.parentElement;
  const style = getComputedStyle(element);
  const box = element.getBoundingClientRect();
  if (!walker.currentNode.textContent.trim() || !box.width || style.visibility === "hidden" || element.closest(".unseen, .skip")) continue;
  const [text, back] = [luminance(parsed(style.color)), luminance(ground(element))];
  const ratio = (Math.max(text, back) + 0.05) / (Math.min(text, back) + 0.05);
  count += 1;
  if (ratio < 4.5) faults.push(`${element.tagName} "${walker.currentNode.textContent.trim().slice(0, 40)}": ${ratio.toFixed(2)}`);
}
return [count, faults];
"""


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
        self.browser.get(url)

    def wait(self, is_so, what):
        until = time.monotonic() + PATIENCE
        while time.monotonic() < until:
            if is_so():
                return
            time.sleep(0.05)
        raise AssertionError(f"not in {PATIENCE} s: {what}; the page says: {self.text('body')[:1500]}")

    def text(self, selector):
        return self.browser.execute_script("return document.querySelector(arguments[0])?.innerText ?? ''", selector)

    def state(self, name):
        self.wait(lambda: self.text("#state-name") == name, f"state {name}")

    def press(self, *keys):
        ActionChains(self.browser).send_keys(*keys).perform()

    def focused(self):
        """The name by which a screen reader calls what has the focus."""
        return self.browser.switch_to.active_element.accessible_name

    def go_to(self, name):
        """Moves the focus on, in reading order, until it is on a control."""
        seen = []
        for _ in range(120):
            seen.append(self.focused())
            if seen[-1] == name:
                outline = self.browser.execute_script("return getComputedStyle(document.activeElement).outlineStyle")
                require(outline != "none" or name == "", f"the focus on '{name}' is not seen")
                return
            self.press(Keys.TAB)
        raise AssertionError(f"the keyboard does not reach '{name}'; it went over {seen}")

    def do(self, name):
        self.go_to(name)
        self.press(Keys.ENTER)

    def do_next(self, name):
        """Presses the button that changes its word, once it has had this one for as long as the page asks for."""
        self.wait(lambda: self.text("#next") == name, f"{name} is offered")
        time.sleep(SETTLING)
        self.do(name)

    def script(self, text, *arguments):
        return self.browser.execute_script(text, *arguments)


def check_names(page):
    """Each control has a role and a name in the accessibility tree."""
    nodes = page.browser.execute_cdp_cmd("Accessibility.getFullAXTree", {})["nodes"]
    controls = {"button", "textbox", "searchbox", "combobox", "slider", "checkbox", "link", "progressbar", "img", "image", "dialog", "table"}
    found = [(node["role"]["value"], node.get("name", {}).get("value", "")) for node in nodes
             if not node["ignored"] and node["role"]["value"] in controls]
    require(len(found) > 10, f"only {len(found)} controls: {found}")
    unnamed = [role for role, name in found if not name.strip()]
    require(not unnamed, f"controls without a name: {unnamed} of {found}")
    roles = {node["role"]["value"] for node in nodes if not node["ignored"]}
    require({"banner", "main", "contentinfo", "heading", "region"} <= roles, f"landmarks are missing among {sorted(roles)}")


def check_contrast(page):
    for scheme in ("dark", "light"):
        page.browser.execute_cdp_cmd("Emulation.setEmulatedMedia", {"features": [{"name": "prefers-color-scheme", "value": scheme}]})
        count, faults = page.script(CONTRAST)
        require(count > 20 and not faults, f"contrast below 4.5 of {count} texts in {scheme}: {faults}")


def check_telephone(page):
    """On a narrow screen nothing runs out of it, and what is pressed is large enough for a finger."""
    page.browser.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", {"width": 360, "height": 740, "deviceScaleFactor": 2, "mobile": True})
    width = page.script("return document.documentElement.scrollWidth")
    beyond = page.script("""return [...document.querySelectorAll("body *")].filter((e) => e.getBoundingClientRect().right > 360.5)
        .map((e) => `${e.tagName} ${e.id || e.className} to ${e.getBoundingClientRect().right}`).slice(0, 10)""")
    require(width <= 360, f"the page is {width} px wide on a screen of 360: {beyond}")
    small = page.script("""return [...document.querySelectorAll("button, select, input:not([type=checkbox])")]
        .map((e) => [e.innerText || e.id, e.getBoundingClientRect()])
        .filter(([, b]) => b.width > 0 && (b.height < 44 || b.width < 44)).map(([name, b]) => `${name} ${b.width} x ${b.height}`)""")
    require(not small, f"too small for a finger: {small}")
    hold = page.script("return document.getElementById('hold').getBoundingClientRect().bottom")
    require(hold <= 740, "Hold is not in view")
    page.browser.execute_cdp_cmd("Emulation.clearDeviceMetricsOverride", {})


def check_dialog(page, opener):
    """The focus is on the way back, stays within, and returns."""
    page.do(opener)
    page.wait(lambda: page.focused() == "Go back", "the focus on Go back")
    for _ in range(5):
        page.press(Keys.TAB)
        require(page.script("return document.getElementById('dialog').contains(document.activeElement) || document.activeElement === document.body"),
                f"the focus left the dialog for '{page.focused()}'")
    page.press(Keys.ESCAPE)
    require(not page.script("return document.getElementById('dialog').open"), "Escape does not leave the dialog")
    require(page.focused() == opener, f"the focus went to '{page.focused()}', not back to '{opener}'")


def answer(page, opener, choice):
    page.do(opener)
    page.wait(lambda: page.focused() == "Go back", "the focus on Go back")
    page.press(Keys.TAB)
    require(page.focused() == choice, f"after Go back comes '{page.focused()}', not '{choice}'")
    page.press(Keys.ENTER)


def operate(page, program):
    name = os.path.basename(program)
    page.state("Stopped")
    check_names(page)
    page.go_to("Program (G-code) or mesh")
    page.browser.find_element(By.ID, "program").send_keys(program)
    page.do("Upload")
    page.wait(lambda: f"Release: {name}" in page.script("return [...document.querySelectorAll('#job-list button')].map((b) => b.ariaLabel)"), "a job")
    page.do(f"Release: {name}")
    page.wait(lambda: "released by" in page.text("#job-list"), "the job released")
    page.do_next("Reset")
    page.state("Idle")
    page.wait(lambda: page.text("#next") == "Start", "Start is offered")
    time.sleep(SETTLING)
    until = time.monotonic() + PATIENCE
    while page.text("#state-name") not in ("Starting", "Printing") and time.monotonic() < until:
        if page.text("#next") == "Start":
            with contextlib.suppress(AssertionError):  # the button may become another on the way to it
                page.do("Start")  # refused until the streamer was heard of
        time.sleep(0.5)
    page.state("Printing")
    page.do("Hold")
    page.state("Held")
    check_contrast(page)
    check_telephone(page)
    page.do_next("Unhold")
    page.state("Printing")
    check_dialog(page, "Stop")
    check_dialog(page, "Abort")
    answer(page, "Abort", "Abort")
    page.state("Aborted")
    page.wait(lambda: "1002" in page.text("#alarm-list"), "alarm 1002")
    check_contrast(page)
    page.do("Acknowledge alarm 1002")
    page.wait(lambda: "Acknowledge alarm 1002" not in page.script(
        "return [...document.querySelectorAll('#alarm-list button:not([hidden])')].map((b) => b.ariaLabel)"), "the alarm acknowledged")
    page.do_next("Clear")
    page.state("Stopped")
    print_again(page, name)
    switch_plc(page)


def print_again(page, name):
    """The part of the aborted job is listed, and its program is queued once more."""
    page.wait(lambda: "aborted" in page.text("#record-list"), "the part among those that were made")
    page.do(f"Print again: {name}")
    page.wait(lambda: f"Release: {name}" in page.script(
        "return [...document.querySelectorAll('#job-list button:not([hidden])')].map((b) => b.ariaLabel)"), "the job once more")


def switch_plc(page):
    before = page.text("#plc-access")
    page.do(page.text("#plc-switch"))
    page.wait(lambda: page.text("#plc-access") != before, "the PLC's access changed")
    page.do(page.text("#plc-switch"))
    page.wait(lambda: page.text("#plc-access") == before, "the PLC's access as it was")


def check_stale(page, process):
    os.kill(process, signal.SIGSTOP)
    try:
        begin = time.monotonic()
        page.wait(lambda: "Link lost since" in page.text("#stale"), "the page says that its link is lost")
        require(time.monotonic() - begin > 1.0, "the link was lost before it was")
        require(page.script("return getComputedStyle(document.getElementById('state')).filter") == "grayscale(1)", "old values are not grey")
    finally:
        os.kill(process, signal.SIGCONT)
    page.wait(lambda: not page.script("return document.body.classList.contains('stale')"), "the page has its link again")


def main():
    url, program, folder, process = sys.argv[1:]
    page = Page(url, folder)
    try:
        operate(page, program)
        check_stale(page, int(process))
        outside = page.script("return performance.getEntriesByType('resource').map((e) => e.name).filter((n) => !n.startsWith(location.origin))")
        require(not outside, f"asked of other hosts: {outside}")
        faults = [line["message"] for line in page.browser.get_log("browser") if "409" not in line["message"] and "404" not in line["message"]]
        require(not faults, f"the browser says: {faults}")
    except AssertionError as error:
        print(f"operator_page_browser: {error}", file=sys.stderr)
        page.browser.save_screenshot(f"{folder}/failed.png")
        return 1
    finally:
        page.browser.quit()
    return 0


if __name__ == "__main__":
    sys.exit(main())
