"use strict";
// What a reader has set up, kept in the address behind its #: names with values, each kept beside those of others.
const c4sAddress = (function () {
  function read() {
    return new URLSearchParams(location.hash.includes("=") ? location.hash.slice(1) : "");
  }
  return {
    all: function (name) { return read().getAll(name); },
    get: function (name) { return read().get(name); },
    put: function (values) {
      const told = read();
      for (const name in values) {
        told.delete(name);
        for (const value of [].concat(values[name])) if (value !== "") told.append(name, value);
      }
      const text = String(told);
      history.replaceState(null, "", text ? "#" + text : location.pathname + location.search);
    },
    follow: function (show) {
      show();
      addEventListener("hashchange", show);
    },
  };
})();
