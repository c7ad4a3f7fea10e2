// Legend of a plot: one button per curve, with the value of the curve at the current time.
import { html, svg } from "./dom.js";
import { withMinus } from "./numbers.js";
import { valueAt } from "./search.js";

const MAX_DISTANCE_S = 0.05;
const DASHES = { "set-point": "5 3" };

function sample(role) {
  const symbol =
    role === "vision"
      ? svg("circle", { cx: 9, cy: 5, r: 2.5, fill: "currentColor" })
      : svg("line", { x1: 1, y1: 5, x2: 17, y2: 5, stroke: "currentColor", "stroke-width": 2, "stroke-dasharray": DASHES[role] ?? null });
  return svg("svg", { class: "sample", viewBox: "0 0 18 10", width: 18, height: 10, "aria-hidden": "true", style: `color: var(--${role})` }, symbol);
}

function text(value) {
  if (value === null || value === undefined) return "–";
  const size = Math.abs(value);
  const digits = size >= 100 ? 1 : size >= 10 ? 2 : 3;
  return withMinus(value.toFixed(digits));
}

/**
 * Creates a legend. `curves` is a list of {label, role, times, values}. `onToggle(index, visible)` is called when the
 * user hides or shows a curve. Returns the element and a function `show(t_s)` that displays the values at a time; null
 * clears them.
 */
export function makeLegend(curves, onToggle) {
  const values = curves.map(() => html("output", { class: "value" }));
  const buttons = curves.map((curve, index) => {
    const button = html("button", { type: "button", class: "curve", "aria-pressed": "true", title: `Hide or show ${curve.label}` },
      sample(curve.role), curve.label, values[index]);
    button.addEventListener("click", () => {
      const visible = button.getAttribute("aria-pressed") !== "true";
      button.setAttribute("aria-pressed", String(visible));
      onToggle(index, visible);
    });
    return button;
  });
  const show = (t_s) => {
    curves.forEach((curve, index) => {
      values[index].textContent = t_s === null ? "" : text(valueAt(curve.times, curve.values, t_s, MAX_DISTANCE_S));
    });
  };
  return { element: html("div", { class: "legend" }, ...buttons), show };
}
