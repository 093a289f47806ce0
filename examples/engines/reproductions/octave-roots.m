% octave-cli --quiet case.m
f = [{ox} {oy} {oz}] - [{cx} {cy} {cz}];
d = [{dx} {dy} {dz}];
r = {r};
s = roots([dot(d, d), 2 * dot(f, d), dot(f, f) - r^2]);
if isreal(s) && any(s >= 0)
  printf("%.17g\n", min(s(s >= 0)));
else
  disp("miss");
end
