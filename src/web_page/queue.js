// The queue, uploads, and applications that ask to send.
import { post, remove, upload } from "/page/api.js";
import { ask } from "/page/dialogs.js";
import { byId, element, setText, syncRows } from "/page/elements.js";
import { texts } from "/page/texts.js";

const tell = (text) => { byId("upload-answer").textContent = text; };
const tried = (promise) => promise.then(() => tell("")).catch((error) => tell(error.message));

function button(word, kind, job, act) {
  return element("button", { type: "button", class: kind, "aria-label": texts.of_job(word, job.name), onclick: act }, word);
}

function jobRow(job) {
  const moveBy = (step) => (event) => {
    const place = Number(event.currentTarget.closest("li").dataset.place) + step;
    tried(post(`/api/v1/jobs/${job.id}/move`, { place }));
  };
  const change = (what) => () => tried(post(`/api/v1/jobs/${job.id}/${what}`));
  const removeJob = async () => {
    const answers = [{ value: "yes", label: texts.remove, kind: "stop" }];
    if (await ask({ title: texts.remove_title(job.name), text: texts.remove_text, answers }))
      await tried(remove(`/api/v1/jobs/${job.id}`));
  };
  return element("li", { class: "job" },
    element("div", {}, element("p", { class: "job-title" }), element("p", { class: "muted" })),
    element("div", { class: "line" },
      button(texts.release, "primary", job, change("release")),
      button(texts.revoke, "", job, change("revoke")),
      button(texts.move, "", job, change("move")),
      button(texts.earlier, "", job, moveBy(-1)),
      button(texts.later, "", job, moveBy(1)),
      button(texts.remove, "", job, removeJob)));
}

function updateJob(row, job, { place, places }, mayOperate) {
  const [title, detail] = row.firstChild.children;
  const [releaseIt, revokeIt, moveIt, earlierIt, laterIt, removeIt] = row.lastChild.children;
  setText(title, job.name);
  const details = [texts.job_states[job.state] ?? job.state, texts.job_by(job.created_by)];
  if (job.released_by) details.push(texts.job_released(job.released_by));
  setText(detail, details.join(", "));
  row.dataset.state = job.state;
  row.dataset.place = place;
  const waits = job.state === "NotAllowedToStart";
  const isReleased = job.state === "AllowedToStart";
  hide(releaseIt, !mayOperate || !waits, row);
  hide(revokeIt, !mayOperate || !isReleased, row);
  const mayMove = mayOperate && (waits || isReleased);
  hide(moveIt, !mayMove || place === 1, row);
  hide(earlierIt, !mayMove || place <= 2, row); // the second is moved to the front
  hide(laterIt, !mayMove || place === places, row);
  hide(removeIt, !mayOperate || !(waits || isReleased), row);
}

/** Hides a button; its focus goes to the next one of its row. */
function hide(target, isHidden, row) {
  if (target.hidden === isHidden) return;
  const hadFocus = document.activeElement === target;
  target.hidden = isHidden;
  if (hadFocus) setTimeout(() => row.querySelector("button:not([hidden])")?.focus());
}

export function showQueue(jobs, rights) {
  byId("no-jobs").hidden = jobs.length > 0;
  byId("upload-form").hidden = !rights.upload;
  const places = jobs.length;
  const placeOf = new Map(jobs.map((job, index) => [job.id, index + 1]));
  syncRows(byId("job-list"), jobs, (job) => job.id, jobRow, 
    (row, job) => updateJob(row, job, { place: placeOf.get(job.id), places }, rights.operate));
}

export function showRequests(requests, mayOperate) {
  byId("requests").hidden = !mayOperate || requests.length === 0;
  syncRows(byId("request-list"), mayOperate ? requests : [], (request) => request.id,
    (request) => element("li", { class: "job" },
      element("p", {}, texts.request_from(request.application, request.from)),
      element("div", { class: "line" },
        element("button", { type: "button", onclick: () => tried(post(`/api/v1/keys/${request.id}/deny`)) }, texts.deny),
        element("button", { type: "button", class: "primary", onclick: () => tried(post(`/api/v1/keys/${request.id}/allow`)) },
          texts.allow))),
    () => {});
}

let isUploading = false;

const isMesh = (file) => /\.(stl|obj|ply|3mf|step|stp)$/i.test(file?.name ?? "");
/** What a mesh is sliced by; nothing for programs. */
function meshFields(file) {
  if (!isMesh(file)) return {};
  const value = (id) => byId(id).value.trim();
  return { material: value("mesh-material"), process: value("mesh-process"), settings: value("mesh-settings") };
}

export function wireUpload() {
  byId("program").addEventListener("change", () => {
    byId("mesh-fields").hidden = !isMesh(byId("program").files[0]);
  });
  byId("upload-form").addEventListener("submit", async (event) => {
    event.preventDefault();
    if (isUploading) return;
    const file = byId("program").files[0];
    if (!file) return tell(texts.choose_file);
    isUploading = true;
    const bar = byId("upload-progress");
    bar.hidden = false;
    bar.value = 0;
    bar.setAttribute("aria-label", texts.uploading(file.name));
    tell(texts.uploading(file.name));
    try {
      const sent = await upload(file, meshFields(file), (part) => {
        bar.value = part;
        if (part >= 1) tell(isMesh(file) ? texts.slicing : texts.checking);
      });
      tell(texts.uploaded(sent.name));
      byId("program").value = "";
      byId("mesh-fields").hidden = true;
    } catch (error) {
      tell(error.status ? error.message : texts.no_link);
    } finally {
      isUploading = false;
      bar.hidden = true;
    }
  });
}
