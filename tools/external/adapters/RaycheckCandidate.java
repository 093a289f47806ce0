import java.io.BufferedReader;
import java.io.FileDescriptor;
import java.io.FileOutputStream;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;

/**
 * A candidate for raycheck in Java: a class that overrides some of these functions, and whose
 * main() calls run(). Needs only Java's library. Compile both files and
 *
 * <pre>raycheck check SCENE --candidate "command:java -cp FOLDER Mine"</pre>
 *
 * Output of the functions goes to standard error. The protocol is that of docs/candidates.md.
 */
public abstract class RaycheckCandidate {
  public record Vector(double x, double y, double z) {}
  public record Camera(Vector eye, Vector lookAt, Vector up, double near, double left, double right,
      double bottom, double top, long width, long height) {}
  public record Frame(Vector u, Vector v, Vector w) {}
  public record Pixel(long i, long j) {}
  public record Ray(Vector origin, Vector direction) {}
  public record Sphere(Vector centre, double radius) {}
  /** A hit at the point origin + s direction. */
  public record Hit(double s, Vector point) {}
  /** Words as in scene files: "top-first", "centres", "focal", "smaller", "miss", ... */
  public record Conventions(
      String rows, String samples, String origin, String root, String tangent) {}

  /** The camera's axes. */
  public Frame frame(Camera camera) { throw new UnsupportedOperationException(); }
  /** P. */
  public Vector pixelPoint(Camera camera, Conventions asked, Pixel pixel) {
    throw new UnsupportedOperationException();
  }
  /** From P along the unit vector P - E. */
  public Ray pixelRay(Camera camera, Conventions asked, Pixel pixel) {
    throw new UnsupportedOperationException();
  }
  /** From E along the unit vector P - E. */
  public Ray focalRay(Camera camera, Conventions asked, Pixel pixel) {
    throw new UnsupportedOperationException();
  }
  /** Null: a miss. */
  public Hit intersect(Ray ray, Sphere sphere, Conventions asked) {
    throw new UnsupportedOperationException();
  }
  /** The index of the sphere that is hit first; -1 if none is. */
  public int nearest(Ray ray, List<Sphere> spheres, Conventions asked) {
    throw new UnsupportedOperationException();
  }
  /** The point of the sphere that is seen through a pixel. Null: a miss. */
  public Hit pick(Camera camera, Conventions asked, Pixel pixel, Sphere sphere) {
    throw new UnsupportedOperationException();
  }
  /** Its declarations: "rows top-first", "t_min 1e-4", and the others of `raycheck list`. */
  public List<String> declared() { return List.of(); }
  /** The level at which it is judged: "ordinary", "demanding" or "extreme"; null: ordinary. */
  public String level() { return null; }
  /** The range of lengths; scenes with a nonzero length outside are not judged; null: any. */
  public double[] lengths() { return null; }
  /**
   * The format in which it computes: "double" or "single"; null: double. With single, all inputs
   * are floats, and errors are counted in units of float.
   */
  public String precision() { return null; }
  /**
   * Which roots count: "() 1e-4 100 absolute none" (ends, t_min, t_max, "absolute", "radius" or
   * "length", culling); null: every root >= 0.
   */
  public String roots() { return null; }
  /** "unit" if it requires unit directions; null: any. */
  public String directions() { return null; }
  /**
   * What it returns for a hit: "parameter", "point", "distance", "squared-distance", "class" or
   * "roots", v - d as s and v + d as point.x (the rest of a Hit means nothing then); null: s and
   * the point.
   */
  public String returns() { return null; }

  private record Name(String java, String asked) {}
  private static final List<Name> FUNCTIONS = List.of(new Name("frame", "frame"),
      new Name("pixelPoint", "pixel_point"), new Name("pixelRay", "pixel_ray"),
      new Name("focalRay", "focal_ray"), new Name("intersect", "intersect"),
      new Name("nearest", "nearest"), new Name("pick", "pick"));

  private static class Request {
    String id, function;
    Conventions asked;
    Camera camera;
    final List<Pixel> pixels = new ArrayList<>();
    final List<Ray> rays = new ArrayList<>();
    final List<Sphere> spheres = new ArrayList<>();
  }

  /** Answers raycheck until it has no more requests. */
  public final void run(String name) throws IOException {
    PrintStream replies = new PrintStream(
        new FileOutputStream(FileDescriptor.out), false, StandardCharsets.US_ASCII);
    System.setOut(System.err);
    BufferedReader lines =
        new BufferedReader(new InputStreamReader(System.in, StandardCharsets.US_ASCII));
    String greeting = lines.readLine();
    if (greeting == null || !greeting.startsWith("raycheck ")) {
      throw new IOException("not started by --candidate: 'raycheck 1' is missing on standard input");
    }
    StringBuilder said = new StringBuilder("raycheck 1 " + name + "\n");
    for (Name function : FUNCTIONS) {
      if (offers(function.java)) said.append("function ").append(function.asked).append('\n');
    }
    for (String declaration : declared()) said.append(declaration).append('\n');
    double[] lengths = lengths();
    String told = lengths == null ? null : text(lengths[0]) + " " + text(lengths[1]);
    for (String[] one : new String[][] {{"level", level()}, {"roots", roots()},
             {"precision", precision()}, {"directions", directions()}, {"returns", returns()},
              {"lengths", told}}) {
      if (one[1] != null) said.append(one[0]).append(' ').append(one[1]).append('\n');
    }
    send(replies, said.append("ready\n"));
    for (Request request; (request = read(lines)) != null;) {
      StringBuilder reply = new StringBuilder("reply " + request.id + "\n");
      try {
        answer(request, reply);
        reply.append("end ").append(request.id).append('\n');
      } catch (RuntimeException error) {
        reply.append("error ").append(request.id).append(' ');
        reply.append(String.valueOf(error).replace('\n', ' ')).append('\n');
      }
      send(replies, reply);
    }
  }

  private boolean offers(String function) {
    for (Class<?> type = getClass(); type != RaycheckCandidate.class; type = type.getSuperclass()) {
      for (var method : type.getDeclaredMethods()) {
        if (method.getName().equals(function)) return true;
      }
    }
    return false;
  }

  private static void send(PrintStream to, StringBuilder text) {
    to.print(text);
    to.flush();
  }

  private static double number(String word) {
    return switch (word) {
      case "inf" -> Double.POSITIVE_INFINITY;
      case "-inf" -> Double.NEGATIVE_INFINITY;
      case "nan", "-nan" -> Double.NaN;
      default -> Double.parseDouble(word);
    };
  }
  private static Vector vector(String[] words, int at) {
    return new Vector(number(words[at]), number(words[at + 1]), number(words[at + 2]));
  }

  private static Request read(BufferedReader lines) throws IOException {
    String line = lines.readLine();
    if (line == null) return null;
    Request request = new Request();
    request.id = line.split(" ")[1];
    request.function = line.split(" ")[2];
    while (true) {
      String[] words = lines.readLine().split(" ");
      int count = words[0].matches("pixels|rays|spheres") ? Integer.parseInt(words[1]) : 0;
      switch (words[0]) {
        case "end":
          return request;
        case "conventions":
          request.asked = new Conventions(words[1], words[2], words[3], words[4], words[5]);
          break;
        case "roots":
          break;  // the candidate has declared them itself
        case "camera":
          request.camera = new Camera(vector(words, 1), vector(words, 4), vector(words, 7),
              number(words[10]), number(words[11]), number(words[12]), number(words[13]),
              number(words[14]), Long.parseLong(words[15]), Long.parseLong(words[16]));
          break;
        case "pixels":
        case "rays":
        case "spheres":
          for (int k = 0; k < count; ++k) item(words[0], lines.readLine().split(" "), request);
          break;
        default:
          throw new IOException("no such part of a request: " + words[0]);
      }
    }
  }

  private static void item(String kind, String[] words, Request request) {
    switch (kind) {
      case "pixels" ->
        request.pixels.add(new Pixel(Long.parseLong(words[0]), Long.parseLong(words[1])));
      case "rays" -> request.rays.add(new Ray(vector(words, 0), vector(words, 3)));
      default -> request.spheres.add(new Sphere(vector(words, 0), number(words[3])));
    }
  }

  private static String text(double x) {
    if (Double.isNaN(x)) return "nan";
    if (Double.isInfinite(x)) return x > 0 ? "inf" : "-inf";
    return Double.toString(x);
  }
  private static String text(Vector v) { return text(v.x) + " " + text(v.y) + " " + text(v.z); }
  private static String text(Ray ray) { return text(ray.origin) + " " + text(ray.direction); }

  private void answer(Request request, StringBuilder reply) {
    switch (request.function) {
      case "frame" -> {
        Frame axes = frame(request.camera);
        for (Vector axis : List.of(axes.u, axes.v, axes.w)) reply.append(text(axis)).append('\n');
      }
      case "pixel_point", "pixel_ray", "focal_ray" -> {
        for (Pixel pixel : request.pixels) {
          reply.append(switch (request.function) {
            case "pixel_point" -> text(pixelPoint(request.camera, request.asked, pixel));
            case "pixel_ray" -> text(pixelRay(request.camera, request.asked, pixel));
            default -> text(focalRay(request.camera, request.asked, pixel));
          }).append('\n');
        }
      }
      case "intersect", "pick" -> {
        boolean picks = request.function.equals("pick");
        for (int s = 0; s < request.spheres.size(); ++s) {
          Sphere sphere = request.spheres.get(s);
          for (int r = 0; r < (picks ? request.pixels : request.rays).size(); ++r) {
            Hit hit = picks ? pick(request.camera, request.asked, request.pixels.get(r), sphere)
                            : intersect(request.rays.get(r), sphere, request.asked);
            if (hit == null) continue;
            reply.append(r).append(' ').append(s).append(' ').append(text(hit.s)).append(' ');
            reply.append(hit.point == null ? "0 0 0" : text(hit.point)).append('\n');
          }
        }
      }
      case "nearest" -> {
        for (Ray ray : request.rays) {
          int index = nearest(ray, request.spheres, request.asked);
          reply.append(index < 0 ? "none" : Integer.toString(index)).append('\n');
        }
      }
      default -> throw new IllegalArgumentException("no such function: " + request.function);
    }
  }
}
