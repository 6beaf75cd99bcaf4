// Search: Pagefind's own face, with the index that the build made.
const box = document.getElementById("search"),
  root = new URL(box.dataset.root, location);
const sheet = Object.assign(document.createElement("link"), {
  rel: "stylesheet",
  href: new URL("pagefind/pagefind-ui.css", root),
});
const script = Object.assign(document.createElement("script"), { src: new URL("pagefind/pagefind-ui.js", root) });
script.onload = () =>
  new globalThis.PagefindUI({ element: box, showImages: false, baseUrl: root.pathname, resetStyles: false });
document.head.append(sheet, script);

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
