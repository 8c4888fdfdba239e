"use strict";
// The cards of cases: found by a word, put in the order of their scores. Both are kept in the address.
(function () {
  const box = document.querySelector(".cards");
  const word = document.querySelector(".card-filter");
  const order = document.querySelector(".card-order");
  if (!box || !word) return;
  const planned = Array.from(box.children);
  function show() {
    const wanted = word.value.trim().toLowerCase();
    for (const card of planned) card.hidden = wanted !== "" && !card.textContent.toLowerCase().includes(wanted);
    const cards = planned.slice();
    const sign = order.value === "down" ? -1 : 1;
    if (order.value) cards.sort(function (a, b) { return sign * (Number(a.dataset.v) - Number(b.dataset.v)); });
    box.append(...cards);
  }
  for (const field of [word, order]) {
    field.addEventListener("input", function () {
      c4sAddress.put({ card: word.value, order: order.value });
      show();
    });
  }
  c4sAddress.follow(function () {
    word.value = c4sAddress.get("card") || "";
    order.value = c4sAddress.get("order") || "";
    show();
  });
})();
