// The legend of a plot: a button for each curve, with its value at the current time.
import { html, svg } from "./dom.js";
import { withMinus } from "./numbers.js";
import { valueAt } from "./search.js";

const REACH_S = 0.05;
const DASHES = { "set-point": "5 3" };

function sample(role) {
  const mark =
    role === "vision"
      ? svg("circle", { cx: 9, cy: 5, r: 2.5, fill: "currentColor" })
      : svg("line", { x1: 1, y1: 5, x2: 17, y2: 5, stroke: "currentColor", "stroke-width": 2, "stroke-dasharray": DASHES[role] ?? null });
  return svg("svg", { class: "sample", viewBox: "0 0 18 10", width: 18, height: 10, "aria-hidden": "true", style: `color: var(--${role})` }, mark);
}

function text(value) {
  if (value === null || value === undefined) return "–";
  const size = Math.abs(value);
  const digits = size >= 100 ? 1 : size >= 10 ? 2 : 3;
  return withMinus(value.toFixed(digits));
}

/**
 * `curves` is a list of {label, role, times, values}; `onToggle` is called with a curve's index and whether it is to be
 * seen. Returns the element, and `show(t_s)` for its values at a time, null for none.
 */
export function makeLegend(curves, onToggle) {
  const values = curves.map(() => html("output", { class: "value" }));
  const buttons = curves.map((curve, index) => {
    const button = html("button", { type: "button", class: "curve", "aria-pressed": "true", title: `Hide or show ${curve.label}` },
      sample(curve.role), curve.label, values[index]);
    button.addEventListener("click", () => {
      const seen = button.getAttribute("aria-pressed") !== "true";
      button.setAttribute("aria-pressed", String(seen));
      onToggle(index, seen);
    });
    return button;
  });
  const show = (t_s) => {
    curves.forEach((curve, index) => {
      values[index].textContent = t_s === null ? "" : text(valueAt(curve.times, curve.values, t_s, REACH_S));
    });
  };
  return { element: html("div", { class: "legend" }, ...buttons), show };
}
