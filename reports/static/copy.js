"use strict";
// Buttons of class "copy" put the text of the element that they name on the clipboard, or select it where that is refused.
(function () {
  for (const button of document.querySelectorAll("button.copy")) {
    const source = document.getElementById(button.dataset.from);
    const told = button.textContent;
    button.hidden = false;
    button.addEventListener("click", function () {
      function say(text) {
        button.textContent = text;
        setTimeout(function () { button.textContent = told; }, 2000);
      }
      function select() {
        getSelection().selectAllChildren(source);
        say("Selected: press Ctrl+C");
      }
      if (!navigator.clipboard) { select(); return; }
      navigator.clipboard.writeText(source.textContent).then(function () { say("Copied"); }, select);
    });
  }
})();
