// node case.mjs, beside node_modules with minimatrix-polyroots
import { getQuadraticRoots } from "minimatrix-polyroots";
const [fx, fy, fz] = [{ox} - {cx}, {oy} - {cy}, {oz} - {cz}];
const a = {dx} * {dx} + {dy} * {dy} + {dz} * {dz}, b = 2 * (fx * {dx} + fy * {dy} + fz * {dz});
const c = fx * fx + fy * fy + fz * fz - {r} * {r};
const roots = getQuadraticRoots(a, b, c).filter(({ imag }) => imag === 0).map(({ real }) => real).sort((s, t) => s - t);
console.log(roots.find((s) => s >= 0) ?? "miss");
