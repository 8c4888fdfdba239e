"use strict";
// An answer is sent until the server has kept it; what was chosen stays on the page as long.
(() => {
  const AGAIN_MS = 2000;
  const form = document.getElementById("answer");
  const told = document.getElementById("order");
  const keep = document.getElementById("keep");

  function say(text) {
    told.classList.add("wrong");
    told.textContent = text;
  }

  async function send(body) {
    let answer;
    try {
      answer = await fetch(form.action, { method: "POST", body });
    } catch {
      answer = null;
    }
    if (!answer || answer.status === 503) {
      say("Not kept yet: the server does not answer. Leave this page open, it tries again.");
      setTimeout(send, AGAIN_MS, body);
    } else if (answer.ok) {
      location.assign(answer.url);
    } else {
      const page = new DOMParser().parseFromString(await answer.text(), "text/html");
      say((page.querySelector(".wrong") || page.querySelector("main p"))?.textContent || `The server answered ${answer.status}.`);
      keep.disabled = false;
    }
  }

  form.addEventListener("submit", (event) => {
    event.preventDefault();
    keep.disabled = true;
    send(new URLSearchParams(new FormData(form)));
  });
})();
