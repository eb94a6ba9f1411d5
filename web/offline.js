// Keeps the page's files in the browser: after the first load it opens without a network.
importScripts("unpack.js");

const VERSION = "@VERSION@";
const PROGRAM = "program.wasm.packed";
const FILES = ["./", "page.css", "page.js", "program.js", "worker.js", "unpack.js", PROGRAM, "icon.svg", "manifest.webmanifest"];

async function keep() {
  const cache = await caches.open(VERSION);
  await cache.addAll(FILES);
  // Later starts find it unpacked.
  const packed = await (await cache.match(PROGRAM)).arrayBuffer();
  const headers = { "Content-Type": "application/wasm" };
  await cache.put(PROGRAM, new Response(unpack(new Uint8Array(packed)), { headers }));
  await skipWaiting();
}

addEventListener("install", (event) => event.waitUntil(keep()));

addEventListener("activate", (event) => {
  const old = (names) => Promise.all(names.filter((name) => name !== VERSION).map((name) => caches.delete(name)));
  event.waitUntil(caches.keys().then(old).then(() => clients.claim()));
});

addEventListener("fetch", (event) => {
  const kept = caches.match(event.request, { ignoreSearch: true });
  event.respondWith(kept.then((found) => found ?? fetch(event.request)));
});
