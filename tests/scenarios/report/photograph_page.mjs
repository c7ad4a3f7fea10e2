// The picture of a page for the docs: node photograph_page.mjs PAGE PICTURE WIDTH HEIGHT
import assert from "node:assert/strict";
import { openPage } from "./browser.mjs";

const [file, picture, width, height] = process.argv.slice(2);
const isReady = () => document.readyState === "complete" && (window.touchdown?.plots?.length > 0 || !document.getElementById("video"));
const { page, browser, complaints } = await openPage(file, { theme: "light", width: Number(width), height: Number(height), isReady });
await page.waitForFunction(() => (document.getElementById("video")?.readyState ?? 2) >= 2, null, { timeout: 20000 });
await page.waitForTimeout(400);
await page.screenshot({ path: picture });
await browser.close();
assert.deepEqual(complaints, []);
