// A uPlot chart over flight time. All charts share range, cursor and video time through a TimeView.
import uPlot from "uplot";
import { bandsOf } from "./bands.js";
import { color } from "./colors.js";
import { html } from "./dom.js";
import { decimals, withMinus } from "./numbers.js";

const AXIS_FONT = '11px system-ui, -apple-system, "Segoe UI", sans-serif';
const LEFT_PX = 90; // Left margin of every plot and of the timeline; equals --axis in the style sheet.
const RIGHT_PX = 14;
const MIN_DRAG_PX = 4;

const tick = (value, step) => withMinus(value.toFixed(decimals(step)));

function axis(extra) {
  return {
    font: AXIS_FONT,
    labelFont: AXIS_FONT,
    stroke: () => color("muted"),
    grid: { stroke: () => color("grid"), width: 1 },
    ticks: { show: false },
    ...extra,
  };
}

export const timeAxis = () =>
  axis({ size: 24, gap: 4, space: 64, values: (chart, splits, index, space, step) => splits.map((t) => `${tick(t, step)} s`) });

export const valueAxis = (unit) =>
  axis({ size: LEFT_PX - 18, labelSize: 18, labelGap: 0, gap: 6, space: 28, label: unit,
    values: (chart, splits, index, space, step) => splits.map((value) => tick(value, step)) });

export { axis, LEFT_PX };

/**
 * Creates the chart in `figure`. `options` are options of uPlot: series, axes, the scale y, height. `label` is the
 * accessible name of the chart.
 */
export function makeTimeChart(figure, { label, data, options }, flight, view) {
  const container = html("div", { class: "chart", tabindex: 0, role: "group", "aria-label": `${label}, over time` });
  figure.append(container);
  const chart = new uPlot(
    {
      width: figure.clientWidth || 600,
      padding: [8, RIGHT_PX, 0, 0],
      legend: { show: false },
      ...options,
      scales: { x: { time: false, range: () => [view.range.from, view.range.to] }, ...options.scales },
      cursor: {
        y: false,
        points: { show: false },
        drag: { x: true, y: false, dist: MIN_DRAG_PX, setScale: false },
        bind: { dblclick: () => () => view.reset() },
      },
      hooks: {
        drawClear: [bandsOf(flight)],
        setSelect: [(self) => zoomToSelection(self, view)],
        setCursor: [(self) => view.point(self.cursor.left >= 0 ? self.posToVal(self.cursor.left, "x") : null)],
      },
    },
    data,
    container,
  );
  follow(chart, view);
  chart.over.addEventListener("click", (event) => {
    view.seek(chart.posToVal(event.clientX - chart.over.getBoundingClientRect().left, "x"));
  });
  listenToKeys(container, view);
  return chart;
}

function zoomToSelection(chart, view) {
  const { left, width } = chart.select;
  if (width < MIN_DRAG_PX) return;
  chart.setSelect({ left: 0, width: 0, top: 0, height: 0 }, false);
  view.zoom(chart.posToVal(left, "x"), chart.posToVal(left + width, "x"));
}

/** Updates range, cursor and video time of the chart when the view changes. */
function follow(chart, view) {
  const played = html("div", { class: "played", hidden: true });
  chart.over.append(played);
  const showPlayed = () => {
    const visible = view.played !== null && view.played >= view.range.from && view.played <= view.range.to;
    played.hidden = !visible;
    if (visible) played.style.left = `${chart.valToPos(view.played, "x")}px`;
  };
  view.on("range", () => {
    chart.setScale("x", { min: view.range.from, max: view.range.to });
    showPlayed();
  });
  let pressed = false; // While the user drags, the mouse controls the cursor.
  chart.over.addEventListener("mousedown", () => (pressed = true), { capture: true });
  addEventListener("mouseup", () => (pressed = false));
  view.on("pointed", () => {
    if (pressed) return;
    const left = view.pointed === null ? -10 : chart.valToPos(view.pointed, "x");
    chart.setCursor({ left, top: left < 0 ? -10 : 0 }, false);
  });
  view.on("played", showPlayed);
  new ResizeObserver(showPlayed).observe(chart.over);
}

function listenToKeys(container, view) {
  const step = (event) => (view.span / 100) * (event.shiftKey ? 10 : 1);
  const cursor = () => view.current ?? (view.range.from + view.range.to) / 2;
  const actions = {
    ArrowLeft: (event) => view.point(cursor() - step(event)),
    ArrowRight: (event) => view.point(cursor() + step(event)),
    "+": () => view.scale(0.5, cursor()),
    "=": () => view.scale(0.5, cursor()),
    "-": () => view.scale(2, cursor()),
    Enter: () => view.seek(cursor()),
    " ": () => view.toggle(),
    Escape: () => view.reset(),
  };
  container.addEventListener("keydown", (event) => {
    const action = actions[event.key];
    if (!action || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    action(event);
  });
  container.addEventListener("blur", () => view.point(null));
}
