// An adapter whose queries go wrong, each in its own way.
import { Abstain, Refused, inBody, inWorld, serve } from "./touchstone_adapter.mjs";

async function bounds(scene) {
  console.log("an engine that prints");
  process.stdout.write("in two ways\n");
  const pose = scene.bodies[0].X_WB;
  const p = inWorld(pose, [1, 2, 3]);
  return [{ lo: Float64Array.from(p), hi: inBody(pose, p) }];
}

function distance() {
  throw new Abstain("not today");
}

const mass = () => [{ mass: 1, p_BBcm: [0, NaN, 0] }];

function penetration() {
  throw new Error("the engine failed");
}

function pixel() {
  throw new Refused("no compounds");
}

serve({ name: "faulty", version: "1", precision: "binary32" }, { mass, bounds, distance, penetration, pixel },
  { mass: (scene) => `ask about "${scene.bodies.length}"` });
