; Hit or miss if the line meets the sphere, disc = h^2 > 0. If c < 0, 0 lies between the roots; if c
; > 0, both roots have the sign of b. fast/internal/robust.h, and the decision in
; fast/internal/robust_guess.h.
(set-logic QF_NRA)
(declare-const a Real) (declare-const b Real) (declare-const c Real) (declare-const h Real)
(assert (and (> a 0) (> h 0) (= (* h h) (- (* b b) (* a c)))))
(declare-const smaller Real) (declare-const larger Real)
(assert (and (= (* a smaller) (- b h)) (= (* a larger) (+ b h))))
(assert (not (and (=> (< c 0) (and (< smaller 0) (> larger 0)))
                  (=> (and (> c 0) (> b 0)) (> smaller 0))
                  (=> (and (> c 0) (< b 0)) (< larger 0)))))
(check-sat)
