% octave-cli --quiet case.m
pkg load matgeom
line = [{ox} {oy} {oz} {dx} {dy} {dz}];
points = intersectLineSphere(line, [{cx} {cy} {cz} {r}]);
[~, first] = min((points - line(1:3)) * line(4:6)');
if any(isnan(points(:)))
  disp("miss");
else
  printf("%.17g %.17g %.17g\n", points(first, :));
end
