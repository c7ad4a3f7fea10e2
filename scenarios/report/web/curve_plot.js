// Plot of curves over time.
import uPlot from "uplot";
import { color } from "./colors.js";
import { html } from "./dom.js";
import { makeLegend } from "./legend.js";
import { makeTimeChart, timeAxis, valueAxis } from "./time_chart.js";

const HEIGHT_PX = 168;
const WIDTHS = { truth: 2, estimate: 1.5, "set-point": 1.5 };
const DASHES = { "set-point": [6, 4] };
const MIN_SPAN = { m: 0.02, mm: 2, deg: 0.5, ms: 1, "rad/s": 20 }; // Smallest range of the value axis, by unit.
const UNITS_FROM_ZERO = ["ms"];
const LEGEND_ORDER = ["truth", "estimate", "set-point", "vision"];

function styled(curve) {
  const stroke = () => color(curve.role);
  if (curve.role === "vision") {
    return { stroke, fill: stroke, paths: () => null, points: { show: true, size: 3.5, width: 0, stroke, fill: stroke } };
  }
  return { stroke, width: WIDTHS[curve.role] ?? 1.25, dash: DASHES[curve.role], points: { show: false } };
}

function valueRange(unit) {
  return (chart, min, max) => {
    if (min === null || max === null) return [0, MIN_SPAN[unit]];
    const margin = Math.max(0.06 * (max - min), (MIN_SPAN[unit] - (max - min)) / 2);
    return [UNITS_FROM_ZERO.includes(unit) ? Math.min(0, min) : min - margin, max + margin];
  };
}

/** Draws the plot `spec`, a list of sheets. The series of a sheet share their times. */
export function drawCurves(figure, spec, flight, view) {
  const curves = spec.sheets.flatMap((sheet) => sheet.series.map((series) => ({ ...series, times: sheet.t_s })));
  const ordered = [...curves].sort((a, b) => LEGEND_ORDER.indexOf(a.role) - LEGEND_ORDER.indexOf(b.role));
  const legend = makeLegend(ordered, (index, visible) =>
    chart.setSeries(curves.indexOf(ordered[index]) + 1, { show: visible }));
  figure.append(html("figcaption", {}, html("span", { class: "title" }, spec.title), legend.element));
  const chart = makeTimeChart(
    figure,
    {
      label: `${spec.section}: ${spec.title} in ${spec.unit}`,
      data: uPlot.join(spec.sheets.map((sheet) => [sheet.t_s, ...sheet.series.map((series) => series.values)])),
      options: {
        height: HEIGHT_PX,
        scales: { y: { range: valueRange(spec.unit) } },
        axes: [timeAxis(), valueAxis(spec.unit)],
        series: [{}, ...curves.map(styled)],
      },
    },
    flight,
    view,
  );
  const showValues = () => legend.show(view.current);
  view.on("pointed", showValues);
  view.on("played", showValues);
  return { chart };
}
