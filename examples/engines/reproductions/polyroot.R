# Rscript --vanilla case.R
f <- c({ox}, {oy}, {oz}) - c({cx}, {cy}, {cz})
d <- c({dx}, {dy}, {dz})
r <- {r}
s <- polyroot(c(sum(f * f) - r^2, 2 * sum(f * d), sum(d * d)))
real <- length(s) == 2 && all(abs(Im(s)) <= 1e-8 * Mod(s)) && any(Re(s) >= 0)
cat(if (real) sprintf("%.17g\n", min(Re(s)[Re(s) >= 0])) else "miss\n")
