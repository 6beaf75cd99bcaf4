// Search: Pagefind's own face, with the index that the build made.
const box = document.getElementById("search"),
  root = new URL(box.dataset.root, location);
const sheet = Object.assign(document.createElement("link"), {
  rel: "stylesheet",
  href: new URL("pagefind/pagefind-ui.css", root),
});
const script = Object.assign(document.createElement("script"), { src: new URL("pagefind/pagefind-ui.js", root) });
script.onload = () => {
  const face = new globalThis.PagefindUI({
    element: box,
    showImages: false,
    showSubResults: true,
    baseUrl: root.pathname,
    resetStyles: false,
  });
  const asked = new URLSearchParams(location.search).get("q"); // from the page of scenes
  if (asked) face.triggerSearch(asked);
};
document.head.append(sheet, script);

// The gallery: what is typed leaves the cards that have all of its words.
const cards = [...document.querySelectorAll(".gallery section")];
if (cards.length) {
  const sieve = Object.assign(document.createElement("input"), {
    type: "search",
    className: "sieve",
    placeholder: `Words that ${cards.length} scenes are sought by`,
    ariaLabel: "Show the scenes that have these words",
  });
  sieve.oninput = () => {
    const words = sieve.value.toLowerCase().split(/\s+/);
    for (const card of cards) card.hidden = !words.every((word) => card.textContent.toLowerCase().includes(word));
    for (const group of document.querySelectorAll(".gallery"))
      group.previousElementSibling.hidden = !group.querySelector("section:not([hidden])");
  };
  document.querySelector(".gallery").previousElementSibling.before(sieve);
}

// Each program can be copied.
for (const pre of document.querySelectorAll("main pre")) {
  const box = Object.assign(document.createElement("div"), { className: "program" }),
    button = Object.assign(document.createElement("button"), { type: "button", textContent: "Copy" });
  button.onclick = async () => {
    await navigator.clipboard.writeText(pre.textContent).catch(() => getSelection().selectAllChildren(pre));
    button.textContent = "Copied";
    setTimeout(() => (button.textContent = "Copy"), 1500);
  };
  pre.replaceWith(box);
  box.append(pre, button);
}

// Programs in several languages: one is seen, the same in all places and on all pages.
const REMEMBERED = "carom language";
const groups = [...document.querySelectorAll(".tabs")].map((box, number) => {
  const parts = [...box.querySelectorAll("section")],
    list = Object.assign(document.createElement("div"), { role: "tablist", className: "tablist" });
  list.setAttribute("aria-label", "Language");
  const tabs = parts.map((part, i) => {
    const name = part.getAttribute("aria-label"),
      tab = Object.assign(document.createElement("button"), { type: "button", role: "tab", textContent: name });
    Object.assign(part, { role: "tabpanel", id: `tabs-${number}-${i}` });
    tab.setAttribute("aria-controls", part.id);
    tab.onclick = () => choose(name);
    tab.onkeydown = (e) => {
      const step = { ArrowRight: 1, ArrowLeft: -1 }[e.key];
      if (!step) return;
      const next = tabs[(i + step + tabs.length) % tabs.length];
      (choose(next.textContent), next.focus());
    };
    return tab;
  });
  list.append(...tabs);
  box.prepend(list);
  return { parts, tabs };
});

function choose(name, keep = true) {
  for (const { parts, tabs } of groups) {
    const at = Math.max(
      0,
      tabs.findIndex((tab) => tab.textContent === name),
    );
    tabs.forEach((tab, i) => {
      tab.setAttribute("aria-selected", String(i === at));
      tab.tabIndex = i === at ? 0 : -1;
      parts[i].hidden = i !== at;
    });
  }
  if (keep) localStorage.setItem(REMEMBERED, name);
}
// A start page is in the language of its readers; elsewhere what was chosen last counts.
choose(location.pathname.includes("/start/") ? null : localStorage.getItem(REMEMBERED), false);

// Versions that are kept side by side: versions.mjs. A page that another version does not have leads to its first one.
const told = document.querySelector("header .version");
const versions = await (await fetch(new URL("../versions.json", root))).json();
if (versions.length > 1) {
  const select = document.createElement("select");
  select.setAttribute("aria-label", "Version of the documentation");
  for (const { version, path } of versions) select.add(new Option(version, path));
  select.selectedIndex = versions.findIndex(({ version }) => version === told.textContent);
  select.onchange = async () => {
    const docs = new URL(`../${select.value}docs/`, root),
      same = new URL(location.pathname.slice(root.pathname.length), docs);
    location.href = (await fetch(same, { method: "HEAD" })).ok ? same : docs;
  };
  told.replaceChildren(select);
}
