// All plots, under the headings of their sections.
import { html } from "./dom.js";
import { drawCurves } from "./curve_plot.js";
import { drawLanes } from "./lane_plot.js";

/** Draws them; returns what to do with all of them. */
export function drawPlots(place, flight, view) {
  const plots = [];
  let section = null;
  for (const spec of flight.plots) {
    if (spec.section !== section) {
      section = spec.section;
      place.append(html("h3", {}, section));
    }
    const figure = html("figure", { class: "plot" });
    place.append(figure);
    plots.push(spec.lanes ? drawLanes(figure, spec, flight, view) : drawCurves(figure, spec, flight, view));
  }
  const fit = () => {
    const width = place.clientWidth;
    for (const plot of plots) plot.chart.setSize({ width, height: plot.chart.height });
  };
  new ResizeObserver(fit).observe(place);
  return {
    charts: plots.map((plot) => plot.chart),
    redraw: () => plots.forEach((plot) => plot.chart.redraw()),
    fit,
  };
}
