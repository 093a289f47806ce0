; The errors of the components of h = f x g move |h|^2, which is at most (2 S)^2, by at most 4 S e +
; e^2, e = e1 + e2 + e3. This is the image filter's E for far spheres, without its roundings
; (reference/visibility/visibility_kernel.h).
(declare-const S Real)
(declare-const h1 Real) (declare-const h2 Real) (declare-const h3 Real)
(declare-const d1 Real) (declare-const d2 Real) (declare-const d3 Real)
(declare-const e1 Real) (declare-const e2 Real) (declare-const e3 Real)
(define-fun size ((x Real)) Real (ite (< x 0) (- x) x))
(define-fun moved ((h Real) (d Real)) Real (- (* (+ h d) (+ h d)) (* h h)))
(assert (and (<= (size d1) e1) (<= (size d2) e2) (<= (size d3) e3)))
(assert (and (<= (size h1) (* 2 S)) (<= (size h2) (* 2 S)) (<= (size h3) (* 2 S))))
; Component by component; e1^2 + e2^2 + e3^2 is at most e^2.
(assert (or (> (size (moved h1 d1)) (+ (* 4 S e1) (* e1 e1)))
            (> (size (moved h2 d2)) (+ (* 4 S e2) (* e2 e2)))
            (> (size (moved h3 d3)) (+ (* 4 S e3) (* e3 e3)))))
(check-sat)
