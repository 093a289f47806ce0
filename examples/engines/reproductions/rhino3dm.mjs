// node case.mjs, beside node_modules with rhino3dm
import initRhino from "rhino3dm";
const Rhino = await initRhino();
const line = new Rhino.Line([{ox}, {oy}, {oz}], [{ox} + {dx}, {oy} + {dy}, {oz} + {dz}]);
const [kind, first] = Rhino.Intersection.lineSphere(line, new Rhino.Sphere([{cx}, {cy}, {cz}], {r}));
console.log(kind.value === 0 ? "miss" : first.join(" "));
