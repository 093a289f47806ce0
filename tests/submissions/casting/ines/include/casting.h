#pragma once
struct Vec {
  double x, y, z;
};
struct Ray {
  Vec origin, direction;
};
struct Camera {
  Vec eye;
  double distance, width, height;
};
struct Sphere {
  Vec centre;
  double radius;
  bool intersect(const Ray& ray, double min_t, double& t) const;
};
void viewing_ray(const Camera& camera, int i, int j, int width, int height, Ray& ray);
