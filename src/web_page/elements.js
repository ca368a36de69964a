// What the page's parts need to change its document.
import { texts } from "/page/texts.js";

export const byId = (id) => document.getElementById(id);

export function element(tag, attributes = {}, ...children) {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (name === "class") made.className = value;
    else if (name.startsWith("on")) made.addEventListener(name.slice(2), value);
    else made.setAttribute(name, value);
  }
  made.append(...children);
  return made;
}

/** Sets a text only where it differs: what a screen reader or a selection is at is left alone. */
export function setText(target, text) {
  if (target.textContent !== text) target.textContent = text;
}

/** Rows of a list by their keys: those that stay keep their place in the document, and the focus. */
export function syncRows(list, items, keyOf, make, update) {
  const rows = new Map([...list.children].map((row) => [row.dataset.key, row]));
  items.forEach((item, index) => {
    const key = String(keyOf(item));
    let row = rows.get(key);
    if (!row) {
      row = make(item);
      row.dataset.key = key;
    }
    rows.delete(key);
    update(row, item);
    if (list.children[index] !== row) list.insertBefore(row, list.children[index] ?? null);
  });
  for (const row of rows.values()) {
    const hadFocus = row.contains(document.activeElement);
    row.remove();
    if (hadFocus) focusOn(list);
  }
}

/** Gives the focus of something that is gone to what it was in. */
export function focusOn(target) {
  const section = target.closest("section") ?? target;
  section.tabIndex = -1;
  section.focus({ preventScroll: true });
}

export function setFacts(list, facts) {
  syncRows(list, facts, ([name]) => name,
    () => element("div", {}, element("dt"), element("dd")),
    (row, [name, value]) => {
      setText(row.firstChild, name);
      setText(row.lastChild, value);
    });
}

export function fillTexts() {
  for (const place of document.querySelectorAll("[data-text]")) place.textContent = texts[place.dataset.text];
  // Pictures are called as their sections until they show something.
  for (const picture of document.querySelectorAll("section canvas"))
    picture.setAttribute("aria-label", picture.closest("section").querySelector("h2").textContent);
}

export function duration(seconds) {
  if (seconds < 90) return `${Math.round(seconds)} s`;
  const minutes = Math.round(seconds / 60);
  if (minutes < 90) return `${minutes} min`;
  return `${Math.floor(minutes / 60)} h ${minutes % 60} min`;
}

export const clockTime = (utcSeconds) => new Date(utcSeconds * 1000).toLocaleTimeString();

export const dayOf = (utcSeconds) => new Date(utcSeconds * 1000).toLocaleDateString();

/** The time of day, behind its date if that is not today's. */
export function dayTime(utcSeconds) {
  const day = dayOf(utcSeconds);
  return day === dayOf(Date.now() / 1000) ? clockTime(utcSeconds) : `${day} ${clockTime(utcSeconds)}`;
}

export const colourOf = (name) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();

/** The canvas at the resolution of the screen, and its size in CSS pixels. */
export function canvasOf(canvas) {
  const { width, height } = canvas.getBoundingClientRect();
  const ratio = window.devicePixelRatio || 1;
  canvas.width = Math.max(1, Math.round(width * ratio));
  canvas.height = Math.max(1, Math.round(height * ratio));
  const pen = canvas.getContext("2d");
  pen.setTransform(ratio, 0, 0, ratio, 0, 0);
  pen.clearRect(0, 0, width, height);
  return { pen, width, height };
}
