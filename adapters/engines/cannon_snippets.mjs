// Programs in the API of cannon-es for the adapter's queries about bodies at rest: each asks what the adapter asks, and
// prints what the engine says. They run where cannon-es is installed: `node --input-type=module < snippet`.
import { unitQuaternion } from "../js/touchstone_adapter.mjs";
import { partsOf } from "./cannon_bodies.mjs";

const head = `import * as CANNON from "cannon-es";
const vector = (v) => new CANNON.Vec3(...v);
`;

function shapeOf(shape) {
  if (shape.type === "sphere") return `new CANNON.Sphere(${shape.radius})`;
  if (shape.type === "box") return `new CANNON.Box(vector(${JSON.stringify(shape.half_extents)}))`;
  return `new CANNON.ConvexPolyhedron({\n  vertices: ${JSON.stringify(shape.vertices)}.map(vector),
  faces: ${JSON.stringify(shape.faces)} })`;
}

const quaternion = (q) => (({ w, x, y, z }) => `new CANNON.Quaternion(${x}, ${y}, ${z}, ${w})`)(unitQuaternion(q));

const added = ({ shape, X_BP: { p, q } }) => `  body.addShape(${shapeOf(shape)}, vector(${JSON.stringify(p)}),
    ${quaternion(q)});
`;

export const bounds = (scene) => head + scene.bodies.map(({ shape, X_WB }) => `{
  const body = new CANNON.Body({ position: vector(${JSON.stringify(X_WB.p)}), quaternion: ${quaternion(X_WB.q)} });
${partsOf(shape).map(added).join("")}  body.updateAABB();
  console.log("box from", body.aabb.lowerBound, "to", body.aabb.upperBound);
}
`).join("");
