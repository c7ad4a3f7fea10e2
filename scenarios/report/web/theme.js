// Light or dark theme. It follows the system; the button switches it.

const root = document.documentElement;

export function setTheme(name) {
  root.dataset.theme = name;
}

/** Changes the theme with the system and with `button`. Calls `redraw` after each change. */
export function followTheme(button, redraw) {
  const change = (name) => {
    setTheme(name);
    redraw();
  };
  const system = matchMedia("(prefers-color-scheme: dark)");
  system.addEventListener("change", () => change(system.matches ? "dark" : "light"));
  button.addEventListener("click", () => change(root.dataset.theme === "dark" ? "light" : "dark"));
}
