package rt;

/** What a line of the driver may start with, and what to do about it. */
public enum Keyword {
    CAMERA {
        @Override void apply(double[] n, Scene s) {
            s.eye = new Vec(n[0], n[1], n[2]);
            s.look = new Vec(n[3], n[4], n[5]);
            s.up = new Vec(n[6], n[7], n[8]);
            s.d = n[9];
        }
    },
    BOUNDS {
        @Override void apply(double[] n, Scene s) {
            s.left = n[0];
            s.right = n[1];
            s.bottom = n[2];
            s.top = n[3];
        }
    },
    RES {
        @Override void apply(double[] n, Scene s) {
            s.width = (int) n[0];
            s.height = (int) n[1];
        }
    },
    AMBIENT {
        @Override void apply(double[] n, Scene s) { s.ambient = new Vec(n[0], n[1], n[2]); }
    },
    LIGHT {
        @Override void apply(double[] n, Scene s) { s.lights.add(n); }
    },
    SPHERE {
        @Override void apply(double[] n, Scene s) { s.shapes.add(new Sphere(n)); }
    },
    RECURSIONLEVEL {
        @Override void apply(double[] n, Scene s) { /* reflections come with PA4 */ }
    };

    abstract void apply(double[] numbers, Scene scene);
}
