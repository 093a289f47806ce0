package rt;

import java.util.OptionalDouble;

public class Sphere implements Shape {
    private final Vec centre;
    private static double radius;
    private final Vec ka;
    private final Vec kd;

    public Sphere(double[] n) {
        centre = new Vec(n[0], n[1], n[2]);
        radius = n[3];
        ka = new Vec(n[4], n[5], n[6]);
        kd = new Vec(n[7], n[8], n[9]);
    }

    /** d squared of the lecture. */
    private static double dSquared(Vec t, double v) {
        return radius * radius - (t.dot(t) - v * v);
    }

    @Override
    public OptionalDouble hit(Vec origin, Vec direction) {
        Vec t = centre.minus(origin);
        double v = t.dot(direction);
        double d2 = dSquared(t, v);
        if (d2 < 0) {
            return OptionalDouble.empty();
        }
        double d = Math.sqrt(d2);
        if (v - d >= 0) {
            return OptionalDouble.of(v - d);
        }
        return v + d >= 0 ? OptionalDouble.of(v + d) : OptionalDouble.empty();
    }

    @Override
    public Vec colourAt(Vec point, Scene scene) {
        Vec n = point.minus(centre).unit();
        Vec sum = scene.ambient.times(ka);
        for (double[] l : scene.lights) {
            Vec toLight = new Vec(l[0], l[1], l[2]).minus(point.times(l[3])).unit();
            double cos = n.dot(toLight);
            if (cos > 0) {
                sum = sum.plus(new Vec(l[4], l[5], l[6]).times(kd).times(cos));
            }
        }
        return sum;
    }
}
