// Requests to the server, and the link over which the state comes.

let csrf = "";
let clocks = []; // of the last minute: by how much the server's time was ahead of this host's [s], and when by this host [ms]
const pollTimeout = 3000; // ms
const silentAfter = 2500; // ms: the state comes once a second at least
const clocksFor = 60000; // ms
const deadAfter = 4000; // ms

export class Refused extends Error {
  constructor(status, body) {
    super(body.message || `${status}`);
    this.status = status;
    this.code = body.code || "";
  }
}

/**
 * By the server's clock: orders that let the machine move and are held up on their way are refused there. States come late, by more or less:
 * the one that came soonest shows the clock.
 */
function pressedAt() {
  return clocks.length > 0 && (Math.max(...clocks.map((each) => each.ahead)) + performance.now() / 1000).toFixed(3);
}

function setClock(server) {
  const now = performance.now();
  clocks = clocks.filter((each) => now - each.at < clocksFor);
  clocks.push({ ahead: server - now / 1000, at: now });
}

async function send(method, path, body, { pressed, signal }) {
  const headers = { "X-CSRF-Token": csrf };
  if (pressed) headers["X-Pressed-At"] = pressed;
  if (body !== undefined) headers["Content-Type"] = "application/json";
  const response = await fetch(path, {
    method,
    headers,
    body: body === undefined ? undefined : JSON.stringify(body),
    credentials: "same-origin",
    cache: "no-store",
    signal,
  });
  const text = await response.text();
  let value = {};
  try {
    value = text ? JSON.parse(text) : {};
  } catch {
    value = { message: text };
  }
  if (!response.ok) throw new Refused(response.status, value);
  return value;
}

/** A server that was started anew knows the page's key no more: what it refuses for that is asked with its own. */
async function request(method, path, body, signal) {
  const how = { pressed: method === "POST" ? pressedAt() : null, signal };
  try {
    return await send(method, path, body, how);
  } catch (error) {
    if (error.code !== "no_csrf_token") throw error;
    await session();
    return send(method, path, body, how);
  }
}

export const get = (path, signal) => request("GET", path, undefined, signal);
export const post = (path, body = {}) => request("POST", path, body);
export const remove = (path) => request("DELETE", path, {});

export async function session() {
  const value = await get("/api/v1/session");
  csrf = value.csrf || "";
  return value;
}

export async function login(token) {
  await post("/api/v1/session", { token });
  return session();
}

/** Sends a file as a form with these fields, and reports how far it is. */
export async function upload(file, fields, onProgress) {
  await session().catch(() => {}); // a refusal might be lost while the file is under way
  return new Promise((resolve, reject) => {
    const form = new FormData();
    for (const [name, value] of Object.entries(fields)) form.append(name, value);
    form.append("file", file, file.name);
    const call = new XMLHttpRequest();
    call.open("POST", "/api/v1/jobs");
    call.setRequestHeader("X-CSRF-Token", csrf);
    call.upload.addEventListener("progress", (event) => event.lengthComputable && onProgress(event.loaded / event.total));
    call.addEventListener("load", () => {
      let value = {};
      try {
        value = JSON.parse(call.responseText);
      } catch {
        value = { message: call.responseText };
      }
      if (call.status < 300) resolve(value);
      else reject(new Refused(call.status, value));
    });
    call.addEventListener("error", () => reject(new Refused(0, {})));
    call.send(form);
  });
}

/** The state of the cell as it changes: by WebSocket, and by asking every second where there is none. */
export class Link {
  constructor(onState, onLoggedOut) {
    this.onState = onState;
    this.onLoggedOut = onLoggedOut;
    this.isWanted = true;
    this.opened = 0; // connections that have said something
    this.connect();
    this.poll = setInterval(() => this.look(), 1000);
  }

  connect() {
    const scheme = location.protocol === "https:" ? "wss" : "ws";
    const socket = new WebSocket(`${scheme}://${location.host}/api/v1/ws`);
    this.socket = socket;
    this.heard = Date.now();
    let isNew = true;
    const isUsed = () => this.isWanted && this.socket === socket;
    socket.addEventListener("message", (event) => {
      if (!isUsed()) return;
      this.heard = Date.now();
      if (isNew) {
        this.opened += 1;
        clocks = []; // the server may be another one
      }
      isNew = false;
      this.take(JSON.parse(event.data));
    });
    socket.addEventListener("close", () => setTimeout(() => isUsed() && this.connect(), 1000));
  }

  take(state) {
    if (state.clock_s !== undefined) setClock(state.clock_s);
    this.onState(state);
  }

  /** A connection whose other end is gone stays open for minutes: the state is asked for beside one that is silent, and it is given up. */
  look() {
    const isOpen = this.socket.readyState === WebSocket.OPEN;
    const silent = Date.now() - this.heard;
    if (isOpen && silent < silentAfter) return;
    if (isOpen && silent > deadAfter) {
      const dead = this.socket;
      this.connect();
      dead.close();
    }
    this.ask();
  }

  async ask() {
    if (this.isAsking) return;
    this.isAsking = true;
    try {
      const state = await get("/api/v1/state", AbortSignal.timeout(pollTimeout));
      if (this.isWanted) this.take(state);
    } catch (error) {
      if (error.status === 401) this.onLoggedOut();
    } finally {
      this.isAsking = false;
    }
  }

  close() {
    this.isWanted = false;
    clearInterval(this.poll);
    this.socket.close();
  }
}
