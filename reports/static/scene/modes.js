/* What each mode shows: which scenes, in which colours, and the rows of its list. */
(function () {
  "use strict";
  const scene = c4sScene;
  const OVER = 0x800000;
  const MET = ["MATCH"], UNMET = ["MISMATCH"];

  /** Kinds of the legend, by whether submissions are compared with the truth. */
  scene.legendOf = (compared) => (compared
    ? { missing: "missing", extra: "extra", moved: "moved", changed: "changed", repaired: "repaired", physical: "floats or penetrates" }
    : { met: "meets a requirement", unmet: "fails one", physical: "floats or penetrates" });

  /** The kind of an actor of a submission: how it differs, else what verdicts say of it. */
  function kindOf(name, trial, compared) {
    if (compared) {
      if ((trial.said.submission[name] || []).some(([, outcome]) => outcome === "TP")) return "repaired";
      return trial.byName.get(name)?.kind || "";
    }
    const outcomes = (trial.said.submission[name] || []).map(([, outcome]) => outcome);
    if (outcomes.some((outcome) => UNMET.includes(outcome))) return "unmet";
    return outcomes.some((outcome) => MET.includes(outcome)) ? "met" : "";
  }

  scene.Modes = class {
    constructor(root, index, colours) {
      Object.assign(this, { root, index, colours, kept: new Map() });
      for (const trial of index.trials) {
        trial.byName = new Map(trial.differences.filter((one) => one.name).map((one) => [one.name, one]));
        trial.byTruth = new Map(trial.differences.filter((one) => one.truth).map((one) => [one.truth, one]));
      }
    }

    #model(name, key, choices) {
      const kept = key + " " + name;
      if (!this.kept.has(kept)) {
        this.kept.set(kept, scene.document(this.root, name).then((found) => scene.Model.make(this.root, this.index.shapes, found, choices)));
      }
      return this.kept.get(kept);
    }

    /** The models of a mode. */
    async models(mode, trial) {
      if (mode === "submission") return [await this.#model(trial.scene, "plain", {})];
      if (mode !== "difference") return [await this.#model(this.index.case[mode], "plain", {})];
      const flat = await this.#model(trial.scene, "flat", { flat: true });
      flat.paint((actor) => this.colours[kindOf(actor.name, trial, this.index.compared) || "same"]);
      if (!this.index.compared) return [flat];
      const gone = new Map(trial.differences.filter((one) => one.truth && one.kind !== "changed").map((one) => [one.truth, one.kind]));
      if (!gone.size) return [flat];
      const ghost = await this.#model(this.index.case.truth, "ghost " + trial.key, {
        wanted: (actor) => gone.has(actor.name), flat: true, ghost: true, base: OVER,
      });
      ghost.paint((actor) => this.colours[gone.get(actor.name)]);
      return [flat, ghost];
    }

    /** The name of the file that tells where one can walk in the first model of a mode; null where none does. */
    walk(mode, trial) {
      return (mode in this.index.case ? this.index.walks[mode] : trial?.walk) || null;
    }

    /** The side that a model of a mode is of. */
    side(mode, model) {
      if (mode === "difference") return model.base ? "truth" : "submission";
      return mode;
    }

    /** Rows of the list: what differs and what physics found, then, where all are wanted, every other actor. */
    rows(mode, trial, models, all) {
      const side = this.side(mode, models[0]);
      const label = (model, name) => model.actors[model.numbers.get(name)]?.label ?? name;
      const rows = [];
      if (trial && (mode === "difference" || mode === "submission")) {
        for (const one of trial.differences) {
          if (one.name) rows.push({ name: one.name, side, label: one.label, kind: one.kind, told: one.told });
          else if (mode === "difference") rows.push({ name: one.truth, side: "truth", label: one.label, kind: one.kind, told: one.told });
        }
        for (const name of trial.offenders) {
          const [, outcome, text] = trial.said.submission[name].find(([, outcome]) => ["floating", "penetrating"].includes(outcome));
          rows.push({ name, side, label: label(models[0], name), kind: "physical", told: outcome + ", " + text });
        }
        if (!this.index.compared) {
          const named = Object.keys(trial.said.submission).map((name) => ({ name, side, label: label(models[0], name), kind: kindOf(name, trial, false), told: "" }));
          for (const kind of ["unmet", "met"]) rows.push(...named.filter((row) => row.kind === kind));
        }
      }
      if (all || !rows.length) {
        const known = new Set(rows.map((row) => row.name));
        const others = models[0].actors.filter((actor) => !known.has(actor.name));
        rows.push(...others.map((actor) => ({ name: actor.name, side, label: actor.label, kind: "", told: "" })).sort((a, b) => a.label.localeCompare(b.label)));
      }
      return rows;
    }

    /** What is known of an actor beside its state. */
    told(name, side, trial) {
      if (!trial || side === "start") return { difference: null, said: [] };
      if (side === "submission") return { difference: trial.byName.get(name) || null, said: trial.said.submission[name] || [] };
      const said = trial.said.truth[name] || [];
      return { difference: trial.byTruth.get(name) || null, said };
    }
  };
})();
