// Tests the interaction with a flight report in a browser: node page_in_browser.mjs FLIGHT [OTHER]...
// FLIGHT is the report of a flight with video. Each OTHER is a report without video. The pad of the first OTHER has a
// disc with a diameter of 10 mm at (0.02, 0.05) m and a bar of 20 x 4 mm at (-0.02, 0.05) m, rotated by 30 degrees.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { openPage } from "./browser.mjs";

const [flightPage, ...otherPages] = process.argv.slice(2);
const browsers = [];
let page, problems, requests;

async function open(file, options) {
  const opened = await openPage(file, options);
  browsers.push(opened.browser);
  return opened;
}

before(async () => {
  ({ page, problems, requests } = await open(flightPage));
  await page.waitForFunction(() => document.getElementById("video").readyState >= 1, null, { timeout: 20000 });
  await page.evaluate(() => {
    window.pixelsOf = ({ ctx: { canvas } }) => {
      const copy = new OffscreenCanvas(canvas.width, canvas.height).getContext("2d", { willReadFrequently: true });
      copy.drawImage(canvas, 0, 0);
      return copy.getImageData(0, 0, canvas.width, canvas.height).data;
    };
  });
});
after(() => Promise.all(browsers.map((browser) => browser.close())));

const count = () => page.evaluate(() => touchdown.plots.length);
const ranges = () => page.evaluate(() => touchdown.plots.map(({ scales: { x } }) => [x.min, x.max]));
const reset = () => page.evaluate(() => touchdown.view.reset());

/** Window position in a plot at the fraction `across` of its width and at half its height. */
async function positionIn(index, across) {
  const plot = page.locator(".plot .u-over").nth(index);
  await plot.scrollIntoViewIfNeeded();
  await plot.evaluate((element) => element.scrollIntoView({ block: "center" }));
  const box = await plot.boundingBox();
  return { x: box.x + across * box.width, y: box.y + box.height / 2 };
}

async function drag(index, from, to) {
  const [start, end] = [await positionIn(index, from), await positionIn(index, to)];
  await page.mouse.move(start.x, start.y);
  await page.mouse.down();
  await page.mouse.move(end.x, end.y, { steps: 4 });
  await page.mouse.up();
}

function assertNear(actual, expected, tolerance, what) {
  assert.ok(Math.abs(actual - expected) <= tolerance, `${what}: ${actual} differs from ${expected} by more than ${tolerance}`);
}

test("opens without problems and requests only local files", () => {
  assert.deepEqual(problems, []);
  for (const address of requests) assert.match(address, /^(file|data|blob):/);
});

test("title contains scenario, seed and verdict", async () => {
  assert.equal(await page.title(), "takeoff_hover_land, seed 1: Passed");
});

test("draws every curve of every plot", async () => {
  const changed = await page.evaluate(() => {
    const difference = (a, b) => a.reduce((sum, value, i) => sum + (value !== b[i] ? 1 : 0), 0);
    const nextFrame = () => new Promise((done) => requestAnimationFrame(() => setTimeout(done)));
    const setVisible = (chart, isVisible) =>
      chart.series.forEach((_, i) => i > 0 && chart.setSeries(i, { show: isVisible(i) }));
    return (async () => {
      const differences = [];
      for (const [index, chart] of touchdown.plots.entries()) {
        const { title, lanes } = touchdown.flight.plots[index];
        if (lanes) continue;
        const [min, max] = [chart.scales.y.min, chart.scales.y.max];
        const originalRange = chart.scales.y.range;
        chart.scales.y.range = () => [min, max];
        setVisible(chart, () => false);
        await nextFrame();
        const empty = pixelsOf(chart);
        for (let i = 1; i < chart.series.length; ++i) {
          setVisible(chart, (k) => k === i);
          await nextFrame();
          differences.push([`${title} ${i}`, difference(empty, pixelsOf(chart))]);
        }
        chart.scales.y.range = originalRange;
        setVisible(chart, () => true);
        await nextFrame();
      }
      return differences;
    })();
  });
  assert.equal(changed.length, 6 * 4 + 4 * 3 + 1 + 4);
  for (const [curve, pixels] of changed) assert.ok(pixels > 300, `${curve}: ${pixels} values of the image differ`);
});

test("detection lanes show frames with and without the pad", async () => {
  const colors = await page.evaluate(() => {
    const index = touchdown.flight.plots.findIndex(({ lanes }) => lanes);
    const expected = ["--estimate", "--failed"].map((name) => {
      const [, ...hex] = getComputedStyle(document.documentElement).getPropertyValue(name).trim().match(/#(..)(..)(..)/);
      return hex.map((digits) => parseInt(digits, 16));
    });
    const data = pixelsOf(touchdown.plots[index]);
    const found = expected.map(() => 0);
    for (let i = 0; i < data.length; i += 4) {
      expected.forEach((color, k) => (found[k] += color.every((value, c) => value === data[i + c]) ? 1 : 0));
    }
    return found;
  });
  for (const pixels of colors) assert.ok(pixels > 200, `${colors}`);
});

test("dragging in one plot zooms all plots, double-clicking shows the whole flight", async () => {
  const whole = await ranges();
  const [min, max] = whole[0];
  await drag(1, 0.3, 0.6);
  const zoomed = await ranges();
  assert.equal(zoomed.length, await count());
  for (const [from, to] of zoomed) {
    assertNear(from, min + 0.3 * (max - min), 0.01 * (max - min), "begin");
    assertNear(to, min + 0.6 * (max - min), 0.01 * (max - min), "end");
    assert.deepEqual([from, to], zoomed[0]);
  }
  const position = await positionIn(4, 0.5);
  await page.mouse.dblclick(position.x, position.y);
  assert.deepEqual(await ranges(), whole);
});

test("timeline buttons zoom to their phase", async () => {
  await page.getByRole("button", { name: /hover/ }).click();
  const { from_s, to_s } = await page.evaluate(() => touchdown.flight.phases.find(({ name }) => name === "hover"));
  for (const [from, to] of await ranges()) {
    assert.ok(from <= from_s && to >= to_s && to - from < 1.3 * (to_s - from_s), `${from} ${to}`);
  }
  await page.getByRole("button", { name: "Whole flight" }).click();
  assertNear((await ranges())[0][0], 0, 1e-9, "begin");
});

test("clicking in a plot moves the video to that time", async () => {
  const duration = await page.evaluate(() => touchdown.flight.duration_s);
  for (const [index, across] of [[0, 0.25], [8, 0.5], [12, 0.75]]) {
    const position = await positionIn(index, across);
    await page.mouse.click(position.x, position.y);
    await page.waitForFunction(() => !document.getElementById("video").seeking);
    const time = await page.evaluate(() => document.getElementById("video").currentTime);
    assertNear(time, across * duration, 0.01 * duration, "video time");
    assert.equal(await page.locator(".played:visible").count(), await count());
  }
});

test("all plots show the cursor and their values at its time", async () => {
  const position = await positionIn(2, 0.5);
  await page.mouse.move(position.x, position.y);
  const lefts = await page.evaluate(() => touchdown.plots.map(({ cursor }) => Math.round(cursor.left)));
  assert.equal(new Set(lefts).size, 1, `${lefts}`);
  assert.ok(lefts[0] > 0);
  const values = await page.locator(".plot .curve .value").allTextContents();
  assert.ok(values.length > 30);
  for (const value of values) assert.match(value, /^(−?[0-9.]+|–)$/);
  const truth = await page.evaluate(() => {
    const { t_s, series } = touchdown.flight.plots[2].sheets[1];
    const at = t_s.findIndex((t) => t >= touchdown.view.pointed);
    return series.find(({ label }) => label === "truth").values[at];
  });
  assertNear(Number(values[8].replace("−", "-")), truth, 0.01, "true height in the legend");
  assert.equal(await page.locator(".vehicle").getAttribute("visibility"), "visible");
});

test("legend buttons hide and show curves", async () => {
  const button = page.getByRole("button", { name: "truth" }).first();
  const countVisible = () => page.evaluate(() => touchdown.plots[0].series.filter(({ show }) => show).length);
  const all = await countVisible();
  await button.click();
  assert.equal(await countVisible(), all - 1);
  assert.equal(await button.getAttribute("aria-pressed"), "false");
  await button.click();
  assert.equal(await countVisible(), all);
});

test("keys move the cursor, zoom, seek, play and reset", async () => {
  const plot = page.locator(".chart").nth(3);
  await plot.focus();
  await page.evaluate(() => touchdown.view.seek(5));
  await page.keyboard.press("ArrowRight");
  const pointed = await page.evaluate(() => touchdown.view.pointed);
  assertNear(pointed, 5 + (await ranges())[0][1] / 100, 0.01, "time of the cursor");
  await page.keyboard.press("+");
  const [from, to] = (await ranges())[7];
  assert.ok(to - from < 8 && from < pointed && pointed < to, `${from} ${to}`);
  await page.keyboard.press("Enter");
  assertNear(await page.evaluate(() => touchdown.view.played), pointed, 1e-6, "time after seeking");
  await page.keyboard.press(" ");
  await page.waitForFunction((t) => touchdown.view.played > t + 0.2 && !document.getElementById("video").paused, pointed, { timeout: 8000 });
  await page.keyboard.press(" ");
  await page.waitForFunction(() => document.getElementById("video").paused);
  await page.keyboard.press("Escape");
  assertNear((await ranges())[0][0], 0, 1e-9, "begin");
});

test("the video stays visible next to the plots in a wide window", async () => {
  await positionIn(12, 0.5);
  const box = await page.locator("#video").boundingBox();
  assert.ok(box.y >= 0 && box.y + box.height <= page.viewportSize().height);
});

test("the theme button switches page and plots between light and dark", async () => {
  const appearance = () =>
    page.evaluate(() => ({
      theme: document.documentElement.dataset.theme,
      paper: getComputedStyle(document.body).backgroundColor,
      ink: touchdown.plots.map((chart) => pixelsOf(chart).reduce((sum, value) => sum + value, 0)),
    }));
  const light = await appearance();
  assert.equal(light.theme, "light");
  const button = page.getByRole("button", { name: /light and dark/ });
  await button.click();
  const dark = await appearance();
  assert.equal(dark.theme, "dark");
  assert.notEqual(dark.paper, light.paper);
  dark.ink.forEach((ink, index) => assert.notEqual(ink, light.ink[index], `plot ${index}`));
  await button.click();
  assert.deepEqual(await appearance(), light);
});

test("follows the system theme", async () => {
  const dark = await open(flightPage, { theme: "dark" });
  assert.equal(await dark.page.evaluate(() => document.documentElement.dataset.theme), "dark");
  assert.deepEqual(dark.problems, []);
});

test("uses one column in a narrow window", async () => {
  const narrow = await open(flightPage, { width: 420, height: 900 });
  const { content, video, plot } = await narrow.page.evaluate(() => ({
    content: document.documentElement.scrollWidth,
    video: document.getElementById("video").getBoundingClientRect().bottom,
    plot: document.querySelector(".plot").getBoundingClientRect().top,
  }));
  assert.equal(content, 420);
  assert.ok(video < plot);
  assert.deepEqual(narrow.problems, []);
});

test("prints with the light theme and with plots", async () => {
  await page.getByRole("button", { name: /light and dark/ }).click();
  const printed = page.evaluate(() => new Promise((done) => {
    addEventListener("beforeprint", () => done(document.documentElement.dataset.theme), { once: true });
  }));
  const pdf = await page.pdf({ format: "A4" });
  assert.ok(pdf.length > 50000, `${pdf.length} bytes`);
  assert.equal(await printed, "light");
  await page.waitForFunction(() => document.documentElement.dataset.theme === "dark");
});

test("the interactions caused no problems", () => assert.deepEqual(problems, []));

test("the markings of the pad are drawn at their positions", async () => {
  const { page: marked } = await open(otherPages[0]);
  const points = await marked.evaluate(() => {
    const [, , disc, bar] = document.querySelectorAll(".top-view .black"); // After ring and H.
    const of = (name) => disc[name].baseVal.value;
    const corners = [...bar.points].map(({ x, y }) => [x, y]);
    const middle = (i, j) => [0, 1].map((k) => (corners[i][k] + corners[j][k]) / 2);
    return {
      discCenter: [of("cx"), of("cy")],
      discRim: [of("cx") + of("r"), of("cy")],
      barStart: middle(1, 2),
      barEnd: middle(3, 0),
      barSide: middle(2, 3),
    };
  });
  const [along, across] = [[Math.cos(Math.PI / 6), 0.5], [-0.5, Math.cos(Math.PI / 6)]];
  const expected = {
    discCenter: [0.02, 0.05],
    discRim: [0.025, 0.05],
    barStart: [-0.02 - 0.01 * along[0], 0.05 - 0.01 * along[1]],
    barEnd: [-0.02 + 0.01 * along[0], 0.05 + 0.01 * along[1]],
    barSide: [-0.02 - 0.002 * across[0], 0.05 - 0.002 * across[1]],
  };
  for (const [name, point] of Object.entries(expected)) {
    point.forEach((value, i) => assertNear(points[name][i], value, 1e-5, `${name} ${"xy"[i]}`));
  }
});

for (const other of otherPages) {
  test(`${other} opens without problems`, async () => {
    const opened = await open(other);
    assert.deepEqual(opened.problems, []);
    assert.equal(await opened.page.locator(".plot canvas").count(), 13);
    assert.equal(await opened.page.locator("video").count(), 0);
    await opened.page.locator(".plot .u-over").first().click();
    await opened.page.locator(".plot .u-over").first().dblclick();
    await opened.page.keyboard.press("Escape");
    assert.deepEqual(opened.problems, []);
  });
}
