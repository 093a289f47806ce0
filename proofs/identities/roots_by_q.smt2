; The roots of a s^2 - 2 b s + c = 0 without cancellation: c/q and q/a, where q = b + h, h^2 = b^2
; - a c. If b >= 0 and h > 0, they are the smaller and the larger root, (b - h)/a and (b + h)/a.
; fast/internal/robust.h and roots_by_q() in fast/internal/intersect_batch.h use this; for b < 0,
; with -b and the other sign of h.
(set-logic QF_NRA)
(declare-const a Real) (declare-const b Real) (declare-const c Real) (declare-const h Real)
(assert (and (> a 0) (>= b 0) (> h 0) (= (* h h) (- (* b b) (* a c)))))
(define-fun q () Real (+ b h))
(declare-const smaller Real) (declare-const larger Real)
(assert (and (= (* smaller q) c) (= (* larger a) q)))
(assert (not (and (= (* a smaller) (- b h)) (= (+ (- (* a larger larger) (* 2 b larger)) c) 0))))
(check-sat)
