/* A scene document as instanced meshes: one draw a mesh, its materials and handedness, however many actors there are. */
(function () {
  "use strict";
  const scene = c4sScene;
  const MIRROR = () => new THREE.Matrix4().makeScale(-1, 1, 1);

  /** The meshes of a document by their place, each read once. */
  async function geometries(root, shapes, document) {
    return Promise.all(document.meshes.map(async ([, sha256, low, high]) => {
      const name = shapes[sha256];
      if (!name) return scene.boxGeometry(low, high);
      return scene.once("geometry " + name, async () => scene.geometry(await scene.meshBytes(root, name)));
    }));
  }

  async function materials(root, shapes, document) {
    return Promise.all(document.materials.map((look) => scene.once("look " + JSON.stringify(look), async () => {
      const name = look.texture && shapes[look.texture];
      const made = new THREE.MeshLambertMaterial({
        color: new THREE.Color(...look.color),
        emissive: new THREE.Color(...look.emissive.map((value) => Math.min(value, 1))),
        side: THREE.DoubleSide,
      });
      if (look.opacity < 1) Object.assign(made, { transparent: true, opacity: look.opacity, depthWrite: look.opacity > 0.5 });
      if (name) {
        made.map = new THREE.Texture(await scene.picture(root, name));
        Object.assign(made.map, { wrapS: THREE.RepeatWrapping, wrapT: THREE.RepeatWrapping, flipY: false, encoding: THREE.sRGBEncoding, anisotropy: 4, needsUpdate: true });
        if (look.cut !== undefined) made.alphaTest = look.cut;
      }
      return made;
    })));
  }

  const kept = new Map();
  scene.once = (name, make) => {
    if (!kept.has(name)) kept.set(name, make());
    return kept.get(name);
  };

  const PLAIN = () => scene.once("plain", () => new THREE.MeshLambertMaterial({ color: 0xb5b5b5, side: THREE.DoubleSide }));
  /** Shows the colour of each instance alone. */
  const FLAT = () => scene.once("flat", () => new THREE.MeshLambertMaterial({ color: 0xffffff, side: THREE.DoubleSide }));
  const GHOST = () => scene.once("ghost", () => new THREE.MeshLambertMaterial({ color: 0xffffff, side: THREE.DoubleSide, transparent: true, opacity: 0.45, depthWrite: false }));

  /** A geometry of the same arrays, which instances of its own can be added to. */
  function shared(geometry) {
    const made = new THREE.BufferGeometry();
    for (const [name, attribute] of Object.entries(geometry.attributes)) made.setAttribute(name, attribute);
    made.setIndex(geometry.index);
    geometry.groups.forEach((group) => made.addGroup(group.start, group.count, group.materialIndex));
    return made;
  }

  /** What stands where: parts by what is drawn with one call. */
  function batches(document, wanted) {
    const found = new Map();
    const unit = scene.boxGeometry([-1, -1, -1], [1, 1, 1]);
    document.actors.forEach((actor, number) => {
      if (actor.hidden || !wanted(actor, number)) return;
      const parts = actor.parts.length || !actor.asset ? actor.parts : [[-1, [], [...actor.box.slice(0, 3), 0, 0, 0, 1, ...actor.box.slice(3)]]];
      for (const [mesh, looks, own] of parts) {
        const matrix = scene.matrix(own || actor.pose);
        const mirrored = matrix.determinant() < 0;
        const key = mesh + "|" + looks.join() + "|" + mirrored;
        if (!found.has(key)) found.set(key, { mesh, looks, mirrored, unit, items: [] });
        found.get(key).items.push([number, matrix]);
      }
    });
    return [...found.values()];
  }

  scene.Model = class {
    /** ``flat``: instances have colours instead of materials; ``ghost``: seen through; ``base``: added to pick ids. */
    static async make(root, shapes, document, { wanted = () => true, flat = false, ghost = false, base = 0 } = {}) {
      const [shape, look] = await Promise.all([geometries(root, shapes, document), materials(root, shapes, document)]);
      const made = new scene.Model(document, base);
      for (const batch of batches(document, wanted)) made.#add(batch, shape, look, flat, ghost);
      return made;
    }

    constructor(document, base) {
      this.base = base;
      this.document = document;
      this.actors = document.actors;
      this.numbers = new Map(document.actors.map((actor, number) => [actor.name, number]));
      this.group = new THREE.Group();
      this.group.matrixAutoUpdate = false;
      this.group.matrix.copy(scene.toThree());
      this.meshes = [];
    }

    #add({ mesh, looks, mirrored, unit, items }, shape, look, flat, ghost) {
      const geometry = shared(mesh < 0 ? unit : shape[mesh]);
      const ids = new Float32Array(items.length * 3);
      const slots = Math.max(...geometry.groups.map((group) => group.materialIndex)) + 1;
      const shown = flat ? (ghost ? GHOST() : FLAT()) : Array.from({ length: slots }, (_, slot) => look[looks[slot]] || PLAIN());
      const made = new THREE.InstancedMesh(geometry, shown, items.length);
      const own = mirrored ? MIRROR() : new THREE.Matrix4();
      made.matrixAutoUpdate = false;
      made.matrix.copy(own);
      made.frustumCulled = false;
      made.castShadow = !ghost && ![shown].flat().some((material) => material.transparent);
      made.receiveShadow = true;
      made.userData.seenThrough = Array.from({ length: slots }, (_, slot) => Boolean(look[looks[slot]]?.transparent));
      items.forEach(([number, matrix], place) => {
        made.setMatrixAt(place, own.clone().multiply(matrix));
        const id = this.base + number + 1;
        ids.set([(id & 255) / 255, ((id >> 8) & 255) / 255, ((id >> 16) & 255) / 255], place * 3);
      });
      geometry.setAttribute("pick", new THREE.InstancedBufferAttribute(ids, 3));
      made.userData.numbers = items.map(([number]) => number);
      this.meshes.push(made);
      this.group.add(made);
    }

    /** Draw something over the scene that is no part of it, in place of what was; null for nothing. */
    cover(overlay) {
      if (this.overlay) this.group.remove(this.overlay);
      this.overlay = overlay;
      if (overlay) this.group.add(overlay);
    }

    /** Colour each actor of a flat model. */
    paint(colourOf) {
      const colour = new THREE.Color();
      for (const mesh of this.meshes) {
        mesh.userData.numbers.forEach((number, place) => mesh.setColorAt(place, colour.set(colourOf(this.actors[number])).convertSRGBToLinear()));
        mesh.instanceColor.needsUpdate = true;
      }
    }

    /** The box of an actor in metres, axes of three.js. */
    box(actor) {
      const [x, y, z, ex, ey, ez] = actor.box;
      return new THREE.Box3(
        new THREE.Vector3((x - ex) / 100, (z - ez) / 100, (y - ey) / 100),
        new THREE.Vector3((x + ex) / 100, (z + ez) / 100, (y + ey) / 100),
      );
    }

    /** The box of all actors that are drawn; of the middle of them where a few lie far off. */
    bounds() {
      const all = new THREE.Box3();
      this.actors.forEach((actor) => actor.parts.length && !actor.hidden && all.union(this.box(actor)));
      return all.isEmpty() ? new THREE.Box3(new THREE.Vector3(-1, 0, -1), new THREE.Vector3(1, 1, 1)) : all;
    }
  };
})();
