// The scans of a model, each in a color of its own.
"use strict";

/// The color of the i-th of `count` scans, as rgb from 0 to 1: hues around the circle, of two
/// brightnesses, so that neighbors in the list differ in both.
function colorOfScan(i, count) {
  const hue = count > 6 ? (i * 0.618034) % 1 : i / count;
  const [saturation, light] = [0.68, i % 2 ? 0.4 : 0.58];
  const part = (k) => {
    const at = (k + hue * 12) % 12;
    return light - saturation * Math.min(light, 1 - light) * Math.max(-1, Math.min(at - 3, 9 - at, 1));
  };
  return [part(0), part(8), part(4)];
}

const cssColor = (color) => `rgb(${color.map((v) => Math.round(255 * v)).join(" ")})`;

class ModelView extends Scene {
  /// `scans` have a cloud and a pose, scan -> model; `members` are the indices of those of a model.
  constructor(canvas, up, scans, members) {
    super(canvas, up, [0, 0, 0]);
    this.scans = scans;
    scans.forEach((scan, i) => { if (scan.cloud) this.add(i, scan.cloud); });
    this.choose(members);
    this.begin();
  }

  /// Shows another model.
  choose(members) {
    this.members = members;
    this.on = new Set(members);
    const [first] = members;
    const { pose, cloud } = this.scans[first];
    this.base = pose.slice(0, 3).map((row) => row[0] * cloud.origin[0] + row[1] * cloud.origin[1] + row[2] * cloud.origin[2] + row[3]);
    for (const i of members)
      this.place(this.points[i], new THREE.Matrix4().set(...this.scans[i].pose.flat()), this.scans[i].cloud);
    this.update();
    this.look();
  }

  show(i, visible) {
    if (visible) this.on.add(i);
    else this.on.delete(i);
    this.update();
    this.draw();
  }

  update() {
    for (const [name, points] of Object.entries(this.points)) points.visible = this.on.has(Number(name));
  }

  /// The camera looks at the whole model, however many of its scans are shown.
  seen() {
    return this.members;
  }

  colorOf(name) {
    const i = Number(name);
    const place = this.scans[i].place;
    return colorOfScan(place.index, place.count);
  }
}
