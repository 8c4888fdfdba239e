"use strict";
// How far everybody is, looked at again now and then; the page stays as it is where the server does not answer.
(() => {
  const EVERY_MS = 5000;

  async function again() {
    try {
      const page = new DOMParser().parseFromString(await (await fetch(location.href)).text(), "text/html");
      const fresh = page.getElementById("progress");
      if (fresh) document.getElementById("progress").replaceWith(fresh);
    } catch {
      document.title = "no answer from the server";
    }
  }

  setInterval(again, EVERY_MS);
})();
