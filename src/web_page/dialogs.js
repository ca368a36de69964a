// Questions before what cannot be undone. The focus is on the way back, and returns to what asked.
import { byId, element, focusOn } from "/page/elements.js";
import { texts } from "/page/texts.js";

/** @returns the value of the chosen answer; "" for going back */
export function ask({ title, text, answers, secret = "", back = texts.go_back }) {
  const dialog = byId("dialog");
  if (dialog.open) return Promise.resolve("");
  const opener = document.activeElement;
  byId("dialog-title").textContent = title;
  byId("dialog-text").textContent = text;
  byId("dialog-secret").textContent = secret;
  byId("dialog-secret").hidden = !secret;
  const buttons = [{ value: "", label: back, kind: "" }, ...answers].map(({ value, label, kind }) =>
    element("button", { type: "button", class: kind, onclick: () => dialog.close(value) }, label));
  byId("dialog-buttons").replaceChildren(...buttons);
  dialog.returnValue = "";
  dialog.showModal();
  buttons[0].focus();
  return new Promise((resolve) => {
    dialog.addEventListener("close", () => {
      byId("dialog-secret").textContent = "";
      // The browser has given it back at once; it may be elsewhere by now.
      if (document.activeElement === document.body) {
        if (opener && opener.isConnected) opener.focus();
        else focusOn(byId("commands"));
      }
      resolve(dialog.returnValue);
    }, { once: true });
  });
}
