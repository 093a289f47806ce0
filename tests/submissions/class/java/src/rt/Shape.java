package rt;

import java.util.OptionalDouble;

/** Anything a ray can run into. */
public interface Shape {
    OptionalDouble hit(Vec origin, Vec direction);

    Vec colourAt(Vec point, Scene scene);
}
