package rt;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

public class Scene {
    Vec eye, look, up;
    double d, left, right, bottom, top;
    int width, height;
    Vec ambient = new Vec(0, 0, 0);
    final List<double[]> lights = new ArrayList<>();
    final List<Shape> shapes = new ArrayList<>();

    static Scene read(Path driver) throws IOException {
        Scene scene = new Scene();
        for (String line : Files.readAllLines(driver)) {
            String text = line.replaceAll("#.*", "").trim();
            if (text.isEmpty()) {
                continue;
            }
            String[] words = text.split("\\s+");
            double[] numbers = Arrays.stream(words).skip(1).mapToDouble(Double::parseDouble).toArray();
            Keyword.valueOf(words[0].toUpperCase()).apply(numbers, scene);
        }
        return scene;
    }
}
