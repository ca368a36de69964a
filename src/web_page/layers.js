// Pictures of the print: the lines of a layer, and by how much its heights are off.
import { get } from "/page/api.js";
import { byId, canvasOf, colourOf, element, setText, syncRows } from "/page/elements.js";
import { texts } from "/page/texts.js";

let preview = null;
let asked = "";
let shownDeviation = 0;
let deviation = null;

export const layerCount = () => (preview ? preview.layers : 0);

export function wirePreview() {
  byId("preview-layer").addEventListener("input", () => {
    byId("preview-follow").checked = false;
    load(byId("preview-layer").value);
  });
}

/** Asks for the layer of the print once it is another one. */
export function showPreview(state) {
  const job = state.job ? `${state.job.id}` : "";
  const isFollowing = byId("preview-follow").checked;
  const layer = isFollowing ? Math.max(0, state.progress.layer) : Number(byId("preview-layer").value);
  const wanted = job ? `${job}/${layer}` : "";
  byId("preview").hidden = !job && !preview;
  if (wanted === asked || !wanted) return;
  // Another job: nothing of the former one is asked for.
  if (!asked.startsWith(`${job}/`)) byId("preview-follow").checked = true;
  asked = wanted;
  load(layer);
}

const retry_ms = 500;
let asking = null;

/** The layer, once its program has been read. One request at a time: a browser has few connections to a host, and Hold needs one. */
async function fetchPreview(layer, signal) {
  while (true) {
    const answer = await get(`/api/v1/preview/${layer}`, signal);
    if (!answer.is_being_read) return answer;
    setText(byId("preview-note"), texts.preview_being_read);
    await new Promise((resolve) => setTimeout(resolve, retry_ms));
    signal.throwIfAborted();
  }
}

async function load(layer) {
  asking?.abort();
  const own = new AbortController();
  asking = own;
  try {
    const answer = await fetchPreview(layer, own.signal);
    if (own.signal.aborted) return;
    preview = answer;
    byId("preview-layer").max = String(preview.layers - 1);
    byId("preview-layer").value = String(preview.layer);
    byId("preview-layer").setAttribute("aria-valuetext", texts.layer_of(preview.layer + 1, preview.layers));
    drawPreview();
  } catch (error) {
    if (own.signal.aborted) return;  // another layer is wanted by now
    // The program may not have begun: it is asked for again with the next state.
    if (error.status === 404) setTimeout(() => { asked = ""; }, 2000);
    setText(byId("preview-note"), error.status === 404 ? texts.no_preview : error.message);
  }
}

function bounds(lines) {
  const box = { left: Infinity, right: -Infinity, low: Infinity, high: -Infinity };
  for (const line of lines)
    for (let i = 0; i < line.length; i += 2) {
      box.left = Math.min(box.left, line[i]);
      box.right = Math.max(box.right, line[i]);
      box.low = Math.min(box.low, line[i + 1]);
      box.high = Math.max(box.high, line[i + 1]);
    }
  return box;
}

export function drawPreview() {
  if (!preview) return;
  const canvas = byId("preview-picture");
  const z = (preview.z_m * 1000).toFixed(2);
  canvas.setAttribute("aria-label", texts.preview_picture(preview.layer + 1, preview.layers, z));
  setText(byId("preview-note"),
    `${texts.layer} ${texts.layer_of(preview.layer + 1, preview.layers)}, ${z} mm. ${preview.is_cut_short ? texts.cut_short : ""}`);
  const { pen, width, height } = canvasOf(canvas);
  if (!preview.lines.length) return;
  const box = bounds(preview.lines);
  const margin = 12;
  const scale = Math.min((width - 2 * margin) / Math.max(1e-6, box.right - box.left),
    (height - 2 * margin) / Math.max(1e-6, box.high - box.low));
  const x = (value) => width / 2 + (value - (box.left + box.right) / 2) * scale;
  const y = (value) => height / 2 - (value - (box.low + box.high) / 2) * scale;
  pen.strokeStyle = colourOf("--series-1");
  pen.lineWidth = 1.25;
  pen.lineJoin = "round";
  for (const line of preview.lines) {
    pen.beginPath();
    pen.moveTo(x(line[0]), y(line[1]));
    for (let i = 2; i < line.length; i += 2) pen.lineTo(x(line[i]), y(line[i + 1]));
    pen.stroke();
  }
}

const millimetres = (metres) => (metres * 1000).toFixed(3);

export function showLayers(state) {
  const hasAny = state.layers.length > 0 || state.loop !== null || state.deviation_number > 0;
  byId("layers").hidden = !hasAny;
  if (!hasAny) return;
  setText(byId("loop-state"), state.loop ? texts.loop(state.loop.state, state.loop.reason) : "");
  syncRows(byId("layer-rows"), [...state.layers].reverse(), (layer) => layer.layer,
    (layer) => element("tr", {}, element("th", { scope: "row" }, String(layer.layer + 1)), ...[1, 2, 3, 4].map(() => element("td"))),
    (row, layer) => {
      const values = [layer.mean_error_m, layer.rms_error_m, layer.worst_error_m].map(millimetres);
      [...values, `${Math.round(layer.coverage * 100)} %`].forEach((value, i) => setText(row.children[i + 1], value));
    });
  byId("deviation-picture").hidden = state.deviation_number === 0;
  if (state.deviation_number !== shownDeviation) loadDeviation(state.deviation_number);
}

async function loadDeviation(number) {
  shownDeviation = number;
  if (!number) return;
  deviation = await get("/api/v1/deviation").catch(() => null);
  drawDeviation();
}

/** Blue for too low, orange for too high, the page's ground for right. */
function colourFor(share) {
  const low = [20, 90, 200];
  const high = [214, 93, 14];
  const middle = matchMedia("(prefers-color-scheme: dark)").matches ? [38, 44, 52] : [240, 242, 245];
  const end = share < 0 ? low : high;
  const part = Math.min(1, Math.abs(share));
  return `rgb(${middle.map((value, i) => Math.round(value + (end[i] - value) * part)).join(",")})`;
}

export function drawDeviation() {
  if (!deviation) return;
  const seen = deviation.errors_m.filter((value) => value !== null);
  const most = Math.max(1e-5, ...seen.map(Math.abs));
  const canvas = byId("deviation-picture");
  canvas.setAttribute("aria-label", seen.length
    ? texts.deviation_picture(millimetres(Math.min(...seen)), millimetres(Math.max(...seen))) : texts.unknown);
  const { pen, width, height } = canvasOf(canvas);
  const scaleHeight = 34;
  const size = Math.min(width / deviation.columns, (height - scaleHeight) / deviation.rows);
  const left = (width - size * deviation.columns) / 2;
  deviation.errors_m.forEach((value, i) => {
    if (value === null) return;
    pen.fillStyle = colourFor(value / most);
    pen.fillRect(left + (i % deviation.columns) * size, Math.floor(i / deviation.columns) * size, size + 0.5, size + 0.5);
  });
  drawScale(pen, most, width, height);
}

function drawScale(pen, most, width, height) {
  const from = width * 0.15;
  const length = width * 0.7;
  for (let i = 0; i < length; i += 1) {
    pen.fillStyle = colourFor((i / length) * 2 - 1);
    pen.fillRect(from + i, height - 28, 1.5, 10);
  }
  pen.fillStyle = colourOf("--text");
  pen.font = "12px system-ui, sans-serif";
  pen.textAlign = "center";
  pen.textBaseline = "alphabetic";
  for (const share of [-1, 0, 1])
    pen.fillText(`${share > 0 ? "+" : ""}${(share * most * 1000).toFixed(2)} mm`, from + ((share + 1) / 2) * length, height - 4);
}
