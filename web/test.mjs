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
let step = 0;
const done = (words) => console.log(`${++step}. ${words}`);

// The first picture.
const first = await opened();
assert.ok(first < 3000, `first frame after ${first} ms`);
await settled();
const drawn = await picture("first");
assert.ok(drawn.length > 20_000, "a picture of one colour is smaller");
done(`the first frame was drawn ${Math.round(first)} ms after the address was asked for`);

// The greeting gives way; a knob is moved by a key and by hand.
await page.keyboard.press("Escape");
const before = await kept();
const settings = (workspace) => workspace.document.settings;
console.log(JSON.stringify(Object.keys(before)), JSON.stringify(before).slice(0, 600));
