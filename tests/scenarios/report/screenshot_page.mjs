// Writes a screenshot of a page: node screenshot_page.mjs PAGE IMAGE WIDTH HEIGHT
import assert from "node:assert/strict";
import { openPage } from "./browser.mjs";

const [file, image, width, height] = process.argv.slice(2);
const isReady = () => document.readyState === "complete" && (window.touchdown?.plots?.length > 0 || !document.getElementById("video"));
const { page, browser, problems } = await openPage(file, { theme: "light", width: Number(width), height: Number(height), isReady });
await page.waitForFunction(() => (document.getElementById("video")?.readyState ?? 2) >= 2, null, { timeout: 20000 });
await page.waitForTimeout(400);
await page.screenshot({ path: image });
await browser.close();
assert.deepEqual(problems, []);
