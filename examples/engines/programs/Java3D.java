// java -Xmx256m -cp /usr/share/java/j3dcore.jar:/usr/share/java/vecmath.jar {}
// Java 3D's BoundingSphere.intersect(Point3d, Vector3d), in doubles: "Test for intersection with a ray", of any direction.
// Debian: libjava3d-java. Source: its documentation. A sphere is the solid ball, which is the same here. Silent on tangents.
// raycheck returns class
// raycheck root nearest
// raycheck tangent either
// raycheck level ordinary
import java.io.BufferedReader;
import java.io.InputStreamReader;
import java.util.Arrays;
import javax.media.j3d.BoundingSphere;
import javax.vecmath.Point3d;
import javax.vecmath.Vector3d;

class Java3D {
  public static void main(String[] arguments) {
    new BufferedReader(new InputStreamReader(System.in)).lines().forEach(line -> {
      double[] x = Arrays.stream(line.split(" ")).mapToDouble(Double::parseDouble).toArray();
      BoundingSphere ball = new BoundingSphere(new Point3d(x[6], x[7], x[8]), x[9]);
      boolean hit = ball.intersect(new Point3d(x[0], x[1], x[2]), new Vector3d(x[3], x[4], x[5]));
      System.out.println(hit ? "= hit" : "= miss");
    });
  }
}
