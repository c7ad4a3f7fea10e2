// Plot of lanes over time. Bars in a lane show when it applies.
import { color, words } from "./colors.js";
import { html } from "./dom.js";
import { axis, LEFT_PX, makeTimeChart, timeAxis } from "./time_chart.js";

const LANE_PX = 17;
const BAR_FRACTION = 0.62; // Height of a bar as a fraction of the lane height.
const AXES_PX = 34;
const GOOD = "ok";

const titleOf = (lane) => words(lane.label).replace(/\bh\b/, "H");

function drawBars(chart, lanes) {
  const { ctx, bbox } = chart;
  const half = (chart.valToPos(0, "y", true) - chart.valToPos(1, "y", true)) * (BAR_FRACTION / 2);
  ctx.save();
  ctx.beginPath();
  ctx.rect(bbox.left, bbox.top, bbox.width, bbox.height);
  ctx.clip();
  lanes.forEach((lane, height) => {
    ctx.fillStyle = color(lane.label === GOOD ? "estimate" : "failed");
    const y = chart.valToPos(height, "y", true);
    for (const [from, to] of lane.bars) {
      const left = chart.valToPos(from, "x", true);
      const width = Math.max(chart.valToPos(to, "x", true) - left, devicePixelRatio);
      ctx.fillRect(left, y - half, width, 2 * half);
    }
  });
  ctx.restore();
}

function laneAt(lanes, t_s) {
  return lanes.find((lane) => lane.bars.some(([from, to]) => from <= t_s && t_s < to));
}

/** Draws the plot `spec`. The last lane is on top. */
export function drawLanes(figure, spec, flight, view) {
  const { lanes } = spec;
  const now = html("output", { class: "value" });
  figure.append(html("figcaption", {}, html("span", { class: "title" }, spec.title),
    html("span", { class: "unit" }, "stage at which the processing of each frame ended"),
    html("div", { class: "legend" }, now)));
  const chart = makeTimeChart(
    figure,
    {
      label: `${spec.section}: ${spec.title}`,
      data: [[view.whole.from, view.whole.to], [0, lanes.length - 1]],
      options: {
        height: lanes.length * LANE_PX + AXES_PX,
        scales: { y: { range: () => [-0.7, lanes.length - 0.3] } },
        axes: [
          timeAxis(),
          axis({ size: LEFT_PX, gap: 6, splits: () => lanes.map((lane, height) => height),
            values: () => lanes.map((lane) => titleOf(lane)) }),
        ],
        series: [{}, { show: false }],
      },
    },
    flight,
    view,
  );
  chart.hooks.draw = [(self) => drawBars(self, lanes)];
  const showLane = () => {
    const lane = view.current === null ? null : laneAt(lanes, view.current);
    now.textContent = view.current === null ? "" : lane ? titleOf(lane) : "no frame";
  };
  view.on("pointed", showLane);
  view.on("played", showLane);
  return { chart };
}
