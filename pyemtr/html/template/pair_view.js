// The pair of a page: the target, the source as it was given, and the source on its way.
"use strict";

class PairView extends Scene {
  constructor(canvas, payload, poses) {
    const { target, source } = payload.clouds;
    super(canvas, payload.up, poses[0] ? payload.report.normalization.center_target : target.origin);
    this.payload = payload;
    this.poses = poses; // matrices, source into target, as nested lists
    for (const [name, cloud] of [["target", target], ["before", source], ["aligned", source]])
      this.add(name, cloud);
    this.place(this.points.target, new THREE.Matrix4(), target);
    this.place(this.points.before, new THREE.Matrix4(), source);
    this.points.before.visible = false;
    this.progress = 1;
    this.errors = false;
    this.limit = 1;
    this.choose(0);
    this.begin();
  }

  seen() {
    return ["target", "aligned", ...(this.points.before.visible ? ["before"] : [])];
  }

  colorOf(name) {
    return this.variable({ target: "--target", before: "--before", aligned: "--source" }[name]);
  }

  /// The target steps back where the errors are shown.
  paint(name, uniforms) {
    if (name === "target")
      uniforms.color.value = this.colorOf(name).map((v, i) => (this.errors ? 0.3 * v + 0.7 * this.ground[i] : v));
    uniforms.limit.value = name === "aligned" && this.errors ? this.limit : 0;
  }

  /// The source's pose on its way: its center moves straight while it rotates.
  between(matrix, share) {
    const whole = new THREE.Matrix4().set(...matrix.flat());
    const rotation = new THREE.Quaternion(), size = new THREE.Vector3();
    whole.decompose(new THREE.Vector3(), rotation, size);
    const scale = 1 + (size.x - 1) * share;
    const part = new THREE.Quaternion().slerp(rotation, share);
    const center = new THREE.Vector3(...this.payload.report.normalization.center_source);
    const moved = center.clone().lerp(center.clone().applyMatrix4(whole), share);
    const back = new THREE.Matrix4().makeTranslation(-center.x, -center.y, -center.z);
    return new THREE.Matrix4().makeTranslation(moved.x, moved.y, moved.z)
      .multiply(new THREE.Matrix4().makeRotationFromQuaternion(part))
      .multiply(new THREE.Matrix4().makeScale(scale, scale, scale)).multiply(back);
  }

  choose(index) {
    this.pose = index;
    const entry = this.payload.residuals[index];
    const aligned = this.points.aligned;
    if (entry) {
      aligned.geometry.setAttribute("error", new THREE.BufferAttribute(unpacked(entry.values), 1, true));
      aligned.material.uniforms.maximum.value = entry.maximum;
    }
    this.move(this.progress);
  }

  /// 0: the source as it was given, 1: aligned. The camera follows what it sees.
  move(share) {
    const before = this.sphere;
    this.progress = share;
    const matrix = this.poses[this.pose];
    this.place(this.points.aligned, matrix ? this.between(matrix, share) : new THREE.Matrix4(),
      this.payload.clouds.source);
    this.sphere = this.bounds();
    if (before) {
      const { target } = this.controls;
      const arm = this.camera.position.clone().sub(target);
      target.add(this.sphere.center.clone().sub(before.center));
      this.camera.position.copy(target).addScaledVector(arm, this.sphere.radius / before.radius);
      this.controls.update();
    }
    this.draw();
  }
}
