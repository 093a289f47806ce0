// node case.mjs, beside node_modules with paper
import paper from "paper/dist/paper-core.js";
const [fx, fy, fz] = [{ox} - {cx}, {oy} - {cy}, {oz} - {cz}], roots = [];
const a = {dx} * {dx} + {dy} * {dy} + {dz} * {dz}, b = 2 * (fx * {dx} + fy * {dy} + fz * {dz});
const c = fx * fx + fy * fy + fz * fz - {r} * {r};
paper.Numerical.solveQuadratic(a, b, c, roots);
console.log(roots.sort((s, t) => s - t).find((s) => s >= 0) ?? "miss");
