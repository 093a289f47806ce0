// java -Xmx256m --module-path /usr/share/java/javafx-base.jar:/usr/share/java/javafx-graphics.jar --add-modules javafx.graphics --add-exports javafx.graphics/com.sun.javafx.geom=ALL-UNNAMED --add-exports javafx.graphics/com.sun.javafx.scene=ALL-UNNAMED --add-exports javafx.graphics/com.sun.javafx.scene.input=ALL-UNNAMED {}
// JavaFX's picking of a Sphere, in doubles: the distance from the camera to the intersected point of a pick ray. A scene makes
// pick rays of its camera and the mouse; this adapter makes them from an origin and a unit direction. Debian: libopenjfx-java.
// Source: PickResult.getIntersectedDistance; PickRay. Both faces count (CullFace.NONE). Silent on tangents.
// raycheck directions unit
// raycheck returns distance
// raycheck root nearest
// raycheck tangent either
// raycheck level ordinary
import com.sun.javafx.geom.PickRay;
import com.sun.javafx.geom.Vec3d;
import com.sun.javafx.scene.NodeHelper;
import com.sun.javafx.scene.input.PickResultChooser;
import java.io.BufferedReader;
import java.io.InputStreamReader;
import java.util.Arrays;
import javafx.scene.shape.CullFace;
import javafx.scene.shape.Sphere;

class JavaFX {
  public static void main(String[] arguments) {
    new BufferedReader(new InputStreamReader(System.in)).lines().forEach(line -> {
      double[] x = Arrays.stream(line.split(" ")).mapToDouble(Double::parseDouble).toArray();
      Sphere ball = new Sphere(x[9]);
      ball.setTranslateX(x[6]);
      ball.setTranslateY(x[7]);
      ball.setTranslateZ(x[8]);
      ball.setCullFace(CullFace.NONE);
      PickResultChooser result = new PickResultChooser();
      NodeHelper.pickNode(ball, new PickRay(new Vec3d(x[0], x[1], x[2]), new Vec3d(x[3], x[4], x[5]), 0, Double.POSITIVE_INFINITY), result);
      System.out.println(result.getIntersectedNode() == null ? "= miss" : "= " + result.getIntersectedDistance());
    });
  }
}
