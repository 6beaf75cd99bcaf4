// Colours. Of curves: they stay apart for the colour-blind, Okabe and Ito's eight. Of bodies: quieter ones, which stay
// apart by lightness as well.
import { Color } from "three";

export const KINDS = ["#e69f00", "#56b4e9", "#009e73", "#f0e442", "#0072b2", "#d55e00", "#cc79a7", "#999999"];
export const FIXED = "#9aa1ab";
const BODIES = ["#d9875a", "#4f86b8", "#e4bb58", "#6fa083", "#b9566a", "#8f7db8", "#3f9c9c", "#c9a88a"];
const NAMED = {
  bunny: "#efe0cc",
  block: "#d08a63",
  domino: "#e8dfcf",
  plank: "#8a6242",
  ball: "#d95f4c",
  thrown: "#3f9c9c",
  chassis: "#c8443c",
  tyre: "#3a3f46",
  walker: "#d9875a",
  mark: "#d55e00",
};
const TINTS = [
  [0, 0],
  [0.018, 0.055],
  [-0.016, -0.045],
  [0.03, -0.02],
  [-0.008, 0.03],
];

/** Of a body of the k-th kind: of a crowd, bodies differ a little.   @param i  which one of it   @param count  of them */
export function bodyColour(kind, k, i, count, out = new Color()) {
  out.set(NAMED[kind] ?? BODIES[k % BODIES.length]);
  const [hue, light] = count > 3 ? TINTS[(i * 7 + ((i * i) >> 3)) % TINTS.length] : TINTS[0];
  return out.offsetHSL(hue, 0, light);
}

const LIGHT = {
  sky: "#a9c9e6",
  horizon: "#e9eff4",
  ground: "#e3e6e8",
  line: 0.74, // of the ground's brightness
  above: "#e6f0fb", // the light from there
  below: "#b3a894",
  a: "#0072b2",
  b: "#d55e00",
  text: "#30363d",
  rule: "#c3cad3",
};
const DARK = {
  sky: "#0d1219",
  horizon: "#2b3643",
  ground: "#39424d",
  line: 1.45,
  above: "#c4d6ea",
  below: "#6d7178",
  a: "#56b4e9",
  b: "#e69f00",
  text: "#c9d1d9",
  rule: "#3b424d",
};
export const theme = () => (document.documentElement.dataset.theme === "dark" ? DARK : LIGHT);
