// Parts that were made: their records, and their programs once more.
import { get, post } from "/page/api.js";
import { byId, dayTime, element, setText, syncRows } from "/page/elements.js";
import { texts } from "/page/texts.js";

const longestAge = 30000; // ms: a record may be written a while after its job has ended

let shown = ""; // of the cell, as the list was asked for
let asked = 0; // ms
let isAsking = false;

const tell = (text) => setText(byId("record-answer"), text);

async function printAgain(record) {
  try {
    const made = await post(`/api/v1/jobs/${record.job}/again`);
    tell(texts.uploaded(made.name));
  } catch (error) {
    tell(error.status ? error.message : texts.no_link);
  }
}

async function judge(record, choice) {
  try {
    await post(`/api/v1/jobs/${record.job}/verdict`, { verdict: choice.value });
    shown = ""; // the list is asked for with the next state
  } catch (error) {
    choice.value = record.verdict;
    tell(error.status ? error.message : texts.no_link);
  }
}

/** What a person may say of it; the verdict of the unit stands until then. */
function verdictChoice(record) {
  const known = ["good", "rework", "scrap"];
  const values = known.includes(record.verdict) ? known : [record.verdict, ...known];
  const choice = element("select", { "aria-label": texts.of_job(texts.verdict, record.name), onchange: () => judge(record, choice) },
    ...values.map((value) => element("option", { value }, texts.verdicts[value] ?? value)));
  choice.value = record.verdict;
  return choice;
}

function recordRow(record) {
  const link = (what, text) => element("a",
    { href: `/api/v1/jobs/${record.job}/${what}`, target: "_blank", rel: "noopener", "aria-label": texts.of_job(text, record.name) },
    text);
  return element("li", { class: "job" },
    element("div", {}, element("p", { class: "job-title" }, record.name), element("p", { class: "muted" })),
    element("div", { class: "line" },
      verdictChoice(record),
      link("record", texts.record),
      link("layers", texts.record_layers),
      element("button", { type: "button", "aria-label": texts.of_job(texts.again, record.name), onclick: () => printAgain(record) },
        texts.again)));
}

function updateRow(row, record, mayOperate) {
  const details = [texts.verdicts[record.verdict] ?? record.verdict, texts.record_by(record.operator)];
  if (record.ended_utc_s !== null) details.unshift(dayTime(record.ended_utc_s));
  if (record.reason) details.push(record.reason);
  setText(row.firstChild.lastChild, details.join(", "));
  row.lastChild.lastChild.hidden = row.lastChild.firstChild.hidden = !mayOperate;
  if (document.activeElement !== row.lastChild.firstChild) row.lastChild.firstChild.value = record.verdict;
}

async function askRecords(mayOperate) {
  const { records } = await get("/api/v1/records");
  byId("no-records").hidden = records.length > 0;
  syncRows(byId("record-list"), records, (record) => record.serial, recordRow,
    (row, record) => updateRow(row, record, mayOperate));
}

/** Asks for the list again where a part may have been added, now and then, and whenever the link was lost. */
export async function showRecords(state, mayOperate, wasLost) {
  const seen = `${state.parts} ${state.unit.state} ${mayOperate}`;
  if (isAsking || (seen === shown && !wasLost && Date.now() - asked < longestAge)) return;
  isAsking = true;
  asked = Date.now();
  shown = seen; // whatever is answered: a state comes ten times a second
  try {
    await askRecords(mayOperate);
    byId("records").hidden = false;
  } catch (error) {
    // The journal is elsewhere. Where nobody answers at all, the link reports it.
    if (error.status === 404) byId("records").hidden = true;
  } finally {
    isAsking = false;
  }
}
