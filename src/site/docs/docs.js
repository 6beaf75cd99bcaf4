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
