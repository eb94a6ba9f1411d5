// The page in a headless Chromium; `web/test` starts it.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { join } from "node:path";

const { chromium } = createRequire(join(process.env.NODE_MODULES, "x"))("playwright-core");
const [address, work, server] = process.argv.slice(2);
const pictures = process.env.PICTURES;

const context = await chromium.launchPersistentContext(join(work, "profile"), {
  executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
  headless: true,
  viewport: { width: 1280, height: 800 },
  args: ["--no-sandbox", "--disable-quic", "--no-first-run", "--disable-background-networking",
    "--disable-component-update", "--disable-sync", "--use-gl=angle", "--use-angle=swiftshader",
    "--enable-unsafe-swiftshader"],
});
// What is asked of Web Workers, and what comes of it.
await context.addInitScript(() => {
  globalThis.jobs = [];
  const { postMessage, terminate } = Worker.prototype;
  Worker.prototype.postMessage = function (what) {
    if (what.kind) {
      jobs.push(`asked ${what.kind}`);
      const heard = ({ data }) => {
        if (data.total !== undefined) return jobs.push(`told ${what.kind}`);
        this.removeEventListener("message", heard);
        jobs.push(`${data.answer ? "answered" : "left"} ${what.kind}`);
      };
      this.addEventListener("message", heard);
    }
    return postMessage.call(this, what);
  };
  Worker.prototype.terminate = function () {
    jobs.push("ended");
    return terminate.call(this);
  };
});
const page = await context.newPage();
const asked = [];
const faults = [];
context.on("request", (request) => asked.push(request.url()));
page.on("console", (message) => message.type() === "error" && faults.push(message.text()));
page.on("pageerror", (error) => faults.push(String(error)));

async function opened(link = "") {
  await page.goto("about:blank");
  await page.goto(address + link);
  await page.waitForFunction(() => document.documentElement.dataset.first !== undefined, null, { timeout: 60_000 });
  return Number(await page.evaluate(() => document.documentElement.dataset.first));
}
// A frame comes when there is something to draw, and what changed is kept within a second.
const settled = () => page.waitForTimeout(1600);
async function kept() {
  await settled();
  return JSON.parse(await page.evaluate(() => localStorage.getItem("spectral-explorer.workspace")));
}
async function picture(name) {
  const bytes = await page.screenshot(pictures ? { path: join(pictures, `${name}.png`) } : {});
  return bytes;
}
// The button that stops the job of the page Many lights.
const CANCEL = [249, 213];
let step = 0;
const done = (words) => console.log(`${++step}. ${words}`);

// The first picture.
const first = await opened();
assert.ok(first < 3000, `first frame after ${first} ms`);
await settled();
const drawn = await picture("first");
assert.ok(drawn.length > 20_000, "a picture of one colour is smaller");
done(`the first frame was drawn ${Math.round(first)} ms after the address was asked for`);

// The greeting gives way; a knob is moved by a key, and by hand.
await page.keyboard.press("Escape");
await page.keyboard.press("ArrowRight");
const order = (workspace) => workspace.settings.order;
assert.equal(order(await kept()), 8);
await page.mouse.move(184, 559);
await page.mouse.down();
await page.mouse.move(150, 559, { steps: 4 });
await page.mouse.up();
const moved = order(await kept());
assert.ok(moved >= 1 && moved < 7, `${moved} waves`);
await picture("moved");
done(`a key made 7 waves 8, a hand on the slider made them ${moved}`);

// A file is dropped.
const lamp = readFileSync(join(work, "lamp of mine.csv"), "utf8");
await page.evaluate((text) => {
  const files = new DataTransfer();
  files.items.add(new File([text], "lamp of mine.csv"));
  document.querySelector("canvas").dispatchEvent(new DragEvent("drop", { dataTransfer: files, bubbles: true, cancelable: true }));
}, lamp);
const own = await kept();
assert.equal(own.own.length, 1);
assert.equal(own.light, "own/1");
await picture("dropped");
done("a dropped file is shown and kept");

// A file is chosen, by the shortcut of the window.
const choosing = page.waitForEvent("filechooser");
await page.keyboard.press("Control+o");
await (await choosing).setFiles({ name: "second.csv", mimeType: "text/csv", buffer: Buffer.from(lamp.replace("FL2", "FL2 again").replaceAll("0.48", "0.49")) });
assert.equal((await kept()).own.length, 2);
done("a file that was chosen is opened beside it");

// What is saved is a download.
const loading = page.waitForEvent("download");
await page.keyboard.press("Control+s");
const project = await loading;
assert.ok(project.suggestedFilename().endsWith(".json"), project.suggestedFilename());
const saved = JSON.parse(readFileSync(await project.path(), "utf8"));
assert.equal(saved.own.length, 2);
done(`the project was downloaded as ${project.suggestedFilename()}`);

// Reload.
await opened();
assert.equal((await kept()).own.length, 2);
done("after a reload the workspace is there");

// A job is run by another instance of the program, and cancelled.
const worked = (words) => page.waitForFunction((words) => jobs.includes(words), words, { timeout: 120_000 });
const jobs = () => page.evaluate(() => jobs);
await opened("#page=tradeoff");
await worked("answered sweep");
await settled();
await picture("tradeoff");
assert.equal((await kept()).preferences.page, "tradeoff");
await opened("#page=race");
await worked("answered race");
// The window goes on while a job is under way.
await opened("#page=many-lights");
await page.evaluate(() => {
  const { drawn } = host;
  host.drawn = () => {
    jobs.push("drawn");
    drawn();
  };
});
await worked("answered many");
await settled();
await picture("many");
const log = await jobs();
assert.ok(log.slice(log.indexOf("told many"), log.indexOf("answered many")).includes("drawn"), log.join());
await opened("#page=many-lights");
await worked("told many");
await page.waitForTimeout(300);
await picture("running");
await page.mouse.click(...CANCEL);
await worked("ended");
await settled();
await picture("cancelled");
assert.ok(!(await jobs()).includes("answered many"));
done("other instances of the program worked on jobs, one was cancelled, the window went on");

// The command line answers as the program does.
const numbers = (value, path = "") => typeof value === "object" && value !== null
  ? Object.entries(value).flatMap(([key, inner]) => numbers(inner, `${path}/${key}`))
  : [[path, value]];
const here = numbers(JSON.parse(await page.evaluate(() => command("report", "FL2", "--json"))));
const there = numbers(JSON.parse(readFileSync(join(work, "report.json"), "utf8")));
assert.equal(here.length, there.length);
let worst = 0;
here.forEach(([path, value], i) => {
  assert.equal(path, there[i][0]);
  if (typeof value !== "number") return assert.equal(value, there[i][1], path);
  worst = Math.max(worst, Math.abs(value - there[i][1]) / Math.max(1, Math.abs(value)));
});
assert.ok(worst <= 1e-9, `${worst}`);
done(`report FL2 --json: ${here.length} values as the program says, the worst ${worst.toExponential(0)} off`);

// A light in a link.
await opened("#page=spectrum&cs1=cosine;380:780;5%200%20-2;546.1*9");
assert.equal((await kept()).own.length, 3);
await picture("link");
done("a light that is in a link is shown");

// A lesson, three steps.
await opened("#lesson=light");
await settled();
for (let at = 0; at < 3; at++) {
  await picture(`lesson-${at + 1}`);
  // What is to be done is shown, then the next step comes.
  await page.keyboard.press("PageDown");
  await page.waitForTimeout(4000);
  await page.keyboard.press("PageDown");
  await settled();
}
await picture("lesson-4");
const pictured = await Promise.all(["lesson"].map(() => page.screenshot()));
assert.ok(pictured[0].length > 20_000);
done("a lesson was taken three steps");

// A tablet, touched.
await page.setViewportSize({ width: 1024, height: 768 });
await opened("#page=spectrum");
const session = await context.newCDPSession(page);
await session.send("Emulation.setTouchEmulationEnabled", { enabled: true });
await session.send("Input.dispatchTouchEvent", { type: "touchStart", touchPoints: [{ x: 500, y: 300 }] });
await session.send("Input.dispatchTouchEvent", { type: "touchEnd", touchPoints: [] });
assert.equal((await kept()).preferences.touch, true);
await picture("tablet");
done("the first touch makes targets large");

// Nothing was asked of anybody, and nothing after the load.
assert.deepEqual(asked.filter((url) => !url.startsWith(address) && !/^(about|blob|data):/.test(url)), []);
await page.waitForFunction(() => navigator.serviceWorker.controller !== null);
const before = asked.length;
await page.keyboard.press("Control+4");
await settled();
assert.deepEqual(asked.slice(before).filter((url) => url.startsWith("http")), []);
done("no request goes anywhere else, and none follows the load");

// Without its server.
process.kill(Number(server));
await page.waitForTimeout(300);
await context.setOffline(true);
const offline = await opened();
assert.equal((await kept()).own.length, 3);
await picture("offline");
done(`without a network it opens too, first frame after ${Math.round(offline)} ms`);

assert.deepEqual(faults, []);
done("the console has no error");
await context.close();
