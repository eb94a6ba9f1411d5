// What the program asks of the browser (`host`), and what the browser tells the program.
import init, { come, come_broken, command, follow, hand_over, hide, start, tell_progress } from "./program.js";

const KEY = "spectral-explorer.workspace";
const canvas = document.getElementById("window");
const words = document.getElementById("words");

function say(text, button) {
  document.getElementById("state").textContent = text;
  words.hidden = false;
  if (button) {
    const again = words.appendChild(document.createElement("button"));
    again.textContent = button;
    again.onclick = () => location.reload();
  }
}

function broken(why) {
  if (document.documentElement.dataset.broken === undefined) {
    document.documentElement.dataset.broken = why;
    say(`The program broke down (${why}). What you did is kept.`, "Start it again");
  }
}
addEventListener("error", (event) => broken(event.message));
addEventListener("unhandledrejection", (event) => broken(String(event.reason)));

// Of two tabs the first one keeps the workspace: the second would write over it.
const keeps = new Promise((known) => {
  if (!navigator.locks) return known(true);
  navigator.locks.request(KEY, { ifAvailable: true }, (lock) => {
    known(lock !== null);
    return lock && new Promise(() => {});
  });
});
let isKeeper = true;

async function take(files) {
  for (const file of files) {
    hand_over(file.webkitRelativePath || file.name, new Uint8Array(await file.arrayBuffer()));
  }
}

function url(parts, type) {
  return URL.createObjectURL(new Blob(parts, { type }));
}

// Long work is done by other instances of the program, each in a Web Worker that is made of what is
// here: nothing is asked of a server for it, and no address can be asked by it either.
let module;
let code;
const idle = [];
const working = new Map();

function hire() {
  const worker = new Worker(code, { type: "module" });
  worker.postMessage({ module });
  return worker;
}

globalThis.host = {
  ask(number, kind, question) {
    const worker = idle.pop() ?? hire();
    working.set(number, worker);
    worker.onmessage = ({ data: { answer, done, total } }) => {
      if (total !== undefined) return tell_progress(number, done, total);
      working.delete(number);
      idle.push(worker);
      come(number, answer);
    };
    worker.onerror = (event) => {
      event.preventDefault();
      console.error(event.message);
      working.delete(number);
      worker.terminate();
      come_broken(number);
    };
    // A copy: what came is a window on all that the program holds.
    worker.postMessage({ kind, question: question.slice() });
  },
  stop(number) {
    working.get(number)?.terminate();
    working.delete(number);
  },
  pick(folder) {
    const input = document.createElement("input");
    input.type = "file";
    input.multiple = true;
    input.webkitdirectory = folder;
    input.onchange = () => take([...input.files]);
    input.click();
  },
  download(name, bytes) {
    const link = document.createElement("a");
    link.href = url([bytes], "application/octet-stream");
    link.download = name;
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 60_000);
  },
  show(html) {
    const page = document.createElement("iframe");
    page.hidden = true;
    page.src = url([html], "text/html");
    page.onload = () => page.contentWindow.print();
    document.querySelector("iframe")?.remove();
    document.body.append(page);
  },
  keep(text) {
    if (!isKeeper) return "another tab keeps its own";
    try {
      localStorage.setItem(KEY, text);
      return "";
    } catch (why) {
      const size = (text.length / 1e6).toFixed(1);
      return why.name === "QuotaExceededError"
        ? `it has ${size} MB, more than the browser gives a page; save a project`
        : `the browser keeps nothing of this page (${why.name})`;
    }
  },
  kept() {
    try {
      return localStorage.getItem(KEY) ?? undefined;
    } catch {
      return undefined;
    }
  },
  address: () => location.href.split("#")[0],
  drawn() {
    const data = document.documentElement.dataset;
    if (data.first === undefined) {
      data.first = performance.now();
      words.hidden = true;
    }
  },
};
// A command of the command line, for the browser's console: command("report", "FL2", "--json").
globalThis.command = (...all) => command(all);

canvas.addEventListener("drop", (event) => {
  event.preventDefault();
  take([...event.dataTransfer.files]);
}, true);
canvas.addEventListener("contextmenu", (event) => event.preventDefault());
addEventListener("pagehide", hide);
addEventListener("visibilitychange", () => document.hidden && hide());

function link() {
  if (location.hash) follow(decodeURIComponent(location.hash.slice(1)));
}
addEventListener("hashchange", link);

async function load() {
  const [packed, ...scripts] = await Promise.all(["program.wasm.packed", "program.js", "worker.js"].map((name) => fetch(name)));
  if (!packed.ok) throw new Error(`${packed.status} for the program`);
  // What is kept in the browser was unpacked (offline.js).
  module = packed.headers.get("Content-Type") === "application/wasm"
    ? await WebAssembly.compileStreaming(packed)
    : await WebAssembly.compile(unpack(new Uint8Array(await packed.arrayBuffer())));
  await init({ module_or_path: module });
  code = url(await Promise.all(scripts.map((script) => script.blob())), "text/javascript");
  isKeeper = await keeps;
  await start(canvas);
  link();
  canvas.focus();
  navigator.serviceWorker?.register("offline.js");
}
load().catch((why) => say(`It does not run here: ${why}`, "Try again"));
