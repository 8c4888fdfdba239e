"use strict";
// A picture as large as the window: other scenes and sides by keys, Escape leads back.
(() => {
  const zoom = document.getElementById("zoom");
  const pictures = () => [...document.querySelectorAll(".picture")];
  const scene = (picture) => picture.closest("[data-letter]").dataset.letter;
  let now = null;

  function show(picture) {
    if (!picture) return;
    now = picture;
    const image = picture.querySelector("img");
    zoom.querySelector("img").src = image.src;
    zoom.querySelector("img").alt = image.alt.split(";")[0];
    zoom.querySelector("span").textContent = image.alt.split(";")[0];
    if (!zoom.open) zoom.showModal();
  }

  function beside(step) {
    const row = pictures().filter((one) => one.dataset.view === now.dataset.view);
    const all = row.length > 1 ? row : pictures();
    show(all[(all.indexOf(now) + step + all.length) % all.length]);
  }

  document.addEventListener("click", (event) => {
    const picture = event.target.closest(".picture");
    if (picture) {
      event.preventDefault();
      show(picture);
    }
    if (event.target.closest("#close")) zoom.close();
  });
  document.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.altKey || event.metaKey || event.target.closest("textarea")) return;
    if (!zoom.open) {
      if (event.key.toUpperCase() !== "Z") return;
      show(document.activeElement.closest("[data-letter]")?.querySelector(".picture.now") || document.querySelector(".picture.now"));
    } else if (event.key === "ArrowRight") beside(1);
    else if (event.key === "ArrowLeft") beside(-1);
    else if (event.key.toUpperCase() === "Z") zoom.close();
    else if (/^[1-9]$/.test(event.key)) show(pictures().find((one) => scene(one) === scene(now) && one.dataset.view === event.key));
    else {
      const other = pictures().find((one) => scene(one) === event.key.toUpperCase() && one.dataset.view === now.dataset.view);
      if (!other) return;
      show(other);
    }
    event.preventDefault();
  });
})();
