# Rscript --vanilla {}
# R's polyroot() for the textbook's rounded coefficients: the algorithm CPOLY. Debian: r-base-core. Source: ?polyroot. Returns
# complex roots in no promised order, and "due to rounding" no root is promised to be real: roots whose imaginary part is at most
# 1e-8 of their size count as real, the milder reading.
# raycheck returns roots
# raycheck root nearest
# raycheck tangent either
# raycheck level ordinary
input <- fifo("/dev/stdin", "r", blocking = TRUE)  # file("stdin") would wait for more than a line
while (length(line <- readLines(input, 1)) > 0) {
  x <- as.numeric(strsplit(line, " ")[[1]])
  f <- x[1:3] - x[7:9]
  d <- x[4:6]
  s <- polyroot(c(sum(f * f) - x[10]^2, 2 * sum(f * d), sum(d * d)))
  real <- length(s) == 2 && all(abs(Im(s)) <= 1e-8 * Mod(s))
  cat(if (real) sprintf("= %.17g %.17g\n", min(Re(s)), max(Re(s))) else "= miss\n")
}
