// Photographs a flight's page, as docs/images/report.png was made:
//   node tests/scenarios/report/photograph_page.mjs out/takeoff_hover_land/report.html docs/images/report.png light 1600 1000
import { openPage } from "./browser.mjs";

const [file, picture, theme = "light", width = "1600", height = ""] = process.argv.slice(2);
const { page, browser } = await openPage(file, { theme, width: Number(width), height: Number(height || 1000) });
await page.waitForTimeout(400);
await page.screenshot({ path: picture, fullPage: height === "" });
await browser.close();
