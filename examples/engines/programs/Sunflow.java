// java -Xmx256m -cp /usr/share/java/sunflow.jar {}
// Sunflow's primitive Sphere.intersectPrimitive, in floats: shortens a ray, whose direction it normalises, to the first hit of
// the unit sphere about the origin. Debian: libsunflow-java. Source: org.sunflow.core.Ray: t lies between its least t, 0, and
// its largest, both excluded. Silent on tangents.
// raycheck precision single
// raycheck lengths 1e-9 1e9
// raycheck placement unit
// raycheck roots () 0 inf absolute none
// raycheck returns distance
// raycheck root nearest
// raycheck tangent either
// raycheck level ordinary
import java.io.BufferedReader;
import java.io.InputStreamReader;
import java.util.Arrays;
import org.sunflow.core.IntersectionState;
import org.sunflow.core.Ray;
import org.sunflow.core.primitive.Sphere;

class Sunflow {
  public static void main(String[] arguments) {
    new BufferedReader(new InputStreamReader(System.in)).lines().forEach(line -> {
      double[] x = Arrays.stream(line.split(" ")).mapToDouble(Double::parseDouble).toArray();
      Ray ray = new Ray((float) x[0], (float) x[1], (float) x[2], (float) x[3], (float) x[4], (float) x[5]);
      new Sphere().intersectPrimitive(ray, 0, new IntersectionState());
      System.out.println(ray.getMax() == Float.POSITIVE_INFINITY ? "= miss" : "= " + ray.getMax());
    });
  }
}
