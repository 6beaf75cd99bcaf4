// The module that the page runs, on one thread or several.
import { load } from "carom";

/** The engine, with `?threads=4` or `?threads=auto` on so many threads, where the page may share memory: same bits. */
export async function engine(say) {
  const alone = () => load(new URL("carom.wasm", document.baseURI)),
    asked = new URLSearchParams(location.search).get("threads");
  if (asked === null || asked === "1") return alone();
  try {
    const threads = asked === "auto" ? asked : Number(asked);
    return await load({ threads, source: new URL("carom.threads.wasm", document.baseURI) });
  } catch (error) {
    if (asked !== "auto") say(`${error.message}; the page runs on one thread`);
    return alone();
  }
}
