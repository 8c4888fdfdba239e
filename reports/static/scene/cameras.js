/* The cameras of the evidence: standing where they stood, and their frusta. */
(function () {
  "use strict";
  const scene = c4sScene;
  const REACH = 1.2;

  /** Where a camera stands, in axes of three.js and metres, and half of what it sees at a distance of 1. */
  scene.cameraPose = (view) => {
    const [pitch, yaw, roll] = view.rotation_deg.map(THREE.MathUtils.degToRad);
    const [x, y, z] = view.location_cm;
    const [cp, sp, cy, sy, cr, sr] = [Math.cos(pitch), Math.sin(pitch), Math.cos(yaw), Math.sin(yaw), Math.cos(roll), Math.sin(roll)];
    const swap = (a, b, c) => new THREE.Vector3(a, c, b);
    const wide = Math.tan(THREE.MathUtils.degToRad(view.fov_deg) / 2);
    return {
      position: swap(x, y, z).multiplyScalar(0.01),
      forward: swap(cp * cy, cp * sy, sp),
      up: swap(-(cr * sp * cy + sr * sy), cy * sr - cr * sp * sy, cr * cp),
      wide,
      high: (wide * view.height) / view.width,
    };
  };

  /** The angle from bottom to top (degrees) at which a picture of this shape shows all that the view showed. */
  scene.fieldOf = (view, aspect) => {
    const { wide, high } = scene.cameraPose(view);
    return THREE.MathUtils.radToDeg(2 * Math.atan(Math.max(high, wide / aspect)));
  };

  /** Lines of the frusta of views. */
  scene.frusta = (views, colour) => {
    const points = [];
    for (const view of views) {
      const { position, forward, up, wide, high } = scene.cameraPose(view);
      const right = new THREE.Vector3().crossVectors(forward, up);
      const corner = (a, b) => position.clone().addScaledVector(forward, REACH)
        .addScaledVector(right, a * wide * REACH).addScaledVector(up, b * high * REACH);
      const corners = [corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1)];
      corners.forEach((one, place) => points.push(position, one, one, corners[(place + 1) % 4]));
      points.push(corner(-0.3, 1), corner(0, 1.4), corner(0, 1.4), corner(0.3, 1));
    }
    const material = new THREE.LineBasicMaterial({ color: colour });
    return new THREE.LineSegments(new THREE.BufferGeometry().setFromPoints(points), material);
  };
})();
