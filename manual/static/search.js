"use strict";
// Finds the parts of pages that hold every word that is typed; the index is a script, so that it loads from a folder.
(() => {
  const box = document.getElementById("search");
  const list = document.getElementById("found");
  const root = document.body.dataset.root;
  const MOST = 12;

  function rank([, , title, heading, text], words) {
    let sum = 0;
    for (const word of words) {
      const inTitle = title.toLowerCase().includes(word);
      const inHeading = heading.toLowerCase().includes(word);
      const count = text.toLowerCase().split(word).length - 1;
      if (!inTitle && !inHeading && !count) return 0;
      sum += (inHeading ? 12 : 0) + (inTitle ? 6 : 0) + Math.min(count, 4);
    }
    return sum;
  }

  function excerpt(text, words) {
    const low = text.toLowerCase();
    const at = Math.max(0, Math.min(...words.map((word) => low.indexOf(word)).filter((place) => place >= 0), text.length) - 40);
    const part = (at ? "…" : "") + text.slice(at, at + 150) + (at + 150 < text.length ? "…" : "");
    const shown = document.createElement("small");
    let rest = part;
    while (rest) {
      const places = words.map((word) => [rest.toLowerCase().indexOf(word), word.length]).filter(([place]) => place >= 0);
      if (!places.length) { shown.append(rest); break; }
      const [place, length] = places.sort((a, b) => a[0] - b[0])[0];
      const mark = document.createElement("mark");
      mark.textContent = rest.slice(place, place + length);
      shown.append(rest.slice(0, place), mark);
      rest = rest.slice(place + length);
    }
    return shown;
  }

  function show() {
    const words = box.value.toLowerCase().split(/\s+/).filter(Boolean);
    list.replaceChildren();
    list.hidden = !words.length;
    if (!words.length) return;
    const found = window.searched.map((row) => [rank(row, words), row]).filter(([score]) => score)
      .sort((a, b) => b[0] - a[0]).slice(0, MOST);
    for (const [, row] of found) {
      const [page, anchor, title, heading, text] = row;
      const item = document.createElement("li");
      const link = document.createElement("a");
      link.href = `${root}${page}#${anchor}`;
      link.append(heading ? `${title} › ${heading}` : title, excerpt(text, words));
      link.addEventListener("click", () => { list.hidden = true; });
      item.append(link);
      list.append(item);
    }
    if (!found.length) {
      const none = document.createElement("p");
      none.textContent = "Nothing has all these words.";
      list.append(none);
    }
  }

  function step(event, by) {
    const links = [...list.querySelectorAll("a")];
    const at = links.indexOf(document.activeElement) + by;
    event.preventDefault();
    (links[at] || box).focus();
  }

  box.addEventListener("input", show);
  document.addEventListener("keydown", (event) => {
    if (event.key === "/" && document.activeElement !== box) { event.preventDefault(); box.focus(); }
    if (event.key === "Escape") { list.hidden = true; box.blur(); }
    const inside = document.activeElement === box || list.contains(document.activeElement);
    if (inside && event.key === "ArrowDown") step(event, 1);
    if (inside && event.key === "ArrowUp") step(event, -1);
    if (event.key === "Enter" && document.activeElement === box) { const first = list.querySelector("a"); if (first) first.click(); }
  });
})();
