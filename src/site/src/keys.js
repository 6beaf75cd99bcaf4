// Keys and a pad of buttons that steer what the scene has to steer. While they do, arrows and space are not the time's.
const HELD = {
  w: "up",
  a: "left",
  s: "down",
  d: "right",
  ArrowUp: "up",
  ArrowLeft: "left",
  ArrowDown: "down",
  ArrowRight: "right",
  " ": "act",
};
/** For an arm the arrows move its mark in the level, W and S up and down. */
const OF_ARMS = { ...HELD, ArrowUp: "forth", ArrowDown: "back" };

export class Keys {
  /** @param pad  the buttons' box   @param driver () => what is steered, or nothing   @param direction () => unit, from
   * what is looked at to the camera */
  constructor(pad, driver, direction) {
    Object.assign(this, { pad, driver, direction, held: new Set() });
    addEventListener("keyup", (e) => this.held.delete(this.#name(e)));
    addEventListener("blur", () => this.held.clear());
    for (const button of pad.querySelectorAll("button")) {
      const { key } = button.dataset;
      button.onpointerdown = (e) => (button.setPointerCapture(e.pointerId), this.held.add(key));
      button.onpointerup = button.onpointercancel = () => this.held.delete(key);
      button.onkeydown = (e) => e.key === "Enter" && this.held.add(key);
    }
  }

  #name(event) {
    const names = this.driver()?.spec.kind === "arm" ? OF_ARMS : HELD;
    return names[event.key] ?? names[event.key.toLowerCase()];
  }

  /** A key that goes down.   @returns true: it steers, and does nothing else */
  takes(event) {
    const name = this.driver() && !event.ctrlKey && !event.metaKey && this.#name(event);
    if (!name) return false;
    this.held.add(name);
    event.preventDefault();
    return true;
  }

  /** What is asked at this moment, as an action, where it is not what was asked before: before each step. */
  input(sim) {
    const { driver } = sim;
    if (!driver || (!this.held.size && !driver.asks)) return null;
    const { x, z } = this.direction(),
      far = Math.hypot(x, z) || 1,
      value = driver.wish(this.held, [-x / far, -z / far]);
    driver.asks = this.held.size > 0; // once more when all keys are up
    if (value === null || value.join() === driver.value()?.join()) return null;
    return { do: "input", value };
  }

  show() {
    const driver = this.driver();
    this.held.clear();
    this.pad.hidden = !driver;
    this.pad.title = driver?.keys ?? "";
  }
}
