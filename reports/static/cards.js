"use strict";
// The cards of cases: found by a word, put in the order of their scores.
(function () {
  const box = document.querySelector(".cards");
  const word = document.querySelector(".card-filter");
  const order = document.querySelector(".card-order");
  if (!box || !word) return;
  const planned = Array.from(box.children);
  word.addEventListener("input", function () {
    const wanted = word.value.trim().toLowerCase();
    for (const card of planned) card.hidden = wanted !== "" && !card.textContent.toLowerCase().includes(wanted);
  });
  order.addEventListener("change", function () {
    const cards = planned.slice();
    const sign = order.value === "down" ? -1 : 1;
    if (order.value) cards.sort(function (a, b) { return sign * (Number(a.dataset.v) - Number(b.dataset.v)); });
    box.append(...cards);
  });
})();
