/* Where a body can walk: floors, the foot of each target by whether it is reached, and the routes. */
(function () {
  "use strict";
  const scene = c4sScene;
  const AREAS = ["largest", "other"];
  const LIFT = 2, FRAME = 6, ROUTE = 12;
  /** Strips are at least this share of what they lie in: a hair of a farm is seen from nowhere. */
  const LEAST = 1 / 300;

  /** A flat quadrangle of corners in cm and Unreal's axes. */
  const quad = (to, corners) => {
    const [a, b, c, d] = corners;
    to.push(...a, ...b, ...c, ...a, ...c, ...d);
  };

  const plate = (to, x0, y0, x1, y1, z) => quad(to, [[x0, y0, z], [x1, y0, z], [x1, y1, z], [x0, y1, z]]);

  function frame(to, x0, y0, x1, y1, z, wide) {
    plate(to, x0 - wide, y0 - wide, x1 + wide, y0, z);
    plate(to, x0 - wide, y1, x1 + wide, y1 + wide, z);
    plate(to, x0 - wide, y0, x0, y1, z);
    plate(to, x1, y0, x1 + wide, y1, z);
  }

  /** A ribbon along a route. */
  function ribbon(to, points, lift, wide) {
    for (let at = 1; at < points.length; at++) {
      const [a, b] = [points[at - 1], points[at]];
      const length = Math.hypot(b[0] - a[0], b[1] - a[1]) || 1;
      const across = [(-(b[1] - a[1]) * wide) / 2 / length, ((b[0] - a[0]) * wide) / 2 / length];
      const side = (point, sign) => [point[0] + sign * across[0], point[1] + sign * across[1], point[2] + lift];
      quad(to, [side(a, 1), side(a, -1), side(b, -1), side(b, 1)]);
    }
  }

  function mesh(corners, colour, opacity, order) {
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute("position", new THREE.Float32BufferAttribute(corners, 3));
    const made = new THREE.Mesh(geometry, new THREE.MeshBasicMaterial({
      color: new THREE.Color(colour).convertSRGBToLinear(), side: THREE.DoubleSide, transparent: true, opacity, depthWrite: false,
    }));
    made.frustumCulled = false;
    made.renderOrder = order;
    return made;
  }

  /** The longer side of what holds all these points in plan. */
  function spanOf(points) {
    const side = (axis) => points.reduce(([low, high], point) => [Math.min(low, point[axis]), Math.max(high, point[axis])], [Infinity, -Infinity]);
    return points.length ? Math.max(...[0, 1].map((axis) => side(axis)[1] - side(axis)[0])) : 0;
  }

  /** What the legend says, by the kind of what is drawn. */
  scene.WALKED = {
    largest: "largest walkable area", other: "other walkable areas", reached: "target or route that is reached", astray: "target or route that is not",
  };

  /** The drawing of a walk, in the axes of a scene document. */
  scene.walkOverlay = (walk, colours) => {
    const drawn = { largest: [], other: [], reached: [], astray: [] };
    const span = spanOf([...walk.targets.map((one) => one.slice(2, 4)), ...walk.routes.flatMap((one) => one.points)]);
    const [framed, routed] = [Math.max(FRAME, (span * LEAST) / 2), Math.max(ROUTE, span * LEAST)];
    for (const [x0, y0, x1, y1, z, largest] of walk.floors || []) plate(drawn[largest ? "largest" : "other"], x0, y0, x1, y1, z + LIFT);
    for (const [, fall, x0, y0, x1, y1, z] of walk.targets) {
      if (fall === "connected") frame(drawn.reached, x0, y0, x1, y1, z + 2 * LIFT, framed);
      if (["unconnected", "unreached"].includes(fall)) frame(drawn.astray, x0, y0, x1, y1, z + 2 * LIFT, framed);
    }
    for (const { points, arrived } of walk.routes) ribbon(drawn[arrived ? "reached" : "astray"], points, 4 * LIFT, routed);
    const group = new THREE.Group();
    for (const [kind, corners] of Object.entries(drawn)) {
      const [opacity, order] = AREAS.includes(kind) ? [0.5, 1] : [0.9, 2];
      if (corners.length) group.add(mesh(corners, colours[kind], opacity, order));
    }
    group.userData.counts = Object.fromEntries(Object.entries(drawn).map(([kind, corners]) => [kind, corners.length / 18]));
    return group;
  };
})();
