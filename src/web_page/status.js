// What the unit is at: state, job, alarms, start-up, log.
import { get, post } from "/page/api.js";
import { byId, dayOf, dayTime, duration, element, setFacts, setText, syncRows } from "/page/elements.js";
import { texts } from "/page/texts.js";

const symbols = {
  Execute: "▶", Starting: "▶", Unholding: "▶", Unsuspending: "▶", Completing: "▶",
  Held: "❚❚", Holding: "❚❚", Suspended: "❚❚", Suspending: "❚❚",
  Aborted: "✖", Aborting: "✖", Stopped: "■", Stopping: "■", Idle: "●", Complete: "✔", Resetting: "↻", Clearing: "↻",
};
const kinds = {
  Execute: "run", Starting: "run", Unholding: "run", Unsuspending: "run", Completing: "run", Complete: "run",
  Held: "wait", Holding: "wait", Suspended: "wait", Suspending: "wait", Stopping: "wait", Stopped: "rest",
  Idle: "rest", Resetting: "rest", Clearing: "rest", Aborted: "fault", Aborting: "fault",
};
const politeInterval = 5000; // ms

let saidPolitely = 0;
let saidState = "";
let knownAlarms = null;

function leftText(left) {
  if (!left) return texts.unknown;
  return texts.about(duration(left.seconds), duration(left.least_s), duration(left.most_s));
}

/** What becomes of a job that was cut off, once the unit is at rest. */
function cutOffHint(unit) {
  if (!unit.resume_waits || !["Stopped", "Idle"].includes(unit.state)) return "";
  const refusal = unit.resume_refusal;
  if (!refusal) return texts.can_resume;
  // Of what never goes by, as motions that are lost, the unit says that the job is to be discarded.
  return /discard (the|its) job/.test(refusal) ? texts.cannot_resume(refusal) : texts.resume_waits(refusal);
}

export function showState(state, layers) {
  const { unit, job, progress } = state;
  document.body.dataset.kind = kinds[unit.state] ?? "rest";
  setText(byId("state-symbol"), symbols[unit.state] ?? "●");
  setText(byId("state-name"), texts.states[unit.state] ?? unit.state);
  const wait = unit.state === "Held" ? state.machine?.failure : cutOffHint(unit);
  setText(byId("state-detail"), unit.stop_reason?.message || wait || (texts.state_hints[unit.state] ?? ""));
  const facts = [
    [texts.fact_job, job ? job.name : texts.none],
    [texts.fact_layer, progress.layer < 0 ? texts.none : texts.layer_of(progress.layer + 1, layers)],
    [texts.fact_left, job ? leftText(progress.left) : texts.none],
  ];
  if (job && progress.material_m3 > 0)
    facts.push([texts.fact_material, texts.laid(progress.laid_m.toFixed(2), (progress.material_m3 * 1e6).toFixed(1))]);
  if (state.loop) facts.push([texts.fact_loop, state.loop.state]);
  facts.push([texts.fact_mode, unit.mode], [texts.fact_in_state, duration(unit.in_state_s)]);
  setFacts(byId("facts"), facts);
  byId("progress").value = progress.fraction;
  byId("progress").hidden = !job;
  setText(byId("progress-label"),
    job ? texts.lines_done(progress.lines_acknowledged, progress.lines, Math.floor(progress.fraction * 100)) : "");
  sayPolitely(unit.state, job);
}

/** Reports a new state to a screen reader, at most every five seconds. */
function sayPolitely(state, job) {
  const text = `${texts.states[state] ?? state}${job ? `, ${job.name}` : ""}`;
  const now = Date.now();
  if (text === saidState || now - saidPolitely < politeInterval) return;
  saidState = text;
  saidPolitely = now;
  byId("polite").textContent = text;
}

export function showAlarms(alarms, mayAcknowledge) {
  const list = byId("alarm-list");
  byId("alarms").classList.toggle("has-alarms", alarms.some((alarm) => !["I", "W"].includes(alarm.category)));
  syncRows(list, alarms.length ? alarms : [{ id: 0 }], (alarm) => alarm.id,
    (alarm) => alarm.id === 0 ? element("li", { class: "muted" }, texts.no_alarms) : alarmRow(alarm),
    (row, alarm) => alarm.id && updateAlarm(row, alarm, mayAcknowledge));
  const fresh = alarms.filter((alarm) => knownAlarms && !knownAlarms.has(alarm.id));
  if (fresh.length) byId("assertive").textContent = fresh.map((alarm) => `${alarm.title}: ${alarm.message}`).join(". ");
  knownAlarms = new Set(alarms.map((alarm) => alarm.id));
}

function alarmRow(alarm) {
  return element("li", { class: "alarm" },
    element("div", {},
      element("p", { class: "alarm-title" }), element("p"), element("p", { class: "remedy" }), element("p", { class: "muted" })),
    element("button", {
      type: "button", "aria-label": texts.acknowledge_of(alarm.id),
      onclick: () => post(`/api/v1/alarms/${alarm.id}/acknowledge`).catch((error) => {
        byId("command-answer").textContent = error.message;
      }),
    }, texts.acknowledge));
}

function updateAlarm(row, alarm, mayAcknowledge) {
  const [title, message, remedy, detail] = row.firstChild.children;
  row.dataset.category = alarm.category;
  setText(title, `${alarm.category} ${alarm.id} ${alarm.title}`);
  setText(message, alarm.message);
  setText(remedy, alarm.remedy);
  const details = [alarm.is_gone ? texts.alarm_gone : texts.alarm_active];
  if (alarm.is_acknowledged) details.push(texts.alarm_acknowledged(alarm.acknowledged_by));
  if (alarm.times > 1) details.push(texts.alarm_times(alarm.times));
  setText(detail, details.join(", "));
  row.lastChild.hidden = alarm.is_acknowledged || !mayAcknowledge;
}

async function startupCommand(command, step = "") {
  try {
    const answer = await post("/api/v1/startup", { command, step });
    byId("startup-answer").textContent = answer.message;
  } catch (error) {
    byId("startup-answer").textContent = error.message;
  }
}

export function wireStartup() {
  byId("run-startup").addEventListener("click", () => startupCommand("run"));
  byId("abort-startup").addEventListener("click", () => startupCommand("abort"));
}

export function showStartup(steps, mayOperate) {
  byId("startup").hidden = steps.length === 0;
  byId("run-startup").hidden = byId("abort-startup").hidden = !mayOperate;
  syncRows(byId("step-list"), steps, (step) => step.name,
    (step) => element("li", { class: "step" },
      element("div", {}, element("p", { class: "step-title" }), element("p", { class: "muted" })),
      element("button", {
        type: "button", "aria-label": texts.confirm_of(step.name), onclick: () => startupCommand("confirm", step.name),
      }, texts.confirm)),
    (row, step) => {
      const name = step.name.replaceAll("_", " ");
      const measured = step.value === null ? "" : `${Number(step.value.toPrecision(4))} ${step.unit}`;
      const expected = step.expected ? texts.step_expected(step.expected) : "";
      row.dataset.state = step.state;
      setText(row.firstChild.firstChild,
        [`${name}: ${texts.step_states[step.state.toUpperCase()] ?? step.state}`, measured, expected].filter(Boolean).join(", "));
      setText(row.firstChild.lastChild, step.reason);
      row.lastChild.hidden = !mayOperate || ["DONE", "SKIPPED"].includes(step.state.toUpperCase());
    });
}

// The log.

let lastEvent = 0;
let events = [];
let drawnOn = "";

export function wireLog() {
  byId("log-kind").append(...Object.entries(texts.log_kinds).map(([kind, name]) => element("option", { value: kind }, name)));
  byId("log-kind").addEventListener("change", drawLog);
  byId("log-filter").addEventListener("input", drawLog);
}

export function forgetLog() {
  lastEvent = 0;
  events = [];
}

export function takeEvents(fresh) {
  // A server that was started anew counts from one again.
  if (fresh.length && fresh[fresh.length - 1].number < lastEvent) forgetLog();
  const more = fresh.filter((event) => event.number > lastEvent);
  if (!more.length && drawnOn === dayOf(Date.now() / 1000)) return;
  events = [...events, ...more].slice(-500);
  lastEvent = events.length ? events[events.length - 1].number : 0;
  drawLog();
}

function drawLog() {
  drawnOn = dayOf(Date.now() / 1000);
  const kind = byId("log-kind").value;
  const part = byId("log-filter").value.toLowerCase();
  const shown = events.filter((event) => (!kind || event.kind === kind) && event.text.toLowerCase().includes(part)).reverse();
  syncRows(byId("event-list"), shown.slice(0, 200), (event) => event.number,
    (event) => element("li", {}, element("time"), element("span", {}, event.text)),
    (row, event) => setText(row.firstChild, dayTime(event.utc_s)));
}

export async function history(from) {
  return get(`/api/v1/history?from=${Math.max(0, Math.floor(from))}`);
}
