// java --module-path /usr/share/java/javafx-base.jar:/usr/share/java/javafx-graphics.jar --add-modules javafx.graphics --add-exports javafx.graphics/com.sun.javafx.geom=ALL-UNNAMED --add-exports javafx.graphics/com.sun.javafx.scene=ALL-UNNAMED --add-exports javafx.graphics/com.sun.javafx.scene.input=ALL-UNNAMED case.java
import com.sun.javafx.geom.PickRay;
import com.sun.javafx.geom.Vec3d;
import com.sun.javafx.scene.NodeHelper;
import com.sun.javafx.scene.input.PickResultChooser;
import javafx.scene.shape.CullFace;
import javafx.scene.shape.Sphere;
class Case {
  public static void main(String[] arguments) {
    Sphere ball = new Sphere({r});
    ball.setTranslateX({cx});
    ball.setTranslateY({cy});
    ball.setTranslateZ({cz});
    ball.setCullFace(CullFace.NONE);
    PickRay ray = new PickRay(new Vec3d({ox}, {oy}, {oz}), new Vec3d({dx}, {dy}, {dz}), 0, Double.POSITIVE_INFINITY);
    PickResultChooser result = new PickResultChooser();
    NodeHelper.pickNode(ball, ray, result);
    System.out.println(result.getIntersectedNode() == null ? "miss" : "" + result.getIntersectedDistance());
  }
}
