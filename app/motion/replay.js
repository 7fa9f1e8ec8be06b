"use strict";
// data: name, bodies (fixed, parts), frames ([time, x, y, z, qx, qy, qz, qw of each body]), events ([time, kind, a, b]).
const KINDS = ["impact", "micro-collision", "completed", "contact", "release", "force"];
const element = id => document.getElementById(id);
const first = data.frames.length ? data.frames[0][0] : 0;
const last = data.frames.length ? data.frames[data.frames.length - 1][0] : 0;
const dark = matchMedia("(prefers-color-scheme: dark)");
const colour = name => getComputedStyle(document.documentElement).getPropertyValue(name).trim();
const replay = {time: first, playing: false, speed: 1};

// The last k with times[k] <= time, at least 0.
function before(list, time) {
  let low = 0, high = list.length;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (list[middle][0] <= time) low = middle; else high = middle;
  }
  return low;
}

// The pose of a body: between two frames it moves along a line and turns at a constant rate.
replay.pose = (body, time) => {
  const k = before(data.frames, time), a = data.frames[k], b = data.frames[Math.min(k + 1, data.frames.length - 1)];
  const share = b[0] > a[0] ? Math.min(1, Math.max(0, (time - a[0]) / (b[0] - a[0]))) : 0, at = 1 + 7 * body;
  const quaternion = f => new THREE.Quaternion(f[at + 3], f[at + 4], f[at + 5], f[at + 6]).normalize();
  const turned = quaternion(a).slerp(quaternion(b), share);
  return {p: [0, 1, 2].map(i => a[at + i] + share * (b[at + i] - a[at + i])), q: turned};
};

function geometry(part) {
  if (part.radius) return new THREE.SphereBufferGeometry(part.radius, 40, 24);
  if (part.half) return new THREE.BoxBufferGeometry(...part.half.map(h => 2 * h));
  const corners = [];
  for (const face of part.faces) {
    for (let k = 2; k < face.length; ++k) for (const v of [face[0], face[k - 1], face[k]]) corners.push(...part.vertices[v]);
  }
  const hull = new THREE.BufferGeometry();
  hull.setAttribute("position", new THREE.Float32BufferAttribute(corners, 3));
  hull.computeVertexNormals();
  return hull;
}

// Three great circles, which show the rotation of a ball.
function circles(radius) {
  const points = [], turn = k => 2 * Math.PI * k / 48;
  for (let axis = 0; axis < 3; ++axis) {
    for (let k = 0; k < 48; ++k) {
      for (const angle of [turn(k), turn(k + 1)]) {
        const point = [Math.cos(angle), Math.sin(angle), 0].map(x => 1.004 * radius * x);
        points.push(point[axis], point[(axis + 1) % 3], point[(axis + 2) % 3]);
      }
    }
  }
  return new THREE.BufferGeometry().setAttribute("position", new THREE.Float32BufferAttribute(points, 3));
}

// Fixed bodies are transparent.
function solid(body, index) {
  const group = new THREE.Group();
  const hue = (index * 0.381966) % 1;
  for (const part of body.parts) {
    const shape = geometry(part);
    const paint = new THREE.MeshStandardMaterial({
      color: body.fixed ? new THREE.Color(0x8a93a5) : new THREE.Color().setHSL(hue, 0.55, 0.55), roughness: 0.7,
      flatShading: !part.radius, transparent: body.fixed, opacity: body.fixed ? 0.25 : 1, depthWrite: !body.fixed});
    const lines = part.radius ? circles(part.radius) : new THREE.EdgesGeometry(shape);
    const edges = new THREE.LineSegments(lines, new THREE.LineBasicMaterial({color: 0x30363f, transparent: true, opacity: 0.5}));
    const placed = new THREE.Group();
    placed.add(new THREE.Mesh(shape, paint), edges);
    placed.position.set(...part.p);
    placed.quaternion.set(...part.q).normalize();
    group.add(placed);
  }
  return group;
}

// A sphere around all positions of the moving bodies, for the camera's first view.
function extent() {
  const box = new THREE.Box3(), reach = data.bodies.map(body => Math.max(...body.parts.map(part =>
    Math.hypot(...part.p) + (part.radius || Math.max(...(part.half ? [Math.hypot(...part.half)] : part.vertices.map(v => Math.hypot(...v))))))));
  const step = Math.max(1, data.frames.length >> 5);
  data.bodies.forEach((body, b) => {
    if (body.fixed && data.bodies.some(other => !other.fixed)) return;
    for (let k = 0; k < data.frames.length; k += step) {
      const at = 1 + 7 * b, p = new THREE.Vector3(...data.frames[k].slice(at, at + 3));
      box.expandByPoint(p.clone().addScalar(reach[b])).expandByPoint(p.addScalar(-reach[b]));
    }
  });
  return box.isEmpty() ? new THREE.Sphere(new THREE.Vector3(), 1) : box.getBoundingSphere(new THREE.Sphere());
}

function stage() {
  const renderer = new THREE.WebGLRenderer({antialias: true});
  const view = element("view"), scene = new THREE.Scene(), around = extent();
  const camera = new THREE.PerspectiveCamera(45, 1, around.radius / 100, around.radius * 200);
  camera.up.set(0, 0, 1);
  camera.position.copy(around.center).add(new THREE.Vector3(0.9, -2.2, 0.9).multiplyScalar(around.radius * 1.15));
  const sun = new THREE.DirectionalLight(0xffffff, 0.8);
  sun.position.set(1, -2, 4);
  const sky = new THREE.HemisphereLight(0xffffff, 0x777777, 0.75);
  sky.position.set(0, 0, 1);
  scene.add(sky, sun);
  const solids = data.bodies.map(solid);
  scene.add(...solids);
  view.append(renderer.domElement);
  const controls = new THREE.OrbitControls(camera, renderer.domElement);
  controls.enableKeys = false;
  controls.target.copy(around.center);
  const draw = () => renderer.render(scene, camera);
  const fit = () => {
    renderer.setPixelRatio(devicePixelRatio);
    renderer.setSize(view.clientWidth, view.clientHeight, false);
    camera.aspect = view.clientWidth / Math.max(view.clientHeight, 1);
    camera.updateProjectionMatrix();
    renderer.setClearColor(colour("--paper"));
    draw();
  };
  controls.addEventListener("change", draw);
  controls.update();
  addEventListener("resize", fit);
  dark.addListener(fit);
  fit();
  replay.canvas = renderer.domElement;
  return () => {
    solids.forEach((group, body) => {
      const {p, q} = replay.pose(body, replay.time);
      group.position.set(...p);
      group.quaternion.copy(q);
    });
    draw();
  };
}

// Ticks above the slider: impacts in one colour, resting contacts in another.
function mark() {
  const canvas = element("marks"), pen = canvas.getContext("2d");
  canvas.width = canvas.clientWidth * devicePixelRatio;
  canvas.height = canvas.clientHeight * devicePixelRatio;
  const colours = [colour("--impact"), colour("--rest")], seen = new Set();
  for (const [time, kind] of data.events) {
    const x = Math.round((time - first) / (last - first || 1) * (canvas.width - 2)), impact = kind === 0;
    if (seen.has(2 * x + impact)) continue;
    seen.add(2 * x + impact);
    pen.fillStyle = colours[impact ? 0 : 1];
    pen.fillRect(x, impact ? 0 : canvas.height / 2, 2, canvas.height / 2);
  }
}

let show = () => {};
try {
  if (data.frames.length) show = stage(); else element("view").innerHTML = "<p>There is nothing to show.</p>";
} catch (error) {
  element("view").innerHTML = "<p>The bodies cannot be drawn: this browser gives no WebGL. Times and events are below.</p>";
}

replay.seek = time => {
  replay.time = Math.min(last, Math.max(first, time));
  const latest = data.events.length && data.events[0][0] <= replay.time ? before(data.events, replay.time) + 1 : 0;
  element("scrub").value = last > first ? 1000 * (replay.time - first) / (last - first) : 0;
  const event = latest ? data.events[latest - 1] : null;
  element("now").textContent = `${replay.time.toPrecision(5)} s` + (data.events.length ? ` · event ${latest} of ${data.events.length}` : "") +
    (event ? ` (${KINDS[event[1]]})` : "");
  show();
};

replay.step = count => {
  const k = before(data.frames, replay.time) + count;
  replay.seek(data.frames[Math.min(data.frames.length - 1, Math.max(0, k))][0]);
};

replay.event = forward => {
  const next = forward ? data.events.find(e => e[0] > replay.time) : data.events.filter(e => e[0] < replay.time).pop();
  if (next) replay.seek(next[0]);
};

replay.play = on => {
  if (on && replay.time >= last) replay.seek(first);
  replay.playing = on;
  element("play").textContent = on ? "Pause" : "Play";
  let then = performance.now();
  const tick = now => {
    if (!replay.playing) return;
    replay.seek(replay.time + replay.speed * Math.max(0, now - then) / 1000);
    then = now;
    if (replay.time >= last) replay.play(false); else requestAnimationFrame(tick);
  };
  if (on) requestAnimationFrame(tick);
};

const keys = {" ": () => replay.play(!replay.playing), ArrowRight: () => replay.step(1), ArrowLeft: () => replay.step(-1),
  n: () => replay.event(true), p: () => replay.event(false), Home: () => replay.seek(first), End: () => replay.seek(last)};
addEventListener("keydown", event => {
  const act = keys[event.key] || keys[event.key.toLowerCase()];
  if (!act || event.ctrlKey || event.metaKey || event.altKey || event.target.tagName === "SELECT") return;
  if (event.key === " " && event.target.tagName === "BUTTON") return;
  event.preventDefault();
  act();
});
element("scrub").addEventListener("input", event => replay.seek(first + (last - first) * event.target.value / 1000));
element("play").addEventListener("click", () => replay.play(!replay.playing));
element("on").addEventListener("click", () => replay.event(true));
element("back").addEventListener("click", () => replay.event(false));
element("speed").addEventListener("change", event => { replay.speed = Number(event.target.value); });
addEventListener("resize", mark);
dark.addListener(mark);
document.querySelector("h1").textContent = data.name || "a scene";
element("note").textContent = `${data.bodies.length} bodies, ${last} s, ${data.events.length} events`;
mark();
replay.seek(first);
