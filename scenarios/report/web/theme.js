// Light and dark: as the system has it, until the button says otherwise.

const root = document.documentElement;

export function setTheme(name) {
  root.dataset.theme = name;
}

/** Calls `redraw` after each change. */
export function followTheme(button, redraw) {
  const change = (name) => {
    setTheme(name);
    redraw();
  };
  const system = matchMedia("(prefers-color-scheme: dark)");
  system.addEventListener("change", () => change(system.matches ? "dark" : "light"));
  button.addEventListener("click", () => change(root.dataset.theme === "dark" ? "light" : "dark"));
}
