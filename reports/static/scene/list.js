/* A list of actors that the keyboard goes through: arrows, Home, End, and the first letters of a name. */
(function () {
  "use strict";
  const scene = c4sScene;

  /** An element with attributes and children. */
  scene.make = (name, attributes = {}, ...children) => {
    const made = document.createElement(name);
    for (const [key, value] of Object.entries(attributes)) {
      if (value === true) made.setAttribute(key, "");
      else if (value !== false && value !== null) made.setAttribute(key, value);
    }
    made.append(...children.filter((child) => child !== null && child !== ""));
    return made;
  };

  scene.List = class {
    constructor(label, chosen) {
      this.chosen = chosen;
      this.rows = [];
      this.place = -1;
      this.root = scene.make("ul", { class: "scene-list", role: "listbox", tabindex: "0", "aria-label": label });
      this.root.addEventListener("keydown", (event) => this.#key(event));
      this.root.addEventListener("click", (event) => {
        const row = event.target.closest("li");
        if (row) this.choose([...this.root.children].indexOf(row));
      });
    }

    /** Show rows: ``{name, side, label, kind, told}``. */
    fill(rows) {
      this.rows = rows;
      this.place = -1;
      this.root.removeAttribute("aria-activedescendant");
      this.root.replaceChildren(...rows.map((row, place) => scene.make(
        "li", { role: "option", id: "scene-row-" + place, "aria-selected": "false" },
        row.kind ? scene.make("span", { class: "kind " + row.kind }, row.kind) : "",
        scene.make("span", { class: "label" }, row.label),
        row.told ? scene.make("span", { class: "dim" }, row.told) : "",
      )));
    }

    /** Mark a row, by name and side, without telling of it. */
    mark(name, side) {
      this.#to(this.rows.findIndex((row) => row.name === name && row.side === side));
    }

    choose(place) {
      if (place < 0 || place >= this.rows.length) return;
      this.#to(place);
      this.chosen(this.rows[place]);
    }

    #to(place) {
      const before = this.root.children[this.place];
      if (before) before.setAttribute("aria-selected", "false");
      this.place = place;
      const row = this.root.children[place];
      if (!row) return this.root.removeAttribute("aria-activedescendant");
      row.setAttribute("aria-selected", "true");
      this.root.setAttribute("aria-activedescendant", row.id);
      const [top, bottom] = [row.offsetTop - this.root.offsetTop, row.offsetTop - this.root.offsetTop + row.offsetHeight];
      if (top < this.root.scrollTop) this.root.scrollTop = top;
      else if (bottom > this.root.scrollTop + this.root.clientHeight) this.root.scrollTop = bottom - this.root.clientHeight;
    }

    #key(event) {
      const steps = { ArrowDown: this.place + 1, ArrowUp: Math.max(this.place - 1, 0), Home: 0, End: this.rows.length - 1 };
      if (event.key in steps) this.choose(steps[event.key]);
      else if (event.key.length === 1 && !event.ctrlKey && !event.metaKey && !event.altKey) {
        const letter = event.key.toLowerCase();
        const after = [...this.rows.keys()].map((at) => (this.place + 1 + at) % this.rows.length);
        this.choose(after.find((at) => this.rows[at].label.toLowerCase().startsWith(letter)) ?? -1);
      } else return;
      event.preventDefault();
    }
  };
})();
