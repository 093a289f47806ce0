// java -Xmx256m -cp /usr/share/java/sunflow.jar {}
// Sunflow's Solvers.solveQuadric, in doubles, for the textbook's rounded coefficients: both real roots in ascending order, or
// null. Debian: libsunflow-java. Source: org.sunflow.math.Solvers.
// raycheck returns roots
// raycheck root nearest
// raycheck tangent either
// raycheck level ordinary
import java.io.BufferedReader;
import java.io.InputStreamReader;
import java.util.Arrays;
import org.sunflow.math.Solvers;

class SunflowRoots {
  public static void main(String[] arguments) {
    new BufferedReader(new InputStreamReader(System.in)).lines().forEach(line -> {
      double[] x = Arrays.stream(line.split(" ")).mapToDouble(Double::parseDouble).toArray();
      double fx = x[0] - x[6], fy = x[1] - x[7], fz = x[2] - x[8];
      double[] s = Solvers.solveQuadric(x[3] * x[3] + x[4] * x[4] + x[5] * x[5], 2 * (fx * x[3] + fy * x[4] + fz * x[5]),
          fx * fx + fy * fy + fz * fz - x[9] * x[9]);
      System.out.println(s == null ? "= miss" : "= " + s[0] + " " + s[1]);
    });
  }
}
