// The page: who is logged in, the link, and what is shown of each state that comes.
import { Link, login, remove, session } from "/page/api.js";
import { drawHeat, forgetSamples, lastSample, showHeat, takeSamples } from "/page/charts.js";
import { showCommands, wireCommands } from "/page/commands.js";
import { byId, clockTime, fillTexts, setText } from "/page/elements.js";
import { drawDeviation, drawPreview, layerCount, showLayers, showPreview, wirePreview } from "/page/layers.js";
import { showManual, wireManual } from "/page/manual.js";
import { showQueue, showRequests, wireUpload } from "/page/queue.js";
import { showRecords } from "/page/records.js";
import {
  forgetLog, history, showAlarms, showStartup, showState, takeEvents, wireLog, wireStartup,
} from "/page/status.js";
import { texts } from "/page/texts.js";
import { showTokens, showUnit, wireMaintenance } from "/page/tokens.js";

const staleAfter = 3000; // ms
const historyInterval = 2000; // ms

let link = null;
let state = null;
let heard = 0; // ms, when the last state came
let opened = 0; // the link's connection that it came by
let rights = {};
let asksHistory = false;

function rightsOf(who) {
  const isOperator = ["operator", "maintenance"].includes(who.role);
  return {
    see: who.role !== "sender",
    upload: who.role !== "viewer",
    operate: isOperator,
    hold: isOperator || (who.role === "viewer" && who.is_local),
    maintain: who.role === "maintenance",
  };
}

function onState(next) {
  const wasLost = Date.now() - heard > staleAfter || link.opened !== opened;
  opened = link.opened;
  state = next;
  heard = Date.now();
  showStale();
  setText(byId("notices"), state.notices.join(" "));
  if (!state.unit) return;
  showState(state, layerCount());
  showCommands(state, rights);
  if (!rights.see) return;
  showAlarms(state.alarms, rights.operate);
  showQueue(state.queue, rights);
  showRecords(state, rights.operate, wasLost);
  showRequests(state.key_requests, rights.operate);
  showHeat(state.machine);
  showStartup(state.startup, rights.operate);
  showLayers(state);
  showPreview(state);
  showCamera(state.has_camera, wasLost);
  showUnit(state);
  showManual(state, rights);
}

/** The picture of a link that was lost stands still: it is asked for anew. */
function showCamera(isThere, wasLost) {
  const picture = byId("camera-picture");
  byId("camera").hidden = !isThere;
  if (isThere && (!picture.src || wasLost)) {
    picture.alt = texts.camera_picture;
    picture.src = `/api/v1/camera?${Date.now()}`;
  } else if (!isThere && picture.src) {
    picture.removeAttribute("src");
  }
}

/** What is older than three seconds is greyed out, and says so. */
function showStale() {
  const age = Date.now() - heard;
  const isLate = age > staleAfter;
  const isStale = isLate || !state || !state.is_fresh;
  const note = byId("stale");
  document.body.classList.toggle("stale", isStale);
  note.hidden = !isStale;
  if (!isStale) return setText(note, "");
  if (isLate || !state) {
    const since = heard ? clockTime(heard / 1000) : "…";
    return setText(note, texts.stale_page(since, heard ? Math.round(age / 1000) : 0));
  }
  return setText(note, state.unit ? texts.stale_cell(state.age_s) : texts.never_heard);
}

async function askHistory() {
  if (asksHistory || !rights.see || !state?.unit) return;
  asksHistory = true;
  // Where the clock was set back, what is stamped later than now is from before.
  const latest = state.utc_s + 5;
  if (lastSample() > latest) forgetSamples();
  try {
    const { samples, events } = await history(lastSample() - 30);
    takeSamples(samples.filter((sample) => sample.utc_s <= latest));
    takeEvents(events);
  } catch {
    // The link reports when nobody answers.
  } finally {
    asksHistory = false;
  }
}

function showLogin() {
  link?.close();
  link = null;
  byId("cell").hidden = true;
  byId("login").hidden = false;
  byId("logout").hidden = true;
  setText(byId("who"), "");
  byId("stale").hidden = true;
  byId("token").focus();
}

function showCell(who) {
  rights = rightsOf(who);
  byId("login").hidden = true;
  byId("cell").hidden = false;
  byId("logout").hidden = who.needs_no_token;
  setText(byId("who"), texts.who(who.name, who.role));
  for (const name of ["alarms", "queue", "temperatures", "preview", "log"]) byId(name).hidden = !rights.see;
  if (rights.upload && !rights.see) byId("queue").hidden = false;
  byId("unit").hidden = byId("tokens").hidden = !rights.maintain;
  forgetSamples();
  forgetLog();
  heard = Date.now();
  link = new Link(onState, showLogin);
  if (rights.maintain) showTokens().catch(() => {});
}

function wireLogin() {
  byId("login-form").addEventListener("submit", async (event) => {
    event.preventDefault();
    setText(byId("login-error"), "");
    try {
      const who = await login(byId("token").value);
      byId("token").value = "";
      showCell(who);
      byId("commands").focus({ preventScroll: true });
    } catch (error) {
      setText(byId("login-error"), error.status ? error.message : texts.no_link);
    }
  });
  byId("logout").addEventListener("click", async () => {
    await remove("/api/v1/session").catch(() => {});
    showLogin();
  });
}

function redraw() {
  drawHeat();
  drawPreview();
  drawDeviation();
}

/** Who is logged in, however long the server takes to answer. */
async function known() {
  while (true) {
    try {
      return await session();
    } catch {
      await new Promise((resolve) => setTimeout(resolve, 1000));
    }
  }
}

async function begin() {
  fillTexts();
  wireLogin();
  wireCommands();
  wireUpload();
  wireStartup();
  wireLog();
  wirePreview();
  wireMaintenance();
  wireManual();
  window.addEventListener("resize", redraw);
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", redraw);
  setInterval(() => link && showStale(), 500);
  setInterval(askHistory, historyInterval);
  const who = await known();
  if (who.is_known) showCell(who);
  else showLogin();
}

begin();
