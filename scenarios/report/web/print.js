// On paper the page is light and narrow, and everything is to be seen.
import { setTheme } from "./theme.js";

const PAPER_PX = 680;

export function prepareForPrint(plots) {
  let restore = () => {};
  addEventListener("beforeprint", () => {
    const theme = document.documentElement.dataset.theme;
    const folded = [...document.querySelectorAll("details:not([open])")];
    restore = () => {
      setTheme(theme);
      for (const part of folded) part.open = false;
      plots.fit();
      plots.redraw();
    };
    setTheme("light");
    for (const part of folded) part.open = true;
    for (const chart of plots.charts) chart.setSize({ width: PAPER_PX, height: chart.height });
    plots.redraw();
  });
  addEventListener("afterprint", () => restore());
}
