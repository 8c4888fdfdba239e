"use strict";
// The order of three scenes, by keys or by radio buttons, and which side of them is shown.
(() => {
  const form = document.getElementById("answer");
  const told = document.getElementById("order");
  const scenes = [...document.querySelectorAll(".scene")];
  const letters = scenes.map((scene) => scene.dataset.letter);
  const ranks = [...new Set([...form.querySelectorAll("input")].map((input) => input.name))];
  const input = (rank, letter) => form.querySelector(`input[name="${rank}"][value="${letter}"]`);
  const at = (rank) => letters.find((letter) => input(rank, letter).checked);

  function place(rank, letter) {
    for (const other of ranks) if (at(other) === letter) input(other, letter).checked = false;
    input(rank, letter).checked = true;
    const left = letters.filter((one) => !ranks.some((other) => at(other) === one));
    const free = ranks.filter((other) => !at(other));
    if (left.length === 1 && free.length === 1) input(free[0], left[0]).checked = true;
    say();
  }

  function back() {
    const taken = ranks.filter(at);
    const few = taken.length === ranks.length ? taken.slice(-2) : taken.slice(-1);
    for (const rank of few) input(rank, at(rank)).checked = false;
    say();
  }

  function say() {
    told.classList.remove("wrong");
    told.textContent = ranks.some(at) ? ranks.map((rank) => `${rank} ${at(rank) || "–"}`).join(", ") : "";
    for (const scene of scenes) scene.classList.toggle("placed", ranks.some((rank) => at(rank) === scene.dataset.letter));
  }

  function show(scene, view) {
    for (const picture of scene.querySelectorAll(".picture")) picture.classList.toggle("now", picture.dataset.view === view);
    for (const button of scene.querySelectorAll("[data-own]")) button.setAttribute("aria-pressed", String(button.dataset.own === view));
  }

  function showAll(view) {
    for (const scene of scenes) show(scene, view);
    for (const button of document.querySelectorAll("[data-view][aria-pressed]")) button.setAttribute("aria-pressed", String(button.dataset.view === view));
  }

  form.addEventListener("change", (event) => place(event.target.name, event.target.value));
  document.addEventListener("click", (event) => {
    const button = event.target.closest("button");
    if (button && event.detail && button.id !== "keep") button.blur(); // Enter keeps the order again
    if (button?.dataset.view) showAll(button.dataset.view);
    if (button?.dataset.own) {
      show(button.closest(".scene"), button.dataset.own);
      for (const one of document.querySelectorAll(".sides button")) one.setAttribute("aria-pressed", "false");
    }
  });
  document.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.altKey || event.metaKey || document.getElementById("zoom").open) return;
    const letter = event.key.toUpperCase();
    const free = ranks.find((rank) => !at(rank));
    if (letters.includes(letter) && free) place(free, letter);
    else if (/^[1-4]$/.test(event.key)) showAll(event.key);
    else if (event.key === "Backspace") back();
    else if (event.key === "Enter" && !event.target.closest("a, button, summary")) form.requestSubmit();
    else return;
    event.preventDefault();
  });
  form.addEventListener("submit", (event) => {
    if (ranks.every(at)) return;
    event.preventDefault();
    event.stopImmediatePropagation();
    told.classList.add("wrong");
    told.textContent = "Give each scene a place first: press its letter, the best first.";
  });
  document.documentElement.classList.add("scripted");
  say();
})();
