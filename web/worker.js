// Stands behind program.js in a Web Worker, where another instance of the program answers questions.
let told = 0;
globalThis.host = {
  told(done, total) {
    const now = performance.now();
    if (now - told < 100) return;
    told = now;
    postMessage({ done, total });
  },
};

addEventListener("message", ({ data: { module, kind, question } }) => {
  if (module) initSync({ module });
  else postMessage({ answer: answer(kind, question) });
});
