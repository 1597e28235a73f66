// Opens reports in a headless Chromium and looks at them (`.ci/page` does it for a few fixtures):
//
//   npm install && node check-report.mjs [--pictures DIR] report.html…
//
// CHROMIUM names the browser (default: chromium). A report passes if it opens without a message on the console and
// without a request beyond its own file, is smaller than 1.5 MB, and if another surface, another colouring, a turn by
// keyboard and the switch of the net each change the picture of the view. With --pictures, screenshots (desktop, phone,
// dark) are kept in DIR.

import { mkdirSync, statSync } from "node:fs";
import { basename, dirname, join, resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { chromium } from "playwright-core";

const LARGEST = 1.5e6;
const words = process.argv.slice(2);
const keep = words[0] === "--pictures" ? words.splice(0, 2)[1] : null;
if (!words.length) {
  console.error("usage: node check-report.mjs [--pictures DIR] report.html…");
  process.exit(2);
}
if (keep) mkdirSync(keep, { recursive: true });

const browser = await chromium.launch({
  executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
  args: ["--no-sandbox", "--disable-gpu", "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
         "--disable-background-networking"],
});
let failed = 0;
const settle = (page) => page.evaluate(() => new Promise((done) =>
  requestAnimationFrame(() => requestAnimationFrame(() => setTimeout(done, 30)))));

// Texts whose contrast to their ground is less than WCAG AA asks for; runs in the page.
function contrasts() {
  const parts = (colour) => (colour.match(/[\d.]+/g) ?? []).map(Number);
  const light = ([r, g, b]) => {
    const [x, y, z] = [r, g, b].map((c) => (c /= 255) <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4);
    return 0.2126 * x + 0.7152 * y + 0.0722 * z;
  };
  const ground = (element) => {
    for (let e = element; e; e = e.parentElement) {
      const [r, g, b, a = 1] = parts(getComputedStyle(e).backgroundColor);
      if (a > 0.99) return [r, g, b];
    }
    return [255, 255, 255];
  };
  const faults = new Set();
  for (const element of document.querySelectorAll("body *:not(svg *):not(script):not(option)")) {
    const own = [...element.childNodes].some((node) => node.nodeType === 3 && node.textContent.trim());
    if (!own || !element.checkVisibility()) continue;
    const style = getComputedStyle(element), [a, b] = [light(parts(style.color)), light(ground(element))];
    const ratio = (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05);
    if (ratio < 4.5) faults.add(`contrast ${ratio.toFixed(2)} of ${element.tagName} "${element.textContent.trim().slice(0, 30)}"`);
  }
  return [...faults].slice(0, 5);
}

for (const file of words) {
  const faults = [];
  const must = (holds, fault) => holds || faults.push(fault);
  const url = pathToFileURL(resolve(file)).href;
  const page = await browser.newPage({ viewport: { width: 1280, height: 900 }, colorScheme: "light" });
  // Reading the picture back stalls software rendering; Chromium remarks on it.
  page.on("console", (message) =>
    message.text().includes("ReadPixels") || faults.push(`console: ${message.type()}: ${message.text()}`));
  page.on("pageerror", (error) => faults.push(`error: ${error.message}`));
  page.on("request", (request) =>
    must(request.url() === url || request.url().startsWith("data:"), `request: ${request.url()}`));
  const begun = Date.now();
  await page.goto(url, { waitUntil: "load" });
  await settle(page);
  const opened = Date.now() - begun;
  const size = statSync(file).size;
  must(size < LARGEST, `${size} bytes`);

  const canvas = page.locator("#view");
  if (await canvas.count()) {
    must(await canvas.isVisible(), "the view is hidden: no WebGL");
    const seen = async () => { await settle(page); return (await canvas.screenshot()).toString("base64"); };
    const changes = async (what, act) => {
      const before = await seen();
      await act();
      must((await seen()) !== before, `${what} does not change the picture`);
    };
    // Chips where there is room, a list where there are many.
    const pick = async (group, k) => {
      const list = page.locator(`#${group} select`);
      if (await list.isVisible()) await list.selectOption({ index: k });
      else await page.locator(`#${group} .chip`).nth(k).click();
    };
    const slider = page.locator("#frame");
    // Methods may find the same surface: take one that differs from the first by more than a pixel, if there is one.
    const other = await page.evaluate(() => {
      const read = (s) => new Float32Array(Uint8Array.from(atob(s.points), (c) => c.charCodeAt(0)).buffer);
      const all = JSON.parse(document.getElementById("surfaces").textContent).surfaces.map(read);
      const { best } = JSON.parse(document.getElementById("surfaces").textContent);
      return all.findIndex((points) =>
        points.length !== all[best].length || points.some((x, k) => Math.abs(x - all[best][k]) > 0.01));
    });
    // Of a boundary in one point there is nothing to turn, of one on a line nothing to colour.
    const [isPoint, isLine] = await page.evaluate(() => {
      const read = (s) => new Float32Array(Uint8Array.from(atob(s.points), (c) => c.charCodeAt(0)).buffer);
      const { best, surfaces } = JSON.parse(document.getElementById("surfaces").textContent), all = read(surfaces[best]);
      const from = Array.from({ length: all.length / 3 }, (_, k) => [0, 1, 2].map((i) => all[3 * k + i] - all[i]));
      const size = (p) => Math.hypot(...p), far = from.reduce((a, b) => (size(b) > size(a) ? b : a), [0, 0, 0]);
      const across = ([x, y, z]) => size([y * far[2] - z * far[1], z * far[0] - x * far[2], x * far[1] - y * far[0]]);
      return [size(far) < 1e-6, from.every((p) => across(p) < 1e-6)];
    });
    if (other >= 0) await changes("another surface", () =>
      slider.count().then((found) => (found ? slider.fill(String(other)) : pick("methods", other))));
    if ((await page.locator("#fields .chip").count()) > 1)
      await changes("another colour", async () =>
        pick("fields", (await page.locator("#fields input").nth(0).isChecked()) ? 1 : 0));
    if (await page.locator("#compare").isVisible()) {
      const count = await page.locator("#fields .chip").count();
      await changes("a surface beside it", () => page.locator("#compare").selectOption({ index: 1 }));
      if (isLine) await pick("fields", count - 1);
      else await changes("the distance as colour", () => pick("fields", count - 1));
      must(/length/.test(await page.locator("#quantity").textContent()), "the distance has no unit");
      await changes("no surface beside it", () => page.locator("#compare").selectOption("-1"));
    }
    if (!isPoint) await changes("an arrow key", () => canvas.press("ArrowLeft"));
    if (!isPoint) await changes("a drag", async () => {
      const box = await canvas.boundingBox();
      await page.mouse.move(box.x + 200, box.y + 150);
      await page.mouse.down();
      await page.mouse.move(box.x + 260, box.y + 180);
      await page.mouse.up();
    });
    if (await page.evaluate(() => JSON.parse(document.getElementById("surfaces").textContent).surfaces
      .every((s) => s.net.points))) await changes("the control net", () => page.locator("#net").click());
    if (!isPoint) await changes("wireframe", () => page.locator("#wires").click());
    const swing = page.locator("#swing");
    if (await swing.isVisible()) {
      await swing.focus();
      await changes("the swing of the mode", async () => { await page.keyboard.press("Enter"); await page.waitForTimeout(300); });
      await page.keyboard.press("Enter");
      const still = await seen();
      must(still === (await seen()), "the swing does not end");
    }
  }
  {
    const name = basename(dirname(resolve(file)));
    const shot = async (suffix, options, whole) => {
      const view = await browser.newPage({ deviceScaleFactor: 1, ...options });
      await view.goto(url, { waitUntil: "load" });
      await settle(view);
      if (keep) await view.screenshot({ path: join(keep, `${name}-${suffix}.png`), fullPage: whole });
      for (const fault of await view.evaluate(contrasts)) must(false, `${suffix}: ${fault}`);
      // On a phone the area is seen without a swipe.
      const area = await view.evaluate(() => {
        const cell = document.querySelector('th[data-figure="area"]');
        return cell ? cell.getBoundingClientRect().right : 0;
      });
      // On a desk no column is cut.
      const cut = await view.evaluate(() => [...document.querySelectorAll(".wide")].filter((box) =>
        box.scrollWidth > box.clientWidth + 1).map((box) => box.scrollWidth - box.clientWidth));
      must(options.viewport.width < 1400 || !cut.length, `${suffix}: columns cut by ${cut} pixels`);
      must(area <= options.viewport.width, `${suffix}: the area lies ${area} pixels to the right`);
      const wide = await view.evaluate(() => document.documentElement.scrollWidth > innerWidth + 1);
      must(!wide, `${suffix}: the page is wider than the window`);
      await view.close();
    };
    await shot("desktop", { viewport: { width: 1400, height: 900 }, colorScheme: "light" }, true);
    await shot("dark", { viewport: { width: 1280, height: 900 }, colorScheme: "dark" }, true);
    await shot("small", { viewport: { width: 800, height: 600 }, colorScheme: "light" }, true);
    await shot("phone", { viewport: { width: 390, height: 844 }, colorScheme: "light", deviceScaleFactor: 2 }, false);
    await shot("phone-whole", { viewport: { width: 390, height: 844 }, colorScheme: "light" }, true);
  }
  await page.close();
  console.log(`${faults.length ? "FAILED" : "ok"} ${file}: ${(size / 1e3).toFixed(0)} kB, open in ${opened} ms`);
  for (const fault of faults) console.log(`  ${fault}`);
  failed += faults.length > 0;
}
await browser.close();
process.exit(failed ? 1 : 0);
