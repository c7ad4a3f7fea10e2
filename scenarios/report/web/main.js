// Entry point of the flight report: reads the embedded flight data and draws the page.
import { drawPlots } from "./plots.js";
import { prepareForPrint } from "./print.js";
import { TimeView } from "./time_view.js";
import { followTheme } from "./theme.js";
import { drawTimeline } from "./timeline.js";
import { drawTopView } from "./top_view.js";
import { connectVideo } from "./video.js";

const flight = JSON.parse(document.getElementById("flight").textContent);
const view = new TimeView(flight.duration_s);

drawTimeline(document.getElementById("timeline"), flight, view);
drawTopView(document.getElementById("top-view"), flight, view);
const plots = drawPlots(document.getElementById("plots"), flight, view);
connectVideo(document.getElementById("video"), view);
followTheme(document.getElementById("theme"), () => plots.redraw());
prepareForPrint(plots);

// For inspection in the browser console and for the tests.
window.touchdown = { flight, view, plots: plots.charts };
