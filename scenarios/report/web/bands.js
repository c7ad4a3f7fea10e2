// Draws phases and events as bands behind a plot, and the touchdown as a line.
import { color, phaseColor, tint } from "./colors.js";

const PHASE_OPACITY = 0.07;
const EVENT_OPACITY = 0.22;

/** Returns a uPlot hook that draws the bands and the line behind the curves. */
export function bandsOf(flight) {
  return (chart) => {
    const { ctx, bbox } = chart;
    const pixel = (t_s) => chart.valToPos(t_s, "x", true);
    const band = (span, style) => {
      const from = Math.max(pixel(span.from_s), bbox.left);
      const to = Math.min(pixel(span.to_s), bbox.left + bbox.width);
      if (to < from) return;
      ctx.fillStyle = style;
      ctx.fillRect(from, bbox.top, Math.max(to - from, devicePixelRatio), bbox.height);
    };
    ctx.save();
    for (const phase of flight.phases) band(phase, tint(phaseColor(phase.name), PHASE_OPACITY));
    for (const event of flight.events) band(event, tint("event", EVENT_OPACITY));
    if (flight.touchdown) drawLine(ctx, bbox, pixel(flight.touchdown.t_s));
    ctx.restore();
  };
}

function drawLine(ctx, bbox, x) {
  if (x < bbox.left || x > bbox.left + bbox.width) return;
  ctx.strokeStyle = color("muted");
  ctx.lineWidth = devicePixelRatio;
  ctx.setLineDash([4 * devicePixelRatio, 3 * devicePixelRatio]);
  ctx.beginPath();
  ctx.moveTo(x, bbox.top);
  ctx.lineTo(x, bbox.top + bbox.height);
  ctx.stroke();
}
