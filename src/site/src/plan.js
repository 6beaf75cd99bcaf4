// What the last step ran: stages by time, effects by participants and reason, each with a switch that acts at once.

const us = (s) => (s * 1e6 < 1000 ? `${(s * 1e6).toFixed(0)} µs` : `${(s * 1e3).toFixed(2)} ms`);
const MODES = ["as needed", "forbid", "force"];

function row(table, cells, idle) {
  const tr = table.insertRow();
  tr.classList.toggle("idle", idle);
  for (const cell of cells) {
    const td = tr.insertCell();
    if (cell instanceof Node) td.append(cell);
    else td.textContent = cell;
    if (typeof cell === "string" && /^[\d.]+ (µs|ms)$/.test(cell)) td.className = "number";
  }
}

export class PlanPanel {
  /** @param set  (effect, mode) => void: what a choice does */
  constructor(stages, effects, set) {
    Object.assign(this, { stages, effects, set, switches: new Map() });
  }

  update(plan) {
    // A select that is open must not be taken away.
    if (this.effects.contains(document.activeElement)) return;
    (this.stages.replaceChildren(), this.effects.replaceChildren());
    for (const line of plan) {
      if (line.effect === 0xffffffff) {
        row(this.stages, [line.name, us(line.seconds)], !line.runs);
        continue;
      }
      const choice = document.createElement("select");
      choice.setAttribute("aria-label", `${line.name}: as needed, forbid or force`);
      MODES.forEach((text, value) => choice.add(new Option(text, String(value), false, value === line.mode)));
      choice.addEventListener("change", () => {
        this.set(line.effect, Number(choice.value));
        choice.blur();
      });
      const served = line.runs ? `${line.participants} ${line.unit}` : "off";
      row(
        this.effects,
        [line.name, served, line.timing === 0 && line.runs ? us(line.seconds) : "", choice],
        !line.runs,
      );
      this.effects.rows[this.effects.rows.length - 1].title = line.reason;
    }
  }
}
