// Prepares the page for printing: light theme, narrow plots, all details open.
import { setTheme } from "./theme.js";

const PAPER_WIDTH_PX = 680;

export function prepareForPrint(plots) {
  let restore = () => {};
  addEventListener("beforeprint", () => {
    const theme = document.documentElement.dataset.theme;
    const closed = [...document.querySelectorAll("details:not([open])")];
    restore = () => {
      setTheme(theme);
      for (const part of closed) part.open = false;
      plots.fit();
      plots.redraw();
    };
    setTheme("light");
    for (const part of closed) part.open = true;
    for (const chart of plots.charts) chart.setSize({ width: PAPER_WIDTH_PX, height: chart.height });
    plots.redraw();
  });
  addEventListener("afterprint", () => restore());
}
