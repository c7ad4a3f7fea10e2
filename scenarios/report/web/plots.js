// Draws all plots, grouped by section.
import { html } from "./dom.js";
import { drawCurves } from "./curve_plot.js";
import { drawLanes } from "./lane_plot.js";

/** Draws the plots. Returns the charts and functions to redraw them and to fit them to the page width. */
export function drawPlots(container, flight, view) {
  const plots = [];
  let section = null;
  for (const spec of flight.plots) {
    if (spec.section !== section) {
      section = spec.section;
      container.append(html("h3", {}, section));
    }
    const figure = html("figure", { class: "plot" });
    container.append(figure);
    plots.push(spec.lanes ? drawLanes(figure, spec, flight, view) : drawCurves(figure, spec, flight, view));
  }
  const fit = () => {
    const width = container.clientWidth;
    for (const plot of plots) plot.chart.setSize({ width, height: plot.chart.height });
  };
  new ResizeObserver(fit).observe(container);
  return {
    charts: plots.map((plot) => plot.chart),
    redraw: () => plots.forEach((plot) => plot.chart.redraw()),
    fit,
  };
}
