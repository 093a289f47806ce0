// java -cp /usr/share/java/sunflow.jar case.java
import org.sunflow.core.IntersectionState;
import org.sunflow.core.Ray;
import org.sunflow.core.primitive.Sphere;
class Case {
  public static void main(String[] arguments) {
    Ray ray = new Ray((float) {ox}, (float) {oy}, (float) {oz}, (float) {dx}, (float) {dy}, (float) {dz});
    new Sphere().intersectPrimitive(ray, 0, new IntersectionState());
    System.out.println(ray.getMax() == Float.POSITIVE_INFINITY ? "miss" : "" + ray.getMax());
  }
}
