// java -cp /usr/share/java/sunflow.jar case.java
import org.sunflow.math.Solvers;
class Case {
  public static void main(String[] arguments) {
    double fx = {ox} - {cx}, fy = {oy} - {cy}, fz = {oz} - {cz}, dx = {dx}, dy = {dy}, dz = {dz}, r = {r};
    double[] s = Solvers.solveQuadric(dx * dx + dy * dy + dz * dz, 2 * (fx * dx + fy * dy + fz * dz),
        fx * fx + fy * fy + fz * fz - r * r);
    System.out.println(s == null || s[1] < 0 ? "miss" : "" + (s[0] >= 0 ? s[0] : s[1]));
  }
}
