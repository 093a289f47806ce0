; If disc^ is above 64 E, its root is off by at most 0.51 x, x = sqrt(E/64)
; (reference/visibility/visibility_kernel.h: kDecidedBeyond).
(declare-const d Real) (declare-const dh Real) (declare-const E Real)
(declare-const q Real) (declare-const qh Real) (declare-const x Real)
(assert (and (> E 0) (>= q 0) (>= qh 0) (> x 0)))
(assert (and (= d (* q q)) (= dh (* qh qh)) (= E (* 64 x x))))
(assert (and (> dh (* 64 E)) (<= (- E) (- dh d) E)))
(assert (or (> (- qh q) (* 0.51 x)) (> (- q qh) (* 0.51 x))))
(check-sat)
