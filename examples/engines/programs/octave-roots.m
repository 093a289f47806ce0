% octave-cli --quiet --no-history {}
% Octave's roots() for the textbook's rounded coefficients: eigenvalues of a companion matrix. Debian: octave. Source: its help
% text. Returns complex roots, in no promised order; roots with the imaginary part 0 are real.
% raycheck returns parameter
% raycheck root nearest
% raycheck tangent either
% raycheck level ordinary
while true
  try
    x = sscanf(input("", "s"), "%g")';  # fgetl would wait for more than a line
  catch
    break;  # the input ends
  end
  f = x(1:3) - x(7:9);
  d = x(4:6);
  s = roots([dot(d, d), 2 * dot(f, d), dot(f, f) - x(10)^2]);
  if isreal(s) && any(s >= 0)
    printf("= %.17g\n", min(s(s >= 0)));
  else
    disp("= miss");
  end
  fflush(stdout);
end
