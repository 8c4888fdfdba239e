/* The canvas: what is drawn, from where, and which actor a point of it shows. */
(function () {
  "use strict";
  const scene = c4sScene;
  const NEAR = 0.03, FIELD = 50, MOST_RATIO = 2;
  const MARK = 9, MARGIN = 1.04, SHADOW = 2048;
  const TIMED = 3, SLOW_MS = 60, COARSE = 0.5, REST_MS = 250;
  const SUN = new THREE.Vector3(0.4, 1, 0.28).normalize();

  /** Draws the id of each instance as its colour. */
  const idMaterial = () => {
    const made = new THREE.MeshBasicMaterial({ side: THREE.DoubleSide, toneMapped: false });
    made.onBeforeCompile = (shader) => {
      shader.vertexShader = shader.vertexShader
        .replace("#include <common>", "#include <common>\nattribute vec3 pick;\nvarying vec3 vPick;")
        .replace("#include <begin_vertex>", "#include <begin_vertex>\nvPick = pick;");
      shader.fragmentShader = shader.fragmentShader
        .replace("#include <common>", "#include <common>\nvarying vec3 vPick;")
        .replace("#include <dithering_fragment>", "gl_FragColor = vec4(vPick, 1.0);");
    };
    return made;
  };

  function renderer(canvas) {
    const probe = document.createElement("canvas");
    if (!probe.getContext("webgl2")) throw Object.assign(new Error("no WebGL"), { name: "NoWebGL" });
    const made = new THREE.WebGLRenderer({ canvas, antialias: true });
    made.outputEncoding = THREE.sRGBEncoding;
    Object.assign(made.shadowMap, { enabled: true, autoUpdate: false, type: THREE.PCFSoftShadowMap });
    made.setPixelRatio(Math.min(window.devicePixelRatio, MOST_RATIO));
    return made;
  }

  scene.Stage = class {
    constructor(canvas) {
      this.canvas = canvas;
      this.renderer = renderer(canvas);
      this.world = new THREE.Scene();
      this.camera = new THREE.PerspectiveCamera(FIELD, 16 / 9, NEAR, 1000);
      this.orbit = new scene.Orbit(this.camera, canvas, () => this.#moved());
      this.sun = new THREE.DirectionalLight(0xfff4e2, 0.62);
      this.sun.castShadow = true;
      this.fill = new THREE.DirectionalLight(0xe8f0ff, 0.12);
      this.fill.position.set(-0.6, 0.5, -0.8);
      this.world.add(new THREE.HemisphereLight(0xf4f8ff, 0x8a8378, 0.6), this.sun, this.sun.target, this.fill);
      this.helpers = new THREE.Group();
      this.world.add(this.helpers);
      Object.assign(this, { cost: 0, timed: 0 });
      this.panes = [[]];
      this.view = null;
      this.ids = idMaterial();
      this.none = new THREE.MeshBasicMaterial({ visible: false });
      this.cut = new THREE.Plane(new THREE.Vector3(0, -1, 0), Infinity);
      new ResizeObserver(() => this.#resize()).observe(canvas);
    }

    /** What is shown: a list of models a pane, side by side. */
    show(panes) {
      this.panes.flat().forEach((model) => this.world.remove(model.group));
      this.panes = panes;
      panes.flat().forEach((model) => this.world.add(model.group));
      this.#light(panes[0][0].bounds());
      this.draw();
    }

    /** Hide what lies above a height in metres; null shows all. */
    cutAt(height) {
      this.cut.constant = height;
      this.renderer.clippingPlanes = height === null ? [] : [this.cut];
      this.draw();
    }

    background(colour) {
      this.world.background = new THREE.Color(colour);
      this.draw();
    }

    /** Stand where a view of the evidence was taken from. */
    standAt(view, bounds) {
      const { position, forward } = scene.cameraPose(view);
      this.view = view;
      const middle = bounds.getCenter(new THREE.Vector3());
      this.orbit.stand(position, forward, Math.max(middle.sub(position).dot(forward), 1));
      this.#resize();
    }

    /** Look at a box as a whole, from a direction. */
    frame(bounds, from) {
      this.view = null;
      const middle = bounds.getCenter(new THREE.Vector3());
      const forward = new THREE.Vector3(...from).normalize().negate();
      this.orbit.stand(middle, forward, 1);
      const high = Math.tan(THREE.MathUtils.degToRad(FIELD) / 2);
      const wide = (high * this.canvas.clientWidth) / this.canvas.clientHeight / this.panes.length;
      const away = (corner) => {
        const seen = corner.sub(middle).applyQuaternion(this.camera.quaternion.clone().invert());
        return Math.max(Math.abs(seen.x) / wide, Math.abs(seen.y) / high) + seen.z;
      };
      const { min, max } = bounds;
      const corners = [0, 1, 2, 3, 4, 5, 6, 7].map((at) => new THREE.Vector3(at & 1 ? max.x : min.x, at & 2 ? max.y : min.y, at & 4 ? max.z : min.z));
      this.orbit.face(middle, MARGIN * Math.max(...corners.map(away)));
      this.#resize();
    }

    /** Let the sun's shadows reach all of a box. */
    #light(bounds) {
      const ball = bounds.getBoundingSphere(new THREE.Sphere());
      const { camera, mapSize } = this.sun.shadow;
      this.sun.target.position.copy(ball.center);
      this.sun.position.copy(ball.center).addScaledVector(SUN, 2 * ball.radius);
      Object.assign(camera, { left: -ball.radius, right: ball.radius, bottom: -ball.radius, top: ball.radius, near: 0.1, far: 4 * ball.radius });
      camera.updateProjectionMatrix();
      mapSize.setScalar(SHADOW);
      this.sun.shadow.normalBias = (3 * ball.radius) / SHADOW;
      this.renderer.shadowMap.needsUpdate = true;
    }

    #resize() {
      const { clientWidth, clientHeight } = this.canvas;
      if (!clientWidth) return;
      this.renderer.setSize(clientWidth, clientHeight, false);
      this.camera.aspect = clientWidth / this.panes.length / clientHeight;
      this.camera.fov = this.view ? scene.fieldOf(this.view, this.camera.aspect) : FIELD;
      this.camera.updateProjectionMatrix();
      this.draw();
    }

    /** A camera that moves is drawn coarsely where drawing is slow, and finely when it rests. */
    #moved() {
      if (this.cost > SLOW_MS) {
        clearTimeout(this.rest);
        this.#fine(COARSE);
        this.rest = setTimeout(() => this.#fine(1), REST_MS);
      }
      this.draw();
    }

    #fine(share) {
      const ratio = share * Math.min(window.devicePixelRatio, MOST_RATIO);
      if (this.renderer.getPixelRatio() === ratio) return;
      this.renderer.setPixelRatio(ratio);
      this.draw();
    }

    /** Draw before the next picture of the page; many changes are drawn once. */
    draw() {
      if (!this.due) this.due = requestAnimationFrame(() => this.drawNow());
    }

    drawNow() {
      cancelAnimationFrame(this.due);
      this.due = 0;
      const begun = performance.now();
      const { clientWidth: width, clientHeight: height } = this.canvas;
      const wide = width / this.panes.length;
      if (this.camera.aspect !== wide / height) return this.#resize();
      this.renderer.setScissorTest(this.panes.length > 1);
      this.panes.forEach((pane, place) => {
        this.#only(pane);
        if (this.panes.length > 1) this.renderer.shadowMap.needsUpdate = true;
        this.renderer.setViewport(place * wide, 0, wide, height);
        this.renderer.setScissor(place * wide, 0, wide, height);
        this.renderer.render(this.world, this.camera);
      });
      if (this.timed < TIMED) this.#time(begun);
    }

    /** How long drawing takes, of the first few pictures: reading a pixel waits for it. */
    #time(begun) {
      const gl = this.renderer.getContext();
      gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
      this.cost = performance.now() - begun;
      this.timed += 1;
    }

    #only(pane) {
      this.panes.flat().forEach((model) => (model.group.visible = pane.includes(model)));
    }

    /** Show or hide what is no actor. */
    #aside(pane, visible) {
      this.helpers.visible = visible;
      for (const { overlay } of pane) if (overlay) overlay.visible = visible;
    }

    /**
     * Ids of a pane drawn at this size, row by row from the bottom: 0 where nothing is, else one more than the actor's.
     * Glass is seen through, as in the masks of the evidence.
     */
    idsOf(pane, width, height) {
      const target = new THREE.WebGLRenderTarget(width, height);
      const { background } = this.world;
      this.#only(pane);
      this.#aside(pane, false);
      this.world.background = null;
      const shown = pane.flatMap((model) => model.meshes).map((mesh) => [mesh, mesh.material]);
      for (const [mesh] of shown) mesh.material = mesh.userData.seenThrough.map((glass) => (glass ? this.none : this.ids));
      this.renderer.setScissorTest(false);
      this.renderer.setRenderTarget(target);
      this.renderer.setClearColor(0, 0);
      this.renderer.clear();
      this.renderer.render(this.world, this.camera);
      const data = new Uint8Array(4 * width * height);
      this.renderer.readRenderTargetPixels(target, 0, 0, width, height, data);
      this.renderer.setRenderTarget(null);
      target.dispose();
      for (const [mesh, material] of shown) mesh.material = material;
      this.world.background = background;
      this.#aside(pane, true);
      return Array.from({ length: width * height }, (_, at) => data[4 * at] | (data[4 * at + 1] << 8) | (data[4 * at + 2] << 16));
    }

    /** The actor under a point of the page, with its model; null where there is none. */
    at(clientX, clientY) {
      const place = this.canvas.getBoundingClientRect();
      const wide = place.width / this.panes.length;
      const x = clientX - place.left;
      const pane = this.panes[Math.min(Math.floor(x / wide), this.panes.length - 1)];
      this.camera.setViewOffset(wide, place.height, x % wide, clientY - place.top, 1, 1);
      const [id] = this.idsOf(pane, 1, 1);
      this.camera.clearViewOffset();
      this.draw();
      if (!id) return null;
      const model = pane.find((one) => id > one.base && id <= one.base + one.actors.length);
      return { model, actor: model.actors[id - model.base - 1] };
    }

    /** Boxes around actors, and a point above each that is seen from afar. */
    mark(boxes, colour) {
      const group = new THREE.Group();
      for (const box of boxes) {
        const lines = new THREE.Box3Helper(box.clone().expandByScalar(0.01), new THREE.Color(colour).convertSRGBToLinear());
        group.add(lines);
      }
      const tops = boxes.map((box) => box.getCenter(new THREE.Vector3()).setY(box.max.y + 0.08));
      const dots = new THREE.PointsMaterial({ color: new THREE.Color(colour).convertSRGBToLinear(), size: MARK, sizeAttenuation: false, depthTest: false });
      group.add(new THREE.Points(new THREE.BufferGeometry().setFromPoints(tops), dots));
      return group;
    }
  };
})();
