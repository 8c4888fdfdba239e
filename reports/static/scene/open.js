/* Loads the 3D view when it is asked for: by its button, or by a link to an actor (#actor=NAME&of=SUBMISSION). */
(function () {
  "use strict";
  const scene = (window.c4sScene = {});
  const PARTS = ["data", "meshes", "orbit", "cameras", "model", "walk", "stage", "list", "panel", "modes", "view"];
  const held = new Map();
  const asked = new Map();

  /** Takes a piece of data that a file hands over: base64 of bytes. */
  scene.put = (name, text) => held.set(name, text);

  /** Runs a script of this folder once. */
  scene.load = (path) => {
    if (!asked.has(path)) {
      asked.set(path, new Promise((done, failed) => {
        const script = document.createElement("script");
        script.src = path;
        script.onload = done;
        script.onerror = () => failed(new Error("the file " + path + " is not there"));
        document.head.append(script);
      }));
    }
    return asked.get(path);
  };

  /** The text that a data file hands over, which lies beside the others. */
  scene.fetchText = async (root, name) => {
    await scene.load(root + "scene/" + name + ".js");
    return held.get(name);
  };

  /** What a link asks for, or null. */
  scene.linked = () => {
    const asked = new URLSearchParams(location.hash.slice(1));
    return asked.has("actor") ? { actor: asked.get("actor"), of: asked.get("of") } : null;
  };

  const section = document.getElementById("scene");
  if (!section) return;
  const root = section.dataset.root;
  const offer = section.querySelector(".scene-open");
  const trouble = section.querySelector(".scene-trouble");
  let view = null;

  async function open() {
    offer.hidden = true;
    trouble.textContent = "Reading the scene …";
    try {
      await scene.load(root + section.dataset.three);
      for (const part of PARTS) await scene.load(root + "static/scene/" + part + ".js");
      view = await scene.show(section, root);
      trouble.textContent = "";
    } catch (fault) {
      section.querySelector(".scene-view").hidden = true;
      trouble.textContent = fault.name === "NoWebGL"
        ? "This browser draws nothing in three dimensions (no WebGL). The pictures of this page and the tables below tell the same."
        : "The 3D view could not be opened: " + fault.message + ".";
    }
  }

  async function follow() {
    const link = scene.linked();
    if (!link) return;
    view = view || (offer.hidden ? null : await open(), view);
    if (view) {
      section.scrollIntoView();
      await view.go(link.of, link.actor);
    }
  }

  offer.hidden = false;
  offer.querySelector("button").addEventListener("click", open);
  window.addEventListener("hashchange", follow);
  follow();
})();
