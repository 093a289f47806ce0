import java.awt.image.BufferedImage;
import java.io.File;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.HashMap;
import java.util.Map;
import javax.imageio.ImageIO;
import org.sunflow.SunflowAPI;
import org.sunflow.core.Display;
import org.sunflow.image.Color;
import org.sunflow.math.Matrix4;
import org.sunflow.math.Point3;
import org.sunflow.math.Vector3;

/**
 * Sunflow (Debian: libsunflow-java), a complete renderer: java Sunflow.java DRIVER IMAGE. Its pinhole camera has a field of view,
 * an aspect and a shift, and rays through the edges of the picture. Its spheres are the unit sphere, transformed. Source: the
 * wiki of sunflow.sourceforge.net, Cameras, Shaders and Primitives.
 */
class SunflowPictures {
  public static void main(String[] arguments) throws Exception {
    Map<String, float[]> view = new HashMap<>();
    SunflowAPI api = new SunflowAPI();
    int spheres = 0;
    for (String line : Files.readAllLines(Path.of(arguments[0]))) {
      String[] words = line.split("#")[0].trim().split(" +");
      float[] numbers = new float[words.length - 1];
      for (int k = 0; k < numbers.length; ++k) numbers[k] = Float.parseFloat(words[k + 1]);
      if (!words[0].equals("sphere")) {
        view.put(words[0], numbers);
        continue;
      }
      String name = "sphere" + spheres++;
      api.parameter("color", null, Arrays.copyOfRange(numbers, 4, 7));
      api.shader("shader of " + name, "constant");
      api.geometry(name, "sphere");
      api.parameter("shaders", "shader of " + name);
      api.parameter("transform",
                    Matrix4.translation(numbers[0], numbers[1], numbers[2]).multiply(Matrix4.scale(numbers[3])));
      api.instance("instance of " + name, name);
    }
    float[] eye = view.get("eye"), look = view.get("look"), up = view.get("up"), bounds = view.get("bounds");
    float near = -view.get("d")[0];
    if (near < 0) System.exit(77);
    api.parameter("transform", Matrix4.lookAt(new Point3(eye[0], eye[1], eye[2]), new Point3(look[0], look[1], look[2]),
                                              new Vector3(up[0], up[1], up[2])));
    api.parameter("fov", (float) Math.toDegrees(2 * Math.atan((bounds[1] - bounds[0]) / 2.0 / near)));
    api.parameter("aspect", (bounds[1] - bounds[0]) / (bounds[3] - bounds[2]));
    api.parameter("shift.x", (bounds[0] + bounds[1]) / 2 / near);
    api.parameter("shift.y", (bounds[2] + bounds[3]) / 2 / near);
    api.camera("camera", "pinhole");
    api.parameter("camera", "camera");
    api.parameter("resolutionX", (int) view.get("res")[0]);
    api.parameter("resolutionY", (int) view.get("res")[1]);
    api.parameter("sampler", "fast");
    api.parameter("threads", 1);
    api.options(SunflowAPI.DEFAULT_OPTIONS);
    Picture picture = new Picture();
    api.render(SunflowAPI.DEFAULT_OPTIONS, picture);
    ImageIO.write(picture.image, "png", new File(arguments[1]));
  }

  static class Picture implements Display {
    BufferedImage image;

    public void imageBegin(int width, int height, int bucket) {
      image = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
    }

    public void imagePrepare(int x, int y, int width, int height, int id) {}

    public void imageUpdate(int x, int y, int width, int height, Color[] colours, float[] opacities) {
      for (int k = 0; k < width * height; ++k) image.setRGB(x + k % width, y + k / width, colours[k].toRGB());
    }

    public void imageFill(int x, int y, int width, int height, Color colour, float opacity) {}

    public void imageEnd() {}
  }
}
