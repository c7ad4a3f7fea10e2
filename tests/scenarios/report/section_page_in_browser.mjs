// Tests a paper report or a sweep report in a browser: node section_page_in_browser.mjs PAGE FIGURES
// FIGURES is the number of figures on the page.
import assert from "node:assert/strict";
import { existsSync } from "node:fs";
import { dirname, join } from "node:path";
import { after, test } from "node:test";
import { openPage } from "./browser.mjs";

const [file, figures] = process.argv.slice(2);
const browsers = [];
after(() => Promise.all(browsers.map((browser) => browser.close())));

async function open(options) {
  const opened = await openPage(file, { ...options, isReady: () => document.readyState === "complete" });
  browsers.push(opened.browser);
  return opened;
}

test("opens without problems and requests no other file", async () => {
  const { problems, requests } = await open({});
  assert.deepEqual(problems, []);
  for (const address of requests) assert.match(address, /^(file:.*\/report\.html|data:.*)$/s);
});

test("every linked file and section exists", async () => {
  const { page } = await open({});
  const links = await page.evaluate(() => [...document.links].map((link) => link.getAttribute("href")));
  assert.ok(links.length > 4);
  for (const link of links) {
    const exists = link.startsWith("#") ? await page.locator(`[id="${link.slice(1)}"]`).count() === 1 : existsSync(join(dirname(file), link));
    assert.ok(exists, link);
  }
});

for (const width of [1600, 420]) {
  test(`every figure fits in a window of ${width} px`, async () => {
    const { page } = await open({ width });
    const sizes = await page.evaluate(() =>
      [...document.querySelectorAll("figure.drawn :is(svg, img)")]
        .filter((drawing) => !drawing.parentElement.closest("svg"))
        .map((drawing) => drawing.getBoundingClientRect())
        .map(({ left, right, height }) => ({ left, right, height })));
    assert.equal(sizes.length, Number(figures));
    for (const { left, right, height } of sizes) assert.ok(left >= 0 && right <= width && height > 50, `${left} to ${right}, ${height}`);
    assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), width, "no horizontal overflow");
  });
}

test("the dark theme applies to page and figures", async () => {
  const { page } = await open({ theme: "dark" });
  const brightness = (selector, property) =>
    page.locator(selector).first().evaluate((element, name) => {
      const [r, g, b] = getComputedStyle(element)[name].match(/\d+/g).map(Number);
      return (r + g + b) / 3;
    }, property);
  assert.ok((await brightness("body", "backgroundColor")) < 80);
  assert.ok((await brightness("figure.drawn svg text", "fill")) > 120);
  await page.locator("#theme").click();
  assert.ok((await brightness("body", "backgroundColor")) > 200);
});
