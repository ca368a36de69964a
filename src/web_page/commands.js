// Hold, the next step, Stop and Abort.
import { post } from "/page/api.js";
import { ask } from "/page/dialogs.js";
import { byId, setText } from "/page/elements.js";
import { showResume, walkThrough, wireResume } from "/page/resume.js";
import { texts } from "/page/texts.js";

// A second press, or one that was meant for what the button said before, is no order to go on from there.
const settling = 700; // ms

let state = null;
let offered = null;
let offeredSince = 0; // ms

function tell(text) {
  // Guards come as one text; each is a line of its own.
  byId("command-answer").textContent = text.replaceAll("; ", ";\n");
}

async function give(command, more = {}) {
  tell("");
  try {
    await post("/api/v1/commands", { command, ...more });
    tell(texts.done(command));
  } catch (error) {
    tell(error.code === "stale_sequence" ? texts.stale_command : error.status ? error.message : texts.no_link);
  }
}

const jobName = () => state?.job?.name ?? texts.this_job;
const sequence = () => ({ if_sequence: state.unit.sequence });

async function next() {
  const step = state && texts.next[state.unit.state];
  if (!step) return;
  if (Date.now() - offeredSince < settling) return tell(texts.just_changed(step[1]));
  const [command] = step;
  const seen = sequence();
  if (command !== "Start" || !state.unit.resume_waits) return give(command, seen);
  // What stands against it is shown by the step of the place, which waits for it.
  const { choice, confirmed, begin } = await walkThrough(jobName());
  const looked = choice === "resume" && { confirmed, confirmed_begin_mm: begin };
  if (choice) await give("Start", { ...seen, cut_off: choice, ...looked });
  return undefined;
}

async function stop() {
  const text = state?.job ? texts.stop_text(jobName()) : texts.stop_idle;
  const answers = [{ value: "yes", label: texts.stop, kind: "stop" }];
  if (await ask({ title: texts.stop_title, text: `${text} ${texts.not_emergency}`, answers })) await give("Stop");
}

async function abort() {
  const answers = [{ value: "yes", label: texts.abort, kind: "abort" }];
  const text = `${texts.abort_text(jobName())} ${texts.not_emergency}`;
  if (await ask({ title: texts.abort_title, text, answers })) await give("Abort");
}

export function wireCommands() {
  wireResume();
  byId("hold").addEventListener("click", () => give("Hold"));
  byId("next").addEventListener("click", next);
  byId("stop").addEventListener("click", stop);
  byId("abort").addEventListener("click", abort);
  byId("removal").addEventListener("click", () => {
    post("/api/v1/removal").then(() => byId("commands").focus({ preventScroll: true })).catch((error) => tell(error.message));
  });
}

export function showCommands(shown, rights) {
  state = shown;
  showResume(shown.unit);
  const step = texts.next[shown.unit.state];
  const word = step ? step[1] : "";
  if (offered !== null && offered !== word) offeredSince = Date.now();
  offered = word;
  const button = byId("next");
  setText(button, step ? step[1] : texts.no_next);
  // Not `disabled`, which would drop the focus: what is not accepted is answered with its reason.
  button.setAttribute("aria-disabled", String(!step || !shown.unit.accepted_now.includes(step[0])));
  button.hidden = byId("stop").hidden = byId("abort").hidden = !rights.operate;
  byId("hold").hidden = !rights.hold;
  // It is pressed whatever the state: only its weight follows what is accepted.
  byId("hold").classList.toggle("rests", !shown.unit.accepted_now.includes("Hold"));
  byId("plate").hidden = !shown.unit.is_part_on_plate || !rights.operate;
}
