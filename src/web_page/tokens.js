// Tokens, the mode and the PLC's access: for maintenance.
import { get, post, remove } from "/page/api.js";
import { ask } from "/page/dialogs.js";
import { byId, clockTime, dayOf, element, setFacts, setText, syncRows } from "/page/elements.js";
import { texts } from "/page/texts.js";

const tell = (text) => { byId("token-answer").textContent = text; };

async function removeToken(token) {
  const answers = [{ value: "yes", label: texts.remove, kind: "stop" }];
  if (!await ask({ title: texts.remove_token_title(token.name), text: texts.remove_token_text, answers })) return;
  await remove(`/api/v1/tokens/${token.id}`).catch((error) => tell(error.message));
  await showTokens();
}

export async function showTokens() {
  const { tokens } = await get("/api/v1/tokens");
  syncRows(byId("token-list"), tokens, (token) => token.id,
    (token) => element("li", { class: "job" },
      element("div", {}, element("p", { class: "job-title" }, token.name), element("p", { class: "muted" })),
      element("button", { type: "button", "aria-label": texts.remove_token(token.name), onclick: () => removeToken(token) },
        texts.remove)),
    (row, token) => {
      const used = token.last_used_utc_s === null ? texts.token_unused
        : texts.token_used(`${dayOf(token.last_used_utc_s)} ${clockTime(token.last_used_utc_s)}`);
      row.firstChild.lastChild.textContent = `${token.role}, ${used}`;
    });
}

let isPlcTaken = false;

export function wireMaintenance() {
  byId("plc-switch").addEventListener("click", async () => {
    try {
      await post("/api/v1/remote", { allowed: !isPlcTaken });
      byId("plc-answer").textContent = "";
    } catch (error) {
      byId("plc-answer").textContent = error.message;
    }
  });
  byId("token-form").addEventListener("submit", async (event) => {
    event.preventDefault();
    const name = byId("token-name").value;
    try {
      const made = await post("/api/v1/tokens", { name, role: byId("token-role").value });
      byId("token-name").value = "";
      await ask({ title: texts.token_made(name), text: texts.token_once, answers: [], secret: made.token, back: texts.close });
      await showTokens();
    } catch (error) {
      tell(error.message);
    }
  });
  byId("mode-form").addEventListener("submit", async (event) => {
    event.preventDefault();
    try {
      await post("/api/v1/mode", { mode: Number(byId("mode").value) });
      byId("mode-answer").textContent = "";
    } catch (error) {
      byId("mode-answer").textContent = error.message;
    }
  });
}

export function showUnit(state) {
  isPlcTaken = state.unit.takes_plc;
  setText(byId("plc-access"), isPlcTaken ? texts.plc_allowed : texts.plc_locked);
  setText(byId("plc-switch"), isPlcTaken ? texts.lock_plc : texts.allow_plc);
  setFacts(byId("counters"), [[texts.parts, String(state.parts)], [texts.defective, String(state.defective)]]);
}
