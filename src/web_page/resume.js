// The steps of a resume: each is proven by the machine, waited for, or confirmed by who has looked.
import { byId, element, focusOn, setText, syncRows } from "/page/elements.js";
import { texts } from "/page/texts.js";

let shown = []; // steps, as the cell said last
let confirmed = new Map(); // by name: the step as it was confirmed
let isRefused = false; // whether Start was pressed too early: what comes first is said until something is confirmed

const samePlace = 0.5; // mm of bead: what a robot at rest reports varies less, and the unit compares by it too
const worded = (text) => text.replace(/\d+(\.\d+)?/g, "#");

// A place that has become another one is to be looked at again; temperatures may change.
function isSame(seen, step) {
  if (seen.state !== step.state) return false;
  if (step.name !== "place" || seen.text === step.text) return true;
  return Number.isFinite(seen.begin_mm) && Number.isFinite(step.begin_mm) && worded(seen.text) === worded(step.text) &&
    Math.abs(seen.begin_mm - step.begin_mm) <= samePlace;
}
const isConfirmed = (step) => step.state === "person" && confirmed.has(step.name) && isSame(confirmed.get(step.name), step);
const isThere = (step) => step.state === "done" || isConfirmed(step);
const open = () => shown.find((step) => !isThere(step));

function confirm(name, isChecked) {
  const step = shown.find((each) => each.name === name);
  if (step && isChecked) confirmed.set(name, { ...step });
  else confirmed.delete(name);
  isRefused = false;
  show();
}

function makeRow({ name }) {
  const box = element("input", { type: "checkbox", id: `resume-${name}`, "aria-describedby": `resume-text-${name}`,
    onchange: (event) => confirm(name, event.target.checked) });
  return element("li", {},
    element("h3", {}, texts.resume_steps[name] ?? name), element("strong", { class: "step-state" }),
    element("p", { id: `resume-text-${name}` }),
    element("label", { for: `resume-${name}` }, box, element("span", {}, texts.resume_confirm[name] ?? texts.confirm)));
}

function updateRow(row, step) {
  const [, mark, text, label] = row.children;
  row.dataset.state = isThere(step) ? "done" : step.state;
  setText(mark, isConfirmed(step) ? texts.resume_states.confirmed : texts.resume_states[step.state]);
  setText(text, step.text);
  label.hidden = step.state !== "person";
  label.firstChild.checked = isConfirmed(step);
}

function show() {
  syncRows(byId("resume-steps"), shown, (step) => step.name, makeRow, updateRow);
  const step = open();
  byId("resume-start").setAttribute("aria-disabled", String(Boolean(step) || !shown.length));
  const left = shown.filter((each) => !isThere(each)).length;
  const isDue = step || !shown.length;
  const what = isRefused && step ? texts.resume_first(texts.resume_steps[step.name] ?? step.name) : texts.resume_left(left);
  setText(byId("resume-left"), isDue ? what : texts.resume_ready);
}

/** What the cell says of the steps now. */
export function showResume(unit) {
  shown = (unit.resume_waits && unit.resume_steps) || [];
  for (const [name, seen] of confirmed) {
    const step = shown.find((each) => each.name === name);
    if (!step || !isSame(seen, step)) confirmed.delete(name); // to be looked at anew
  }
  if (byId("resume").open) show();
}

/** What keeps a press of Start from starting is said, and gets the focus. */
function start() {
  const step = open();
  if (!step && shown.length) return byId("resume").close("resume");
  isRefused = true;
  show();
  if (step?.state === "person") byId(`resume-${step.name}`).focus();
  return undefined;
}

export function wireResume() {
  byId("resume-back").addEventListener("click", () => byId("resume").close(""));
  byId("resume-discard").addEventListener("click", () => byId("resume").close("discard"));
  byId("resume-start").addEventListener("click", start);
}

/** @returns "resume", with the names of what was confirmed and where the job then begins; "discard"; or "" for going back */
export function walkThrough(job) {
  const dialog = byId("resume");
  if (dialog.open) return Promise.resolve({ choice: "", confirmed: [] });
  const opener = document.activeElement;
  confirmed = new Map();
  isRefused = false;
  setText(byId("resume-text"), texts.resume_text(job));
  show();
  dialog.returnValue = "";
  dialog.showModal();
  byId("resume-back").focus();
  return new Promise((resolve) => {
    dialog.addEventListener("close", () => {
      if (document.activeElement === document.body) {
        if (opener && opener.isConnected) opener.focus();
        else focusOn(byId("commands"));
      }
      resolve({ choice: dialog.returnValue, confirmed: [...confirmed.keys()], begin: confirmed.get("place")?.begin_mm ?? null });
    }, { once: true });
  });
}
