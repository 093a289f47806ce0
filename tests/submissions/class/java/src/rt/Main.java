package rt;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.OptionalDouble;

/** java -cp classes rt.Main scene.txt    writes scene.ppm into the current directory. */
public class Main {
    public static void main(String[] args) throws IOException {
        Path driver = Path.of(args[0]);
        Scene s = Scene.read(driver);
        Vec w = s.eye.minus(s.look).unit();
        Vec u = s.up.cross(w).unit();
        Vec v = w.cross(u);
        String name = driver.getFileName().toString().replaceFirst("\\.[^.]*$", "") + ".ppm";
        try (PrintWriter out = new PrintWriter(name)) {
            out.println("P3 " + s.width + " " + s.height + " 255");
            for (int row = s.height - 1; row >= 0; row--) {
                StringBuilder line = new StringBuilder();
                for (int col = 0; col < s.width; col++) {
                    double a = s.left + (double) col / (s.width - 1) * (s.right - s.left);
                    double b = s.bottom + (double) row / (s.height - 1) * (s.top - s.bottom);
                    Vec pixel = s.eye.plus(w.times(s.d)).plus(u.times(a)).plus(v.times(b));
                    line.append(trace(s, pixel, pixel.minus(s.eye).unit())).append("  ");
                }
                out.println(line);
            }
        }
    }

    private static String trace(Scene scene, Vec origin, Vec direction) {
        Shape nearest = null;
        double best = Double.POSITIVE_INFINITY;
        for (Shape shape : scene.shapes) {
            OptionalDouble s = shape.hit(origin, direction);
            if (s.isPresent() && s.getAsDouble() < best) {
                best = s.getAsDouble();
                nearest = shape;
            }
        }
        if (nearest == null) {
            return "0 0 0";
        }
        Vec c = nearest.colourAt(origin.plus(direction.times(best)), scene);
        return level(c.x) + " " + level(c.y) + " " + level(c.z);
    }

    private static long level(double x) {
        return Math.round(255 * Math.min(1, Math.max(0, x)));
    }
}
