// The picture of a flight's page for the docs: node photograph_page.mjs PAGE PICTURE
import assert from "node:assert/strict";
import { openPage } from "./browser.mjs";

const [file, picture] = process.argv.slice(2);
const { page, browser, complaints } = await openPage(file, { theme: "light", width: 1600, height: 1500 });
await page.waitForFunction(() => document.getElementById("video").readyState >= 2, null, { timeout: 20000 });
await page.waitForTimeout(400);
await page.screenshot({ path: picture });
await browser.close();
assert.deepEqual(complaints, []);
