/* Turning, moving and nearing by mouse, finger and keyboard, about a point. */
(function () {
  "use strict";
  const scene = c4sScene;
  const TURN = 0.005, KEY_TURN = 0.08, KEY_MOVE = 0.04, NEARER = 1.12, STEEPEST = Math.PI / 2 - 0.01;

  scene.Orbit = class {
    constructor(camera, canvas, changed) {
      Object.assign(this, { camera, canvas, changed, target: new THREE.Vector3(), around: 0, up: 0.5, away: 10 });
      this.fingers = new Map();
      canvas.addEventListener("pointerdown", (event) => this.#down(event));
      canvas.addEventListener("pointermove", (event) => this.#move(event));
      for (const end of ["pointerup", "pointercancel"]) canvas.addEventListener(end, (event) => this.fingers.delete(event.pointerId));
      canvas.addEventListener("wheel", (event) => {
        event.preventDefault();
        this.nearer(event.deltaY < 0 ? NEARER : 1 / NEARER);
      }, { passive: false });
      canvas.addEventListener("contextmenu", (event) => event.preventDefault());
      canvas.addEventListener("keydown", (event) => this.#key(event));
    }

    /** Stand so that the camera looks along ``forward``, with ``target`` at ``away`` before it. */
    stand(position, forward, away) {
      this.away = away;
      this.up = Math.asin(THREE.MathUtils.clamp(-forward.y, -1, 1));
      this.around = Math.atan2(-forward.x, -forward.z);
      this.target.copy(position).addScaledVector(forward, away);
      this.#place();
    }

    /** Turn to a point without turning the head. */
    face(target, away) {
      this.target.copy(target);
      this.away = away;
      this.#place();
    }

    nearer(factor) {
      this.away = THREE.MathUtils.clamp(this.away / factor, 0.05, 5000);
      this.#place();
    }

    turn(aside, upwards) {
      this.around += aside;
      this.up = THREE.MathUtils.clamp(this.up + upwards, -STEEPEST, STEEPEST);
      this.#place();
    }

    shift(right, upwards) {
      const along = new THREE.Vector3().setFromMatrixColumn(this.camera.matrix, 0).multiplyScalar(right * this.away);
      const above = new THREE.Vector3().setFromMatrixColumn(this.camera.matrix, 1).multiplyScalar(upwards * this.away);
      this.target.add(along).add(above);
      this.#place();
    }

    #place() {
      const flat = Math.cos(this.up);
      const back = new THREE.Vector3(Math.sin(this.around) * flat, Math.sin(this.up), Math.cos(this.around) * flat);
      this.camera.position.copy(this.target).addScaledVector(back, this.away);
      this.camera.lookAt(this.target);
      this.camera.updateMatrixWorld();
      this.changed();
    }

    #down(event) {
      this.canvas.setPointerCapture(event.pointerId);
      this.fingers.set(event.pointerId, [event.clientX, event.clientY]);
    }

    #move(event) {
      const before = this.fingers.get(event.pointerId);
      if (!before) return;
      const by = [event.clientX - before[0], event.clientY - before[1]];
      const others = [...this.fingers].filter(([id]) => id !== event.pointerId).map(([, place]) => place);
      this.fingers.set(event.pointerId, [event.clientX, event.clientY]);
      const size = this.canvas.clientHeight;
      if (others.length) {
        const [x, y] = others[0];
        const apart = (place) => Math.hypot(place[0] - x, place[1] - y) || 1;
        this.shift(-by[0] / size / 2, by[1] / size / 2);
        this.nearer(apart([event.clientX, event.clientY]) / apart(before));
      } else if (event.buttons & 6 || event.shiftKey) this.shift(-by[0] / size, by[1] / size);
      else this.turn(-by[0] * TURN, by[1] * TURN);
    }

    #key(event) {
      if (event.ctrlKey || event.metaKey || event.altKey) return;
      const arrows = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };
      const way = arrows[event.key];
      if (way && event.shiftKey) this.shift(way[0] * KEY_MOVE, way[1] * KEY_MOVE);
      else if (way) this.turn(way[0] * KEY_TURN, way[1] * KEY_TURN);
      else if (event.key === "+" || event.key === "=") this.nearer(NEARER);
      else if (event.key === "-") this.nearer(1 / NEARER);
      else return;
      event.preventDefault();
    }
  };
})();
