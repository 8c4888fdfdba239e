"use strict";
// The one registry of data that lies beside pages: each file calls c4s.put(name, data); who wants it calls c4s.when.
const c4s = (function () {
  const known = new Map();
  const waiting = new Map();
  return {
    put: function (name, data) {
      known.set(name, data);
      for (const wanted of waiting.get(name) || []) wanted(data);
      waiting.delete(name);
    },
    when: function (name, wanted) {
      if (known.has(name)) wanted(known.get(name));
      else waiting.set(name, (waiting.get(name) || []).concat([wanted]));
    },
  };
})();
