struct Vector3 {
  double e[3];
};
Vector3 make(double x, double y, double z);
Vector3 plus(const Vector3& a, const Vector3& b, double times = 1);
Vector3 cross(const Vector3& a, const Vector3& b);
Vector3 unit(const Vector3& a);
double dot(const Vector3& a, const Vector3& b);
