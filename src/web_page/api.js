// Requests to the server, and the link over which the state comes.

let csrf = "";

export class Refused extends Error {
  constructor(status, body) {
    super(body.message || `${status}`);
    this.status = status;
    this.code = body.code || "";
  }
}

async function request(method, path, body, signal) {
  const headers = { "X-CSRF-Token": csrf };
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

/** Sends a file as a form, and reports how far it is. */
export function upload(file, onProgress) {
  return new Promise((resolve, reject) => {
    const form = new FormData();
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
    this.isOpen = false;
    this.isWanted = true;
    this.connect();
    this.poll = setInterval(() => this.ask(), 1000);
  }

  connect() {
    const scheme = location.protocol === "https:" ? "wss" : "ws";
    this.socket = new WebSocket(`${scheme}://${location.host}/api/v1/ws`);
    this.socket.addEventListener("open", () => { this.isOpen = true; });
    this.socket.addEventListener("message", (event) => this.onState(JSON.parse(event.data)));
    this.socket.addEventListener("close", () => {
      this.isOpen = false;
      if (this.isWanted) setTimeout(() => this.isWanted && this.connect(), 1000);
    });
  }

  async ask() {
    if (this.isOpen || this.isAsking) return;
    this.isAsking = true;
    try {
      this.onState(await get("/api/v1/state"));
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
