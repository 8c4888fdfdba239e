/* The 3D view of a case page: its controls, and what follows from them. */
(function () {
  "use strict";
  const scene = c4sScene;
  const { make } = scene;
  const NAMES = { start: "Start", truth: "Truth", submission: "Submission", difference: "Difference" };
  const FROM = { whole: [0.5, 0.8, 1], above: [0, 1, 0.001] };
  const HELP = "Drag to turn, Shift and drag to move, wheel to come nearer. Keys: arrows turn, Shift and arrows move, + and − come nearer and go away.";

  /** A control with its name before it. */
  function labelled(text, control) {
    control.id = "scene-" + text.toLowerCase().replaceAll(" ", "-");
    return make("span", {}, make("label", { for: control.id }, text), " ", control);
  }

  const choice = (rows) => make("select", {}, ...rows.map(([value, text]) => make("option", { value }, text)));

  class View {
    constructor(section, root, index) {
      Object.assign(this, { section, root, index, chosen: null, lines: [] });
      this.modes = new scene.Modes(root, index, colours(section));
      this.#build();
      this.stage = new scene.Stage(this.canvas);
      this.#theme();
    }

    get trial() {
      return this.index.trials[this.which.selectedIndex] || null;
    }

    get mode() {
      return this.switches.find((one) => one.checked).value;
    }

    #build() {
      const shown = [...Object.keys(this.index.case), ...(this.index.trials.length ? ["submission", "difference"] : [])];
      this.switches = shown.map((mode) => make("input", { type: "radio", name: "scene-mode", value: mode }));
      this.switches.at(-1).checked = true;
      this.which = choice(this.index.trials.map((trial) => [trial.key, trial.title]));
      this.camera = make("select", {});
      this.beside = make("input", { type: "checkbox" });
      this.eyes = make("input", { type: "checkbox" });
      this.walk = make("input", { type: "checkbox" });
      this.cut = make("input", { type: "range", min: "0", max: "100", value: "100" });
      this.all = make("input", { type: "checkbox" });
      this.canvas = make("canvas", { tabindex: "0", role: "img", "aria-label": "The scene in three dimensions. " + HELP });
      this.legend = make("ul", { class: "scene-legend" });
      this.panel = make("div", { class: "scene-panel", "aria-live": "polite" });
      this.list = new scene.List("Actors", (row) => this.choose(row.name, row.side, true));
      const names = { ...NAMES, difference: this.index.compared ? "Difference" : "Verdicts" };
      const bar = make("div", { class: "scene-bar" },
        make("fieldset", {}, make("legend", {}, "Show"), ...this.switches.map((one) => make("label", {}, one, " " + names[one.value]))),
        this.index.trials.length ? labelled("Submission by", this.which) : "",
        labelled("Camera", this.camera),
        this.index.case.truth ? make("label", {}, this.beside, " beside the truth") : "",
        make("label", {}, this.eyes, " evidence cameras"),
        Object.keys(this.index.walks).length || this.index.trials.some((trial) => trial.walk) ? make("label", {}, this.walk, " where a body can walk") : "",
        labelled("Cut off above", this.cut));
      const side = make("div", { class: "scene-side" }, this.panel, make("label", {}, this.all, " list all actors"), this.list.root);
      const place = this.section.querySelector(".scene-view");
      place.replaceChildren(bar, make("div", { class: "scene-body" }, make("div", { class: "scene-stage" }, this.canvas, this.legend, make("p", { class: "dim" }, HELP)), side));
      place.hidden = false;
      for (const one of [...this.switches, this.beside, this.walk]) one.addEventListener("change", () => this.show());
      this.which.addEventListener("change", () => { this.#cameras(); this.show(); });
      this.camera.addEventListener("change", () => this.stand());
      this.eyes.addEventListener("change", () => this.#help());
      this.cut.addEventListener("input", () => this.#cutting());
      this.all.addEventListener("change", () => this.#fill());
      this.canvas.addEventListener("pointerdown", (event) => (this.pressed = [event.clientX, event.clientY]));
      this.canvas.addEventListener("click", (event) => {
        const [x, y] = this.pressed || [event.clientX, event.clientY];
        if (Math.hypot(event.clientX - x, event.clientY - y) < 4) this.pick(event.clientX, event.clientY);
      });
    }

    #theme() {
      const dark = matchMedia("(prefers-color-scheme: dark)");
      const paint = () => this.stage.background(getComputedStyle(this.section).getPropertyValue("--sky").trim());
      dark.addEventListener("change", paint);
      paint();
    }

    #cameras() {
      const views = this.trial ? this.trial.views : [];
      const before = this.camera.value;
      const options = [["whole", "whole scene"], ["above", "from above"], ...views.map((view) => ["view " + view.name, `${view.name} (${view.purpose})`])];
      this.camera.replaceChildren(...options.map(([value, text]) => make("option", { value }, text)));
      if (options.some(([value]) => value === before)) this.camera.value = before;
    }

    /** The view of the evidence that is chosen, or null. */
    get evidence() {
      return this.trial?.views.find((view) => "view " + view.name === this.camera.value) || null;
    }

    /** Stand where the camera list says. */
    async stand() {
      const [known] = this.index.case.truth ? await this.modes.models("truth") : this.models;
      const bounds = known.bounds();
      if (this.evidence) this.stage.standAt(this.evidence, bounds);
      else this.stage.frame(bounds, FROM[this.camera.value] || FROM.whole);
    }

    /** Show the mode and submission that are chosen; where the camera stands stays. */
    async show() {
      const turn = (this.turn = (this.turn || 0) + 1);
      const models = await this.modes.models(this.mode, this.trial);
      const other = this.beside.checked && this.mode !== "truth" ? await this.modes.models("truth", this.trial) : null;
      const walks = await Promise.all([this.#walked(this.mode), other ? this.#walked("truth") : null]);
      if (turn !== this.turn) return;
      for (const model of this.models.concat(this.others || [])) model.cover(null);
      [models, other].forEach((shown, place) => shown?.[0].cover(walks[place] && scene.walkOverlay(walks[place], this.modes.colours)));
      this.models = models;
      this.others = other;
      this.stage.show(other ? [models, other] : [models]);
      this.#fill();
      this.#cutting();
      const kept = this.chosen && models.some((model) => model.numbers.has(this.chosen.name)) ? this.chosen : null;
      if (kept) this.choose(kept.name, this.modes.side(this.mode, models.find((model) => model.numbers.has(kept.name))), false);
      else this.#forget();
      const named = this.mode === "difference" ? scene.legendOf(this.index.compared) : {};
      const entries = Object.entries(walks[0] ? { ...named, ...scene.WALKED } : named).map(([kind, text]) => make("li", {}, make("span", { class: "swatch " + kind }), " " + text));
      this.legend.replaceChildren(...entries, ...this.#untold(walks[0]).map((text) => make("li", {}, text)));
      this.section.dataset.shown = [this.mode, this.trial?.key].join(" ");
    }

    /** Where one can walk in what a mode shows, where that is wanted and known. */
    async #walked(mode) {
      const name = this.walk.checked && this.modes.walk(mode, this.trial);
      return name ? scene.document(this.root, name) : null;
    }

    /** What of a walk is asked for and not drawn. */
    #untold(walk) {
      if (!this.walk.checked) return [];
      if (!walk) return ["Where a body can walk is not known of this scene."];
      return walk.floors ? [] : ["The walkable area is not drawn: its verdict does not tell it."];
    }

    #fill() {
      this.list.fill(this.modes.rows(this.mode, this.trial, this.models, this.all.checked));
    }

    #cutting() {
      const { min, max } = this.models[0].bounds();
      const share = Number(this.cut.value) / 100;
      this.stage.cutAt(share === 1 ? null : min.y + share * (max.y - min.y));
    }

    /** Frusta, marks and the box of the chosen actor. */
    #help() {
      const group = this.stage.helpers;
      group.clear();
      const colour = this.modes.colours;
      if (this.eyes.checked && this.trial) group.add(scene.frusta(this.trial.views, colour.eye));
      if (this.trial && ["submission", "difference"].includes(this.mode)) {
        const model = this.models[0];
        const boxes = this.trial.offenders.filter((name) => model.numbers.has(name)).map((name) => model.box(model.actors[model.numbers.get(name)]));
        if (boxes.length) group.add(this.stage.mark(boxes, colour.physical));
      }
      if (this.chosen) group.add(this.stage.mark([this.chosen.box], colour.chosen));
      this.stage.draw();
    }

    #forget() {
      this.chosen = null;
      scene.tell(this.panel, null);
      this.list.mark("", "");
      this.#help();
    }

    /** Choose the actor under a point of the page. */
    pick(clientX, clientY) {
      const found = this.stage.at(clientX, clientY);
      if (!found) return this.#forget();
      const side = this.models.includes(found.model) ? this.modes.side(this.mode, found.model) : "truth";
      this.choose(found.actor.name, side, false, found.model);
    }

    /** Choose an actor by name; ``near``: come to it. */
    choose(name, side, near, given) {
      const model = given || this.models.find((one) => one.numbers.has(name) && this.modes.side(this.mode, one) === side) || this.models.find((one) => one.numbers.has(name));
      if (!model) return this.#forget();
      const actor = model.actors[model.numbers.get(name)];
      this.chosen = { name, side, box: model.box(actor) };
      scene.tell(this.panel, { actor, model, side, ...this.modes.told(name, side, this.trial) });
      this.list.mark(name, side);
      if (near) {
        const size = this.chosen.box.getSize(new THREE.Vector3()).length();
        this.stage.orbit.face(this.chosen.box.getCenter(new THREE.Vector3()), Math.max(2.2 * size, 1.5));
      }
      this.#help();
      const link = new URLSearchParams({ actor: name, ...(this.trial ? { of: this.trial.key } : {}) });
      history.replaceState(null, "", "#" + link);
    }

    /** Show an actor of a submission, as a link asks. */
    async go(key, name) {
      const place = this.index.trials.findIndex((trial) => trial.key === key);
      if (place >= 0) {
        this.which.selectedIndex = place;
        this.#cameras();
      }
      this.switches.at(-1).checked = true;
      await this.show();
      const model = this.models.find((one) => one.numbers.has(name));
      if (model) this.choose(name, this.modes.side(this.mode, model), true);
    }

    async open() {
      this.#cameras();
      this.models = await this.modes.models(this.mode, this.trial);
      await this.stand();
      await this.show();
    }
  }

  function colours(section) {
    const style = getComputedStyle(section);
    const names = ["same", "missing", "extra", "moved", "changed", "repaired", "met", "unmet", "physical", "chosen", "eye", "largest", "other", "reached", "astray"];
    return Object.fromEntries(names.map((name) => [name, style.getPropertyValue("--" + name).trim()]));
  }

  scene.show = async (section, root) => {
    const view = new View(section, root, await scene.index(root, section.dataset.name));
    await view.open();
    scene.view = view;
    return view;
  };
})();
