// The clouds in three dimensions, by three.js. Positions are 16-bit steps from an origin of each
// cloud; matrices are made in double precision about a base, so that coordinates of millions of
// meters lose nothing on the graphics card.
"use strict";

const RAMP = ["#46327e", "#365c8d", "#277f8e", "#1fa187", "#4ac16d", "#a0da39", "#f0e51c"];
const BEYOND = { light: "#aab2bb", dark: "#4a545f" };

const rgb = (hex) => [1, 3, 5].map((i) => parseInt(hex.slice(i, i + 2), 16) / 255);

function unpacked(text) {
  const bytes = Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
  return new Uint16Array(bytes.buffer);
}

const POINT_VERTEX = `
  attribute float error;
  uniform float pointSize, minimumSize;
  varying float vError;
  void main() {
    vec4 seen = modelViewMatrix * vec4(position, 1.0);
    gl_Position = projectionMatrix * seen;
    gl_PointSize = clamp(pointSize / -seen.z, minimumSize, 40.0);
    vError = error;
  }`;
const POINT_FRAGMENT = `
  uniform vec3 color, beyond, ramp[7];
  uniform float maximum, limit;
  varying float vError;
  void main() {
    if (length(gl_PointCoord - 0.5) > 0.5) discard;
    vec3 shown = color;
    if (limit > 0.0) {
      float share = vError * maximum / limit * 6.0;
      int low = int(min(share, 5.0));
      shown = share > 6.0 ? beyond : mix(ramp[low], ramp[low + 1], share - float(low));
    }
    gl_FragColor = vec4(shown, 1.0);
  }`;
// Eye-dome lighting: a pixel is darker the more its neighbors are in front of it.
const SHADE_FRAGMENT = `
  uniform sampler2D colors, depths;
  uniform vec2 pixel;
  uniform float near, far, strength;
  uniform vec3 ground;
  varying vec2 at;
  float away(vec2 where) {
    float z = texture2D(depths, where).x;
    return log2(near * far / (far - z * (far - near)));
  }
  void main() {
    float here = away(at);
    float sum = 0.0;
    for (int i = 0; i < 8; ++i) {
      float angle = 0.7853982 * float(i);
      sum += max(0.0, here - away(at + pixel * vec2(cos(angle), sin(angle))));
    }
    bool empty = texture2D(depths, at).x >= 1.0;
    float shade = exp(-strength * sum / 8.0);
    vec3 color = empty ? ground : texture2D(colors, at).rgb * mix(0.35, 1.0, shade);
    gl_FragColor = vec4(color, 1.0);
  }`;
const SHADE_VERTEX = `
  varying vec2 at;
  void main() { at = position.xy * 0.5 + 0.5; gl_Position = vec4(position.xy, 0.0, 1.0); }`;

/// Clouds that can be looked at from all sides. A page says which colors they have (colorOf), which
/// of them are to be seen (seen), and what else changes how they are painted (paint).
class Scene {
  constructor(canvas, up, base) {
    this.canvas = canvas;
    this.base = base; // the point that is the origin on the graphics card
    this.renderer = new THREE.WebGLRenderer({ canvas, antialias: false });
    this.camera = new THREE.PerspectiveCamera(38, 1, 0.1, 10);
    this.camera.up.fromArray(up).normalize();
    this.controls = new THREE.OrbitControls(this.camera, canvas);
    this.controls.addEventListener("change", () => this.draw());
    this.scene = new THREE.Scene();
    this.points = {};
    this.target = new THREE.WebGLRenderTarget(1, 1, { depthTexture: new THREE.DepthTexture(1, 1) });
    this.shade = this.makeShade();
    this.size = 1;
    this.unit = ""; // of the clouds, for the scale bar
  }

  /// Begins to draw, once the clouds are there.
  begin() {
    this.theme();
    this.look();
    new ResizeObserver(() => this.resize()).observe(this.canvas.parentElement);
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => this.theme());
    this.canvas.addEventListener("keydown", (event) => this.pressed(event));
    this.resize();
  }

  seen() {
    return Object.keys(this.points);
  }

  paint() {}

  /// Arrow keys orbit, shift and arrow keys pan, + and - zoom, Home shows all.
  pressed(event) {
    const arrow = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] }[event.key];
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    if (arrow && event.shiftKey) this.pan(arrow[0], -arrow[1]);
    else if (arrow) this.orbit(arrow[0] * 0.09, arrow[1] * 0.09);
    else if (event.key === "+" || event.key === "=") this.zoom(0.88);
    else if (event.key === "-") this.zoom(1 / 0.88);
    else if (event.key === "Home") this.look();
    else return;
    event.preventDefault();
  }

  add(name, cloud) {
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute("position", new THREE.BufferAttribute(unpacked(cloud.points), 3));
    geometry.setAttribute("error", new THREE.BufferAttribute(new Uint16Array(cloud.shown), 1, true));
    const material = new THREE.ShaderMaterial({
      vertexShader: POINT_VERTEX,
      fragmentShader: POINT_FRAGMENT,
      uniforms: {
        pointSize: { value: 1 }, minimumSize: { value: 1 }, maximum: { value: 1 }, limit: { value: 0 },
        color: { value: [1, 1, 1] }, beyond: { value: [1, 1, 1] }, ramp: { value: RAMP.map(rgb).flat() },
      },
    });
    const points = new THREE.Points(geometry, material);
    points.frustumCulled = false;
    points.matrixAutoUpdate = false;
    this.scene.add(points);
    this.points[name] = points;
    return points;
  }

  makeShade() {
    const geometry = new THREE.BufferGeometry();
    const corners = new Float32Array([-1, -1, 0, 3, -1, 0, -1, 3, 0]);
    geometry.setAttribute("position", new THREE.BufferAttribute(corners, 3));
    const material = new THREE.ShaderMaterial({
      vertexShader: SHADE_VERTEX,
      fragmentShader: SHADE_FRAGMENT,
      depthTest: false,
      uniforms: {
        colors: { value: this.target.texture }, depths: { value: this.target.depthTexture },
        pixel: { value: new THREE.Vector2() }, near: { value: 1 }, far: { value: 2 },
        strength: { value: 1 }, ground: { value: [1, 1, 1] },
      },
    });
    const mesh = new THREE.Mesh(geometry, material);
    mesh.frustumCulled = false;
    const scene = new THREE.Scene();
    scene.add(mesh);
    return { scene, uniforms: material.uniforms };
  }

  /// Sets the matrix of a cloud's points: steps to coordinates, `pose`, about the base.
  place(points, pose, cloud) {
    const away = new THREE.Matrix4().makeTranslation(...this.base.map((x) => -x));
    const begin = new THREE.Matrix4().makeTranslation(...cloud.origin);
    const scale = new THREE.Matrix4().makeScale(cloud.step, cloud.step, cloud.step);
    points.matrix.copy(away.multiply(pose).multiply(begin).multiply(scale));
    points.matrixWorldNeedsUpdate = true;
  }

  /// Some thousand points of what is to be seen, where they are now.
  sample() {
    const found = [];
    for (const name of this.seen()) {
      const { geometry, matrix } = this.points[name];
      const position = geometry.getAttribute("position");
      for (let i = 0; i < position.count; i += 1 + Math.floor(position.count / 3000))
        found.push(new THREE.Vector3().fromBufferAttribute(position, i).applyMatrix4(matrix));
    }
    return found;
  }

  bounds() {
    const seen = this.sample();
    const center = new THREE.Box3().setFromPoints(seen).getCenter(new THREE.Vector3());
    return { center, radius: Math.max(...seen.map((p) => p.distanceTo(center))) || 1 };
  }

  show(name, visible) {
    this.points[name].visible = visible;
    this.draw();
  }

  /// Looks at all of it from the side that shows most, from a little above.
  look() {
    this.sphere = this.bounds();
    const { center } = this.sphere;
    const up = this.camera.up;
    const side = new THREE.Vector3(1, 0, 0).addScaledVector(up, -up.x);
    if (side.length() < 0.1) side.set(0, 1, 0).addScaledVector(up, -up.y);
    side.normalize();
    const ahead = new THREE.Vector3().crossVectors(up, side);
    const seen = this.sample().map((p) => p.sub(center));
    let [xx, xy, yy] = [0, 0, 0];
    for (const p of seen) {
      const [x, y] = [p.dot(side), p.dot(ahead)];
      xx += x * x; xy += x * y; yy += y * y;
    }
    const long = 0.5 * Math.atan2(2 * xy, xx - yy); // of the longest horizontal direction
    const from = side.multiplyScalar(Math.sin(long)).addScaledVector(ahead, -Math.cos(long))
      .addScaledVector(up, 0.6).normalize();
    const right = new THREE.Vector3().crossVectors(up, from).normalize();
    const above = new THREE.Vector3().crossVectors(from, right);
    const lens = Math.tan((this.camera.fov / 2) * Math.PI / 180) * 0.9; // a tenth is margin
    let away = 0;
    for (const p of seen)
      away = Math.max(away, p.dot(from) + Math.max(Math.abs(p.dot(above)), Math.abs(p.dot(right)) / this.camera.aspect) / lens);
    this.controls.target.copy(center);
    this.camera.position.copy(center).addScaledVector(from, away);
    this.controls.update();
    this.draw();
  }

  orbit(around, above) {
    const up = new THREE.Quaternion().setFromUnitVectors(this.camera.up, new THREE.Vector3(0, 1, 0));
    const arm = this.camera.position.clone().sub(this.controls.target).applyQuaternion(up);
    const ball = new THREE.Spherical().setFromVector3(arm);
    ball.theta += around;
    ball.phi += above;
    ball.makeSafe();
    arm.setFromSpherical(ball).applyQuaternion(up.invert());
    this.camera.position.copy(this.controls.target).add(arm);
    this.controls.update();
    this.draw();
  }

  zoom(factor) {
    const arm = this.camera.position.clone().sub(this.controls.target);
    this.camera.position.copy(this.controls.target).addScaledVector(arm, factor);
    this.controls.update();
    this.draw();
  }

  pan(right, up) {
    const step = 0.05 * this.camera.position.distanceTo(this.controls.target);
    const move = new THREE.Vector3().setFromMatrixColumn(this.camera.matrix, 0).multiplyScalar(right * step)
      .addScaledVector(new THREE.Vector3().setFromMatrixColumn(this.camera.matrix, 1), up * step);
    this.camera.position.add(move);
    this.controls.target.add(move);
    this.controls.update();
    this.draw();
  }

  theme() {
    const dark = matchMedia("(prefers-color-scheme: dark)").matches;
    this.shade.uniforms.ground.value = this.ground = this.variable("--view");
    for (const [name, points] of Object.entries(this.points)) {
      points.material.uniforms.color.value = this.colorOf(name);
      points.material.uniforms.beyond.value = rgb(dark ? BEYOND.dark : BEYOND.light);
    }
    this.draw();
  }

  /// A color of the style sheet.
  variable(name) {
    return rgb(getComputedStyle(document.documentElement).getPropertyValue(name).trim());
  }

  resize() {
    const { clientWidth, clientHeight } = this.canvas.parentElement;
    if (!clientWidth || !clientHeight) return;
    const ratio = Math.min(devicePixelRatio || 1, 2);
    this.renderer.setPixelRatio(ratio);
    this.renderer.setSize(clientWidth, clientHeight, false);
    this.target.setSize(clientWidth * ratio, clientHeight * ratio);
    const first = !this.sized;
    this.sized = true;
    this.camera.aspect = clientWidth / clientHeight;
    this.camera.updateProjectionMatrix();
    if (first) this.look();
    this.draw();
  }

  /// Draws once before the next picture of the screen, however often it is called.
  draw() {
    if (this.waiting || !this.sized) return;
    this.waiting = true;
    requestAnimationFrame(() => {
      this.waiting = false;
      this.drawNow();
    });
  }

  drawNow() {
    const { camera, sphere, renderer } = this;
    const away = camera.position.distanceTo(sphere.center);
    const reach = 1.6 * sphere.radius;
    camera.near = Math.max(away - reach, 0.002 * sphere.radius);
    camera.far = away + reach;
    camera.updateProjectionMatrix();
    const height = this.target.height;
    const lens = height / (2 * Math.tan((camera.fov / 2) * Math.PI / 180));
    for (const [name, points] of Object.entries(this.points)) {
      const count = points.geometry.getAttribute("position").count;
      const gap = 2 * sphere.radius / Math.sqrt(Math.max(count, 1));
      points.material.uniforms.pointSize.value = this.size * gap * lens;
      points.material.uniforms.minimumSize.value = 1.2 * this.size * renderer.getPixelRatio();
      this.paint(name, points.material.uniforms);
    }
    const { uniforms } = this.shade;
    uniforms.near.value = camera.near;
    uniforms.far.value = camera.far;
    uniforms.pixel.value.set(1.3 * renderer.getPixelRatio() / this.target.width,
      1.3 * renderer.getPixelRatio() / height);
    uniforms.strength.value = 45 * away / sphere.radius;
    renderer.setRenderTarget(this.target);
    renderer.clear();
    renderer.render(this.scene, camera);
    renderer.setRenderTarget(null);
    renderer.render(this.shade.scene, camera);
    this.showScale(this.canvas.clientHeight / (2 * Math.tan((camera.fov / 2) * Math.PI / 180)) /
      camera.position.distanceTo(this.controls.target));
  }

  /// The scale bar: a round length at the center of the orbit, where a unit is so many pixels long.
  showScale(pixels) {
    const length = roundStep(110 / pixels);
    byId("scale-bar").style.width = `${length * pixels}px`;
    byId("scale-text").textContent = this.unit ? `${rounded(length, 3)} ${this.unit}` : rounded(length, 3);
  }
}
