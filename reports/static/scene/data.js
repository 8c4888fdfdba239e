/* Data files: base64 of raw deflate, or of a picture. */
(function () {
  "use strict";
  const scene = c4sScene;

  function bytes(text) {
    const raw = atob(text);
    const made = new Uint8Array(raw.length);
    for (let place = 0; place < raw.length; place++) made[place] = raw.charCodeAt(place);
    return made;
  }

  async function inflated(data) {
    const stream = new Blob([data]).stream().pipeThrough(new DecompressionStream("deflate-raw"));
    return new Uint8Array(await new Response(stream).arrayBuffer());
  }

  const kept = new Map();
  const once = (name, make) => {
    if (!kept.has(name)) kept.set(name, make());
    return kept.get(name);
  };

  /** A text as people are shown it: what turns its direction or cannot be seen is written as its escape. */
  const UNSEEN = /[\p{Cc}\p{Cf}\p{Cs}\p{Zl}\p{Zp}]/gu;
  const visible = (text) => text.replace(UNSEEN, (one) => "\\u" + one.codePointAt(0).toString(16).padStart(4, "0"));

  function shown(value) {
    if (typeof value === "string") return visible(value);
    if (Array.isArray(value)) return value.map(shown);
    if (value === null || typeof value !== "object") return value;
    return Object.fromEntries(Object.entries(value).map(([name, one]) => [visible(name), shown(one)]));
  }

  const json = async (root, name) => shown(JSON.parse(new TextDecoder().decode(await inflated(bytes(await scene.fetchText(root, name))))));

  scene.index = json;

  scene.document = (root, name) => once("document " + name, () => json(root, name));

  scene.meshBytes = (root, name) => once("mesh " + name, async () => inflated(bytes(await scene.fetchText(root, name))));

  scene.picture = (root, name) => once("picture " + name, async () => {
    const data = bytes(await scene.fetchText(root, name));
    return createImageBitmap(new Blob([data]), { imageOrientation: "none", premultiplyAlpha: "none" });
  });
})();
