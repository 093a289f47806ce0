/** NAME, a candidate for raycheck: call your function below, and declare its conventions. */
public class NAME extends RaycheckCandidate {
  @Override
  public Hit intersect(Ray ray, Sphere sphere, Conventions asked) {
    // Return null for a miss, or new Hit(s, point) with the point at origin + s direction.
    throw new IllegalStateException("NAME: calls nothing yet");
  }

  // "root smaller" is always v - d. If they apply, also override precision(), roots(), directions(),
  // returns().
  @Override
  public java.util.List<String> declared() {
    return java.util.List.of("root nearest", "tangent either");
  }

  public static void main(String[] arguments) throws java.io.IOException {
    new NAME().run("NAME");
  }
}
