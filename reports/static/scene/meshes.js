/* Meshes as warehouse/scenes/shapes.py writes them, and boxes for meshes that are not there. */
(function () {
  "use strict";
  const scene = c4sScene;

  function stepped(steps, low, high) {
    const width = low.length;
    const made = new Float32Array(steps.length);
    for (let place = 0; place < steps.length; place++) {
      const axis = place % width;
      made[place] = low[axis] + (steps[place] / 65535) * (high[axis] - low[axis]);
    }
    return made;
  }

  /** The geometry of unpacked mesh bytes, in cm and Unreal's axes, with a group a slot. */
  scene.geometry = (data) => {
    const length = new DataView(data.buffer, data.byteOffset).getUint32(0, true);
    const head = JSON.parse(new TextDecoder().decode(data.subarray(4, 4 + length)));
    let at = data.byteOffset + 4 + length;
    const take = (Kind, count) => {
      const array = new Kind(data.buffer, at, count);
      at += Math.ceil(array.byteLength / 4) * 4;
      return array;
    };
    const made = new THREE.BufferGeometry();
    const count = head.vertices;
    made.setAttribute("position", new THREE.BufferAttribute(stepped(take(Uint16Array, 3 * count), head.low, head.high), 3));
    made.setAttribute("normal", new THREE.BufferAttribute(take(Int8Array, 3 * count), 3, true));
    made.setAttribute("uv", new THREE.BufferAttribute(stepped(take(Uint16Array, 2 * count), head.uv_low, head.uv_high), 2));
    if (head.colors) made.setAttribute("color", new THREE.BufferAttribute(take(Uint8Array, 3 * count), 3, true));
    made.setIndex(new THREE.BufferAttribute(take(head.wide ? Uint32Array : Uint16Array, head.indices), 1));
    head.groups.forEach(([slot, first, size]) => made.addGroup(first, size, slot));
    made.computeBoundingSphere();
    return made;
  };

  /** A box between two corners, for a mesh that no pack here has. */
  scene.boxGeometry = (low, high) => {
    const size = [0, 1, 2].map((axis) => Math.max(high[axis] - low[axis], 0.1));
    const made = new THREE.BoxGeometry(...size);
    made.translate(...[0, 1, 2].map((axis) => (low[axis] + high[axis]) / 2));
    made.clearGroups();
    made.addGroup(0, Infinity, 0);
    return made;
  };

  /** Unreal's axes (left-handed, Z up, cm) to those of three.js (right-handed, Y up, m). */
  scene.toThree = () => new THREE.Matrix4().set(0.01, 0, 0, 0, 0, 0, 0.01, 0, 0, 0.01, 0, 0, 0, 0, 0, 1);

  /** The matrix of a pose: place, quaternion (x, y, z, w), scale. The algebra is the same in both kinds of axes. */
  scene.matrix = (pose) => new THREE.Matrix4().compose(
    new THREE.Vector3(pose[0], pose[1], pose[2]),
    new THREE.Quaternion(pose[3], pose[4], pose[5], pose[6]),
    new THREE.Vector3(pose[7], pose[8], pose[9]),
  );
})();
