package rt;

/** An immutable triple, used for points, vectors and colours. */
public final class Vec {
    public final double x, y, z;

    public Vec(double x, double y, double z) {
        this.x = x;
        this.y = y;
        this.z = z;
    }

    public Vec plus(Vec o) { return new Vec(x + o.x, y + o.y, z + o.z); }
    public Vec minus(Vec o) { return new Vec(x - o.x, y - o.y, z - o.z); }
    public Vec times(double k) { return new Vec(k * x, k * y, k * z); }
    public Vec times(Vec o) { return new Vec(x * o.x, y * o.y, z * o.z); }
    public double dot(Vec o) { return x * o.x + y * o.y + z * o.z; }
    public Vec cross(Vec o) { return new Vec(y * o.z - z * o.y, z * o.x - x * o.z, x * o.y - y * o.x); }
    public Vec unit() { return times(1 / Math.sqrt(dot(this))); }
}
