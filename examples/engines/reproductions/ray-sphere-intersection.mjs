// node case.mjs, beside node_modules with ray-sphere-intersection
import intersectRaySphere from "ray-sphere-intersection";
const point = intersectRaySphere([], [{ox}, {oy}, {oz}], [{dx}, {dy}, {dz}], [{cx}, {cy}, {cz}], {r});
console.log(point ? point.join(" ") : "miss");
