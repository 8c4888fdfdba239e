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

  const json = async (root, name) => JSON.parse(new TextDecoder().decode(await inflated(bytes(await scene.fetchText(root, name)))));

  scene.index = json;

  scene.document = (root, name) => once("document " + name, () => json(root, name));

  scene.meshBytes = (root, name) => once("mesh " + name, async () => inflated(bytes(await scene.fetchText(root, name))));

  scene.picture = (root, name) => once("picture " + name, async () => {
    const data = bytes(await scene.fetchText(root, name));
    return createImageBitmap(new Blob([data]), { imageOrientation: "none", premultiplyAlpha: "none" });
  });
})();
