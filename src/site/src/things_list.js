// Scenes that the page makes itself (things.js), as rows of the list of scenes.
export const THINGS = [
  {
    name: "drive",
    thing: "yard",
    summary: "A car with an engine, gears, springs and tyres, in a yard.",
    look_for: "crates, dominoes, a ramp",
  },
  {
    name: "walk",
    thing: "course",
    summary: "A character on steps, slopes of 20, 40 and 60 degrees, a moving platform.",
    look_for: "what it can climb and push",
  },
  {
    name: "arm",
    thing: "arm",
    summary: "A robot's arm of three hinges reaches for a mark.",
    look_for: "how far the hand stays off",
  },
];
