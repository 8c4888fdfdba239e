"use strict";
// Whole texts of calls: put into a call when it is opened. Texts are text, never markup.
(function () {
  function fill(details, texts) {
    details.querySelectorAll("pre[data-part]").forEach(function (place) {
      var text = texts[place.dataset.part];
      if (text === undefined) { return; }
      place.textContent = "";
      delete place.dataset.more;
      if (typeof text === "string") { place.textContent = text; return; }
      text.forEach(function (token) {
        if (!token[0]) { place.append(token[1]); return; }
        var span = document.createElement("span");
        span.className = "code-" + token[0];
        span.textContent = token[1];
        place.append(span);
      });
    });
  }

  function open(details) {
    var calls = details.closest(".calls");
    if (!details.open || details.dataset.whole || !calls.dataset.src) { return; }
    details.dataset.whole = "yes";
    if (!calls.dataset.asked) {
      calls.dataset.asked = "yes";
      var script = document.createElement("script");
      script.src = calls.dataset.src;
      document.head.append(script);
    }
    c4s.when(calls.dataset.name, function (data) {
      if (data[details.dataset.call]) { fill(details, data[details.dataset.call]); }
    });
  }

  document.querySelectorAll(".calls details").forEach(function (details) {
    details.addEventListener("toggle", function () { open(details); });
  });

  function named() {
    try { return document.getElementById(decodeURIComponent(location.hash.slice(1))); } catch (odd) { return null; }
  }

  function show() {
    var chosen = location.hash && named();
    for (var at = chosen; at; at = at.parentElement) { if (at.tagName === "DETAILS") { at.open = true; } }
    if (chosen) { chosen.scrollIntoView(); }
  }
  window.addEventListener("hashchange", show);
  show();
})();
