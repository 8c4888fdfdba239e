/* What is told of one actor: its state, its error against the truth, what verdicts say of it. */
(function () {
  "use strict";
  const scene = c4sScene;
  const { make } = scene;
  const last = (path) => path.split("/").pop().split(".")[0];
  const numbers = (values, digits) => values.map((value) => value.toFixed(digits)).join(", ");

  /** The rotation of a quaternion as [pitch, yaw, roll] in degrees, as Unreal tells it. */
  function rotator([x, y, z, w]) {
    const degrees = (value) => (value * 180) / Math.PI;
    const steep = z * x - w * y;
    const yaw = Math.atan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z));
    if (Math.abs(steep) > 0.4999995) return [90 * Math.sign(steep), degrees(yaw), 0];
    return [degrees(Math.asin(2 * steep)), degrees(yaw), degrees(Math.atan2(-2 * (w * x + y * z), 1 - 2 * (x * x + y * y)))];
  }

  function facts(actor, model) {
    const looks = [...new Set(actor.parts.flatMap((part) => part[1]))].filter((at) => at >= 0);
    const rows = [
      ["Asset", actor.asset ? last(actor.asset) : actor.class],
      ["Location (cm)", numbers(actor.pose.slice(0, 3), 1)],
      ["Rotation (°)", numbers(rotator(actor.pose.slice(3, 7)), 1)],
      ["Scale", numbers(actor.pose.slice(7), 3)],
      ["Size (cm)", numbers(actor.box.slice(3).map((half) => 2 * half), 0)],
      ["Materials", looks.map((at) => last(model.document.materials[at].path)).join(", ")],
      ["Hidden", actor.hidden ? "yes" : ""],
      ...Object.entries(actor.state).map(([name, value]) => [name.replaceAll("_", " "), [value].flat().join(", ")]),
    ];
    return rows.filter(([, value]) => value !== "").flatMap(([name, value]) => [make("dt", {}, name), make("dd", {}, value)]);
  }

  /** Fill the panel; ``found`` is {actor, model, side, difference, said}. */
  scene.tell = (panel, found) => {
    if (!found) {
      panel.replaceChildren(make("p", { class: "dim" }, "Choose an actor in the scene or in the list."));
      return;
    }
    const { actor, model, side, difference, said } = found;
    panel.replaceChildren(
      make("h3", {}, actor.label),
      make("p", { class: "dim" }, side === "submission" ? "in the submission" : "in the " + side),
      difference ? make("p", { class: "scene-error" }, make("span", { class: "kind " + difference.kind }, difference.kind), " " + difference.told) : "",
      said.length
        ? make("ul", { class: "scene-said" }, ...said.map(([verifier, outcome, text]) => make(
          "li", {}, make("span", { class: "outcome " + outcome.toLowerCase() }, outcome), " ", make("span", { class: "dim" }, verifier), " " + text)))
        : make("p", { class: "dim" }, "No verdict names it."),
      make("dl", {}, ...facts(actor, model)),
    );
  };
})();
