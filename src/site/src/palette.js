// Colours that stay apart for the colour-blind: Okabe and Ito's eight, and the page's own by theme.

export const KINDS = ["#e69f00", "#56b4e9", "#009e73", "#f0e442", "#0072b2", "#d55e00", "#cc79a7", "#999999"];
export const FIXED = "#8a8f98";

export function theme() {
  const dark = document.documentElement.dataset.theme === "dark";
  return dark
    ? { sky: "#15181d", ground: "#2a2f37", grid: "#3b424d", a: "#56b4e9", b: "#e69f00", text: "#c9d1d9" }
    : { sky: "#eef1f5", ground: "#d5dae1", grid: "#b6bec9", a: "#0072b2", b: "#d55e00", text: "#30363d" };
}
