// java -cp /usr/share/java/j3dcore.jar:/usr/share/java/vecmath.jar case.java
import javax.media.j3d.BoundingSphere;
import javax.vecmath.Point3d;
import javax.vecmath.Vector3d;
class Case {
  public static void main(String[] arguments) {
    BoundingSphere ball = new BoundingSphere(new Point3d({cx}, {cy}, {cz}), {r});
    System.out.println(ball.intersect(new Point3d({ox}, {oy}, {oz}), new Vector3d({dx}, {dy}, {dz})) ? "hit" : "miss");
  }
}
