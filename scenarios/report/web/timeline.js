// Timeline above the plots: a button for each phase and event, which zooms to its time span.
import { phaseColor, words } from "./colors.js";
import { html } from "./dom.js";
import { spanAt } from "./search.js";

const MAX_RIGHTWARD = 85; // In percent of the width. The labels of later events are to the left of the event.
const MARGIN_FRACTION = 0.08; // Margin on both sides after zooming to a span, as a fraction of its duration.

function zoomTo(view, span) {
  const margin = Math.max(span.to_s - span.from_s, 0.2) * MARGIN_FRACTION;
  view.zoom(span.from_s - margin, span.to_s + margin);
}

function blockOf(span, kind, style, view) {
  const name = words(span.name);
  const title = `${name}, ${span.from_s.toFixed(2)} to ${span.to_s.toFixed(2)} s. Click to zoom.`;
  const block = html("button", { type: "button", class: kind, title, style, onclick: () => zoomTo(view, span) }, html("span", {}, name));
  return { block, span };
}

/** Draws the timeline and updates it when the view changes. */
export function drawTimeline(container, flight, view) {
  const touchdown = flight.touchdown && { name: "touchdown point", from_s: flight.touchdown.t_s, to_s: flight.touchdown.t_s };
  const phases = flight.phases.map((span) => blockOf(span, "phase", `--phase: var(--${phaseColor(span.name)})`, view));
  const events = flight.events.map((span) => blockOf(span, "event", null, view));
  if (touchdown) events.push(blockOf({ ...touchdown, name: "contact" }, "event mark", null, view));
  const pointer = html("div", { class: "pointer", hidden: true });
  const clock = html("output", { class: "clock" });
  const reset = html("button", { type: "button", class: "button", onclick: () => view.reset() }, "Whole flight");
  const phaseRow = html("div", { class: "row" }, ...phases.map(({ block }) => block));
  const eventRow = html("div", { class: "row events" }, ...events.map(({ block }) => block));
  const track = html("div", { class: "track" }, phaseRow, ...(events.length > 0 ? [eventRow] : []), pointer);
  container.append(html("div", { class: "timeline-head" }, clock, reset), track);

  const percent = (t_s) => ((t_s - view.range.from) / view.span) * 100;
  const showRange = () => {
    for (const { block, span } of [...phases, ...events]) {
      const from = Math.max(percent(span.from_s), 0);
      const to = Math.min(percent(span.to_s), 100);
      block.hidden = to < from;
      if (block.classList.contains("phase")) block.style.width = `${to - from}%`;
      block.classList.toggle("leftward", block.classList.contains("event") && from > MAX_RIGHTWARD);
      block.style.left = block.classList.contains("leftward") ? null : `${from}%`;
      block.style.right = block.classList.contains("leftward") ? `${100 - from}%` : null;
    }
    reset.disabled = view.range.from <= view.whole.from && view.range.to >= view.whole.to;
    showTime();
  };
  const showTime = () => {
    const t_s = view.current;
    const phase = t_s === null ? null : spanAt(flight.phases, t_s);
    clock.textContent = t_s === null ? `${view.range.from.toFixed(2)} – ${view.range.to.toFixed(2)} s` : `${t_s.toFixed(3)} s  ${words(phase?.name ?? "")}`;
    pointer.hidden = t_s === null || t_s < view.range.from || t_s > view.range.to;
    if (!pointer.hidden) pointer.style.left = `${percent(t_s)}%`;
  };
  view.on("range", showRange);
  view.on("pointed", showTime);
  view.on("played", showTime);
  showRange();
}
