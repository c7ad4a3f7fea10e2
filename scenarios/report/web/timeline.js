// The strip over the plots: phases and events by name; each button zooms to what it names.
import { phaseColor, words } from "./colors.js";
import { html } from "./dom.js";
import { spanAt } from "./search.js";

const LAST_RIGHTWARD = 85; // Per cent of the strip: names of later events are written to the left of them.
const AROUND = 0.08; // Of a phase's length, that is shown on both sides of it.

function zoomTo(view, span) {
  const margin = Math.max(span.to_s - span.from_s, 0.2) * AROUND;
  view.zoom(span.from_s - margin, span.to_s + margin);
}

function blockOf(span, kind, style, view) {
  const name = words(span.name);
  const title = `${name}, ${span.from_s.toFixed(2)} to ${span.to_s.toFixed(2)} s: zoom there`;
  const block = html("button", { type: "button", class: kind, title, style, onclick: () => zoomTo(view, span) }, html("span", {}, name));
  return { block, span };
}

/** Draws the strip, and keeps it at the view's range and time. */
export function drawTimeline(place, flight, view) {
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
  place.append(html("div", { class: "timeline-head" }, clock, reset), track);

  const percent = (t_s) => ((t_s - view.range.from) / view.span) * 100;
  const showRange = () => {
    for (const { block, span } of [...phases, ...events]) {
      const from = Math.max(percent(span.from_s), 0);
      const to = Math.min(percent(span.to_s), 100);
      block.hidden = to < from;
      if (block.classList.contains("phase")) block.style.width = `${to - from}%`;
      block.classList.toggle("leftward", block.classList.contains("event") && from > LAST_RIGHTWARD);
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
