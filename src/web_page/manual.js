// Moving the machine by hand: the lease, and buttons that step while they are held.
import { post } from "/page/api.js";
import { byId, element, setText, syncRows } from "/page/elements.js";
import { texts } from "/page/texts.js";

const manualMode = 3;
const stepTime = 0.25; // s: a step that no other follows has ended by then
const repeat = 250; // ms
const tipAxes = ["x", "y", "z", "rx", "ry", "rz"];

let lease = 0;
let held = null; // the step of the button that is held
let isSending = false;
let joints = [];

const tell = (text) => { byId("manual-answer").textContent = text; };

async function order(body) {
  try {
    const answer = await post("/api/v1/manual", { lease, ...body });
    lease = answer.lease;
    tell("");
    return true;
  } catch (error) {
    held = null; // whoever holds the button presses it again
    tell(error.status ? error.message : texts.no_link);
    return false;
  }
}

async function stepWhileHeld() {
  if (isSending) return;
  isSending = true;
  while (held) {
    const began = Date.now();
    if (!await order({ request: "step", ...held })) break;
    await new Promise((resolve) => setTimeout(resolve, Math.max(0, repeat - (Date.now() - began))));
  }
  isSending = false;
}

function stepOf(axis, isTurn, sign) {
  const size = Number(byId("manual-step").value); // mm or degrees
  const step = sign * (isTurn ? size * Math.PI / 180 : size / 1000);
  return { frame: byId("manual-frame").value, axis, step, speed: Math.abs(step) / stepTime };
}

/** Once for a press, and on while it is held, by pointer or by key; once for the click of a screen reader. */
function stepButton(axis, isTurn, sign) {
  const letGo = () => { held = null; };
  const press = () => {
    held = stepOf(axis, isTurn, sign);
    stepWhileHeld();
  };
  const isStepKey = (event) => event.key === " " || event.key === "Enter";
  return element("button", {
    type: "button",
    "aria-label": texts.manual_button(axis, sign),
    onpointerdown: press,
    onpointerup: letGo,
    onpointerleave: letGo,
    onpointercancel: letGo,
    onblur: letGo,
    onkeydown: (event) => {
      if (!isStepKey(event)) return;
      event.preventDefault();
      if (!event.repeat) press();
    },
    onkeyup: (event) => {
      if (!isStepKey(event)) return;
      event.preventDefault();
      letGo();
    },
    onclick: (event) => event.detail === 0 && order({ request: "step", ...stepOf(axis, isTurn, sign) }),
  }, sign > 0 ? "+" : "−");
}

function showAxes() {
  const frame = byId("manual-frame").value;
  const axes = frame === "joints" ? joints.map((joint) => ({ name: joint.name, isTurn: !joint.is_linear }))
    : tipAxes.map((name) => ({ name, isTurn: name.length > 1 }));
  syncRows(byId("manual-axes"), axes, (axis) => `${frame} ${axis.name}`,
    (axis) => element("li", { class: "line" }, element("span", {}, axis.name),
      stepButton(axis.name, axis.isTurn, -1), stepButton(axis.name, axis.isTurn, 1)),
    () => {});
}

export function wireManual() {
  byId("manual-take").addEventListener("click", () => order({ request: "take" }));
  byId("manual-release").addEventListener("click", () => order({ request: "release" }));
  byId("manual-frame").addEventListener("change", showAxes);
  for (const gone of ["blur", "pagehide"]) window.addEventListener(gone, () => { held = null; });
  document.addEventListener("visibilitychange", () => { if (document.hidden) held = null; });
}

export function showManual(state, rights) {
  const isThere = rights.maintain && state.unit.mode === manualMode && state.manual !== null;
  byId("manual").hidden = !isThere;
  if (!isThere) {
    held = null;
    return;
  }
  const manual = state.manual;
  joints = manual.joints;
  setText(byId("manual-state"), texts.manual_state(manual));
  showAxes();
}
