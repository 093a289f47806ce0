% octave-cli --quiet --no-history {}
% matGeom's intersectLineSphere in Octave, in doubles: "the two points which are the intersection of the given line and
% sphere", NaN for a miss. Debian: octave-matgeom. Source: its help text. Silent on tangents and on the order of the points;
% the adapter takes the first along the line. It does not mention its absolute tolerance, 1e-14.
% raycheck returns point
% raycheck root nearest
% raycheck tangent either
% raycheck level ordinary
% raycheck roots [] -inf inf absolute none
pkg load matgeom
while true
  try
    x = sscanf(input("", "s"), "%g")';  # fgetl would wait for more than a line
  catch
    break;  # the input ends
  end
  points = intersectLineSphere(x(1:6), x(7:10));
  if any(isnan(points(:)))
    disp("= miss");
  else
    [~, first] = min((points - x(1:3)) * x(4:6)');
    printf("= %.17g %.17g %.17g\n", points(first, :));
  end
  fflush(stdout);
end
