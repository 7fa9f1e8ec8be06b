// Reads the test vectors beside this file. It needs nothing else; copy both where you like.
//
//     node read_vectors.mjs            how many vectors there are
//     import { vectors, isAllowed } from "./read_vectors.mjs";
//     for (const test of vectors("distance")) {
//       const said = myEngineDistance(test.scene);
//       if (!isAllowed(said, test.answer.distance_enclosure, test.allowed.binary64)) throw new Error(test.id);
//     }
import { readFileSync } from "node:fs";
import { pathToFileURL } from "node:url";

export const queries = ["mass", "bounds", "broad_phase", "distance", "penetration", "pixel", "impulse",
  "time_of_impact", "simulation", "constraint"];

// The array of the test vectors of a query: objects with id, classes, source, scale, scene and answer.
export const vectors = (query) => JSON.parse(readFileSync(new URL(`${query}.json`, import.meta.url), "utf8")).tests;

// The double nearest to a rational number, written as in "exact": "-3/4". A limit of either whole number is 2^1023.
export const nearly = (text) => {
  const [above, below = "1"] = text.split("/");
  return Number(above) / Number(below);
};

// Is a number within `allowed` of an interval that contains the exact one? The two sums are rounded.
export const isAllowed = (said, [low, high], allowed) => said >= low - allowed && said <= high + allowed;

if (process.argv[1] && import.meta.url === pathToFileURL(process.argv[1]).href) {
  for (const query of queries) console.log(query.padEnd(16) + String(vectors(query).length).padStart(5) + " vectors");
}
