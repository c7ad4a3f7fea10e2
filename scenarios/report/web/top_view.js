// Ground track of the vehicle, seen from above: X to the right, Y up, equal scales.
import { phaseColor, words } from "./colors.js";
import { html, svg } from "./dom.js";
import { decimals, withMinus } from "./numbers.js";
import { nearestIndex, spanAt } from "./search.js";

const MARGIN = 0.08; // Margin around the content, as a fraction of its size.
const GRID_LINES = 5; // Approximate number per axis.

const number = (value) => Number(value.toFixed(4));

/** Square, in meters, that contains the pad and the true ground track. */
function extent(pad, xs, ys) {
  const half_size = pad ? [pad.sheet_length_m / 2, pad.sheet_width_m / 2] : [0.15, 0.15];
  const points = (values, half) => [-half, half, ...values.filter((value) => value !== null)];
  const [x, y] = [points(xs, half_size[0]), points(ys, half_size[1])];
  const [left, right] = [Math.min(...x), Math.max(...x)];
  const [bottom, top] = [Math.min(...y), Math.max(...y)];
  const size = Math.max(right - left, top - bottom) * (1 + 2 * MARGIN);
  return { left: (left + right - size) / 2, bottom: (bottom + top - size) / 2, size };
}

/** Smallest step of 1, 2 or 5 times a power of ten that is at least `rough`. */
function roundStep(rough) {
  const power = 10 ** Math.floor(Math.log10(rough));
  return power * [1, 2, 5, 10].find((factor) => factor * power >= rough);
}

/** SVG path through points. A null coordinate makes a gap. */
function pathThrough(xs, ys, from = 0, to = xs.length) {
  let path = "";
  let pen = "M";
  for (let i = from; i < to; ++i) {
    if (xs[i] === null || ys[i] === null) {
      pen = "M";
      continue;
    }
    path += `${pen}${number(xs[i])} ${number(ys[i])}`;
    pen = "L";
  }
  return path;
}

/** SVG path of dots. */
function dotsAt(xs, ys) {
  return xs.map((x, i) => (x === null ? "" : `M${number(x)} ${number(ys[i])}h0`)).join("");
}

/** Circle or polygon of the pad, black or white. */
function padShape({ color, center_m: center, radius_m: radius, corners_m: corners }) {
  if (center) return svg("circle", { class: color, cx: center[0], cy: center[1], r: radius });
  return svg("polygon", { class: color, points: corners.join(" ") });
}

/** True ground track, one path per phase. */
function groundTracksOf(phases, times, xs, ys) {
  return phases.map((phase) => {
    const from = nearestIndex(times, phase.from_s);
    const to = nearestIndex(times, phase.to_s) + 1;
    return svg("path", { class: "ground-track", style: `--phase: var(--${phaseColor(phase.name)})`, d: pathThrough(xs, ys, from, to) });
  });
}

function gridOf({ left, bottom, size }) {
  const step = roundStep(size / GRID_LINES);
  const unit = size / 100;
  const label = (value) => withMinus(value.toFixed(decimals(step)));
  const parts = [];
  const text = (x, y, anchor, content) =>
    svg("text", { x, y: -y, "text-anchor": anchor, "font-size": 3.1 * unit, transform: "scale(1 -1)" }, content);
  for (let i = Math.ceil(left / step); i * step < left + size; ++i) {
    const x = i * step;
    parts.push(svg("line", { x1: x, x2: x, y1: bottom, y2: bottom + size }));
    if (x < left + 0.86 * size) parts.push(text(x + unit, bottom + unit, "start", label(x)));
  }
  for (let i = Math.ceil(bottom / step); i * step < bottom + size; ++i) {
    const y = i * step;
    parts.push(svg("line", { x1: left, x2: left + size, y1: y, y2: y }));
    if (y > bottom + 6 * unit && y < bottom + 92 * unit) parts.push(text(left + unit, y + unit, "start", label(y)));
  }
  parts.push(text(left + size - unit, bottom + unit, "end", "x in m"), text(left + unit, bottom + size - 4 * unit, "start", "y in m"));
  return svg("g", { class: "grid" }, ...parts);
}

function cross(x, y, size) {
  return svg("path", { class: "contact", d: `M${x - size} ${y - size}L${x + size} ${y + size}M${x - size} ${y + size}L${x + size} ${y - size}` },
    svg("title", {}, "touchdown point"));
}

function keyOf(flight) {
  const item = (symbol, text) => html("li", {}, symbol, text);
  const swatch = (name, kind) => html("span", { class: `swatch ${kind}`, style: `--phase: var(--${name})` });
  const names = [...new Set(flight.phases.map((phase) => phase.name))];
  const items = names.map((name) => item(swatch(phaseColor(name), "line"), words(name)));
  items.push(item(swatch("vision", "dot"), "vision"), item(swatch("set-point", "ringed"), "set-point"));
  if (flight.touchdown) {
    const { x_m, y_m } = flight.touchdown;
    items.push(item(html("span", { class: "swatch crossed" }, "×"), `touchdown, ${(Math.hypot(x_m, y_m) * 1000).toFixed(1)} mm from the center`));
  }
  return html("ul", { class: "key" }, ...items);
}

/** Draws the top view and moves the vehicle in it to the current time of `view`. */
export function drawTopView(container, flight, view) {
  const { ticks, frames } = flight.track;
  const [xs, ys, yaws, set_xs, set_ys] = ticks.series.map((series) => series.values);
  const [vision_xs, vision_ys] = frames.series.map((series) => series.values);
  const box = extent(flight.pad, xs, ys);
  const arrow = box.size / 28;
  const vehicle = svg("path", { class: "vehicle", d: `M${arrow} 0L${-0.7 * arrow} ${0.6 * arrow}L${-0.35 * arrow} 0L${-0.7 * arrow} ${-0.6 * arrow}Z`, visibility: "hidden" });
  const start = xs.findIndex((x) => x !== null);
  const scene = svg("g", { transform: "scale(1 -1)" },
    ...(flight.pad ? flight.pad.shapes.map(padShape) : []),
    gridOf(box),
    svg("path", { class: "vision", d: dotsAt(vision_xs, vision_ys) }),
    svg("path", { class: "set-point", d: pathThrough(set_xs, set_ys) }),
    ...groundTracksOf(flight.phases, ticks.t_s, xs, ys),
    ...(start < 0 ? [] : [svg("circle", { class: "start", cx: xs[start], cy: ys[start], r: box.size / 90 }, svg("title", {}, "start"))]),
    ...(flight.touchdown ? [cross(flight.touchdown.x_m, flight.touchdown.y_m, box.size / 45)] : []),
    vehicle);
  const drawing = svg("svg", {
    class: "top-view", role: "img", "aria-label": "Ground track of the vehicle, top view",
    viewBox: `${box.left} ${-box.bottom - box.size} ${box.size} ${box.size}`,
  }, scene);
  container.append(drawing, keyOf(flight));

  const showVehicle = () => {
    const i = view.current === null ? -1 : nearestIndex(ticks.t_s, view.current);
    const known = i >= 0 && xs[i] !== null && ys[i] !== null;
    vehicle.setAttribute("visibility", known ? "visible" : "hidden");
    if (!known) return;
    vehicle.style.setProperty("--phase", `var(--${phaseColor(spanAt(flight.phases, view.current)?.name ?? "standby")})`);
    vehicle.setAttribute("transform", `translate(${xs[i]} ${ys[i]}) rotate(${yaws[i] ?? 0})`);
  };
  view.on("pointed", showVehicle);
  view.on("played", showVehicle);
}
