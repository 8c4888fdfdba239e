"use strict";
// Tick boxes of configurations: what is chosen stands out, can be shown alone, is compared, and is kept in the address.
(function () {
  const boxes = document.querySelectorAll("input.choose");
  const chosen = new Set();
  let alone = false;
  function show() {
    for (const box of boxes) box.checked = chosen.has(box.value);
    for (const one of document.querySelectorAll("[data-configuration]")) {
      const own = chosen.has(one.dataset.configuration);
      one.classList.toggle("chosen", own && one.tagName.toLowerCase() === "tr");
      if (one.tagName.toLowerCase() === "a") {
        one.classList.toggle("faded", chosen.size > 0 && !own);
        continue;
      }
      one.classList.toggle("unchosen", alone && chosen.size > 0 && !own);
      one.hidden = one.classList.contains("unchosen") || one.classList.contains("filtered");
    }
    const names = Array.from(chosen);
    for (const section of document.querySelectorAll("[data-compare]")) {
      const link = section.querySelector(".compare-chosen");
      const pair = new URLSearchParams(names.length > 1 ? [["a", names[0]], ["b", names[1]]] : names.length ? [["a", names[0]]] : []);
      if (link) link.href = section.dataset.compare + (names.length ? "#" + pair : "");
    }
    for (const told of document.querySelectorAll(".chosen-count")) told.textContent = names.length ? names.length + " chosen" : "";
    for (const button of document.querySelectorAll("button.only")) {
      button.disabled = names.length === 0;
      button.setAttribute("aria-pressed", String(alone));
    }
  }
  function keep() {
    c4sAddress.put({ chosen: Array.from(chosen) });
    show();
  }
  for (const box of boxes) {
    box.hidden = false;
    box.addEventListener("change", function () {
      if (box.checked) chosen.add(box.value); else chosen.delete(box.value);
      if (!chosen.size) alone = false;
      keep();
    });
  }
  for (const button of document.querySelectorAll("button.only")) {
    button.addEventListener("click", function () { alone = !alone; show(); });
  }
  c4sAddress.follow(function () {
    chosen.clear();
    for (const name of c4sAddress.all("chosen")) chosen.add(name);
    show();
  });
})();
