// Opens a page of a report from disk in Debian's Chromium, and watches what it does. NODE_MODULES is where playwright-core is.
import { createRequire } from "node:module";
import { resolve } from "node:path";
import { pathToFileURL } from "node:url";

const require = createRequire(resolve(process.env.NODE_MODULES ?? "build/release/scenarios/report/web/node_modules", "package.json"));
const { chromium } = require("playwright-core");

const flightIsPlotted = () => window.touchdown?.plots.length > 0;

/** `complaints` fills with whatever goes wrong on the page, `requests` with the addresses that it asks for. */
export async function openPage(file, { theme = "light", width = 1600, height = 1000, isReady = flightIsPlotted } = {}) {
  const browser = await chromium.launch({
    executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
    args: process.getuid() === 0 ? ["--no-sandbox"] : [],
  });
  const page = await browser.newPage({ colorScheme: theme, viewport: { width, height } });
  const complaints = [];
  const requests = [];
  page.on("console", (message) => {
    if (["error", "warning"].includes(message.type())) complaints.push(message.text());
  });
  page.on("pageerror", (error) => complaints.push(String(error)));
  page.on("request", (request) => requests.push(request.url()));
  await page.goto(pathToFileURL(resolve(file)).href);
  await page.waitForFunction(isReady, null, { timeout: 20000 }).catch((error) => complaints.push(String(error)));
  return { browser, page, complaints, requests };
}
