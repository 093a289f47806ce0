; A ray with |h| = H > 2 S is found to miss: if the components of h are off by e <= S/8 together, D =
; |h^| >= H - e, and r^2 a - D^2 is below -2 S^2 (reference/visibility/visibility_kernel.h).
(declare-const S Real) (declare-const H Real) (declare-const D Real) (declare-const e Real)
(declare-const ra Real)
(assert (and (> S 0) (> H (* 2 S)) (>= e 0) (<= e (/ S 8)) (>= D (- H e)) (<= ra (* 1.01 S S))))
(assert (>= (- ra (* D D)) (* (- 2) S S)))
(check-sat)
