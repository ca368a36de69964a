// Temperatures of ten minutes as a line.
import { byId, canvasOf, colourOf, duration, setFacts } from "/page/elements.js";
import { texts } from "/page/texts.js";

const window_s = 600;
const old_s = 5; // between jobs a machine reports nothing
let samples = [];

export const lastSample = () => (samples.length ? samples[samples.length - 1].utc_s : 0);
export const forgetSamples = () => { samples = []; };

export function takeSamples(more) {
  const last = lastSample();
  samples.push(...more.filter((sample) => sample.utc_s > last));
  samples = samples.filter((sample) => sample.utc_s > lastSample() - window_s);
  drawHeat();
}

const rounded = (value) => (value === null || value === undefined ? "–" : value.toFixed(1));

export function showHeat(machine) {
  byId("temperatures").hidden = !machine;
  if (!machine) return;
  const dated = (text) => (machine.age_s > old_s ? texts.ago(text, duration(machine.age_s)) : text);
  const facts = [
    [texts.nozzle, dated(texts.degrees(rounded(machine.nozzle_degc)))],
    [texts.bed, dated(texts.degrees(rounded(machine.bed_degc)))],
  ];
  // A machine that reports no positions leaves them at zero.
  if (machine.position_m.some((value) => value))
    facts.push([texts.position,
      dated(texts.millimetres(machine.position_m.map((value) => (value === null ? "–" : (value * 1000).toFixed(1)))))]);
  setFacts(byId("heat"), facts);
}

function range(key) {
  const values = samples.map((sample) => sample[key]).filter((value) => value !== null);
  return values.length ? texts.between(Math.min(...values).toFixed(0), Math.max(...values).toFixed(0)) : texts.unknown;
}

export function drawHeat() {
  const canvas = byId("heat-chart");
  canvas.setAttribute("aria-label", texts.heat_chart(range("nozzle_degc"), range("bed_degc")));
  const { pen, width, height } = canvasOf(canvas);
  const values = samples.flatMap((sample) => [sample.nozzle_degc, sample.bed_degc]).filter((value) => value !== null);
  const top = Math.max(50, Math.ceil(Math.max(0, ...values) / 50 + 0.1) * 50);
  const left = 38;
  const bottom = height - 6;
  const x = (utc) => left + ((utc - lastSample() + window_s) / window_s) * (width - left - 4);
  const y = (value) => bottom - (value / top) * (bottom - 10);
  pen.font = "12px system-ui, sans-serif";
  pen.textAlign = "right";
  pen.textBaseline = "middle";
  for (let value = 0; value <= top; value += top / 2) {
    pen.strokeStyle = colourOf("--line");
    pen.lineWidth = 1;
    pen.beginPath();
    pen.moveTo(left, y(value));
    pen.lineTo(width - 4, y(value));
    pen.stroke();
    pen.fillStyle = colourOf("--muted");
    pen.fillText(String(value), left - 6, y(value));
  }
  curve(pen, "nozzle_degc", "--series-1", [], x, y);
  curve(pen, "bed_degc", "--series-2", [6, 4], x, y);
}

function curve(pen, key, colour, dashes, x, y) {
  pen.strokeStyle = colourOf(colour);
  pen.lineWidth = 2;
  pen.setLineDash(dashes);
  pen.beginPath();
  let isDown = false;
  for (const sample of samples) {
    if (sample[key] === null) {
      isDown = false;
      continue;
    }
    if (isDown) pen.lineTo(x(sample.utc_s), y(sample[key]));
    else pen.moveTo(x(sample.utc_s), y(sample[key]));
    isDown = true;
  }
  pen.stroke();
  pen.setLineDash([]);
}
