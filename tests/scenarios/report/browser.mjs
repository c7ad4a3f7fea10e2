// Opens a report page from disk in Chromium and records problems and requests. The environment variable NODE_MODULES is
// the folder of playwright-core.
import { createRequire } from "node:module";
import { resolve } from "node:path";
import { pathToFileURL } from "node:url";

const require = createRequire(resolve(process.env.NODE_MODULES ?? "build/release/scenarios/report/web/node_modules", "package.json"));
const { chromium } = require("playwright-core");

const flightIsPlotted = () => window.touchdown?.plots.length > 0;

/** Opens a page. `problems` receives the errors and warnings of the page, `requests` the addresses that it requests. */
export async function openPage(file, { theme = "light", width = 1600, height = 1000, isReady = flightIsPlotted } = {}) {
  const browser = await chromium.launch({
    executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
    args: process.getuid() === 0 ? ["--no-sandbox"] : [],
  });
  const page = await browser.newPage({ colorScheme: theme, viewport: { width, height } });
  const problems = [];
  const requests = [];
  page.on("console", (message) => {
    if (["error", "warning"].includes(message.type())) problems.push(message.text());
  });
  page.on("pageerror", (error) => problems.push(String(error)));
  page.on("request", (request) => requests.push(request.url()));
  await page.goto(pathToFileURL(resolve(file)).href);
  await page.waitForFunction(isReady, null, { timeout: 20000 }).catch((error) => problems.push(String(error)));
  return { browser, page, problems, requests };
}
